// SPDX-License-Identifier: MIT
/// \file
/// Dubins and Reeds-Shepp words between random poses: lengths and times beside OMPL's.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "program.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/geometry/dubins.hpp"
#include "tutavia/geometry/reeds_shepp.hpp"

#ifdef TUTAVIA_WITH_OMPL
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#endif

namespace {

using namespace tutavia;
using bench::Clock;
using bench::micros_since;

struct Arguments {
  std::size_t pairs = 100000;
  std::uint64_t seed = 1;
};

struct PosePair {
  Pose from, to;
};

/// Poses in squares of 0.1 to 100 turning radii.
std::vector<PosePair> random_pairs(const Arguments& args) {
  Random random(args.seed);
  std::vector<PosePair> pairs(args.pairs);
  for (PosePair& pair : pairs) {
    const double reach = 0.5 * std::pow(10, random.uniform(-1, 2));
    for (Pose* pose : {&pair.from, &pair.to}) {
      const double x = random.uniform(-reach, reach), y = random.uniform(-reach, reach);
      *pose = {{x, y}, random.uniform(-std::numbers::pi, std::numbers::pi)};
    }
  }
  return pairs;
}

double dubins_length(const PosePair& p) { return dubins_word(p.from, p.to, 1).length(); }
double reeds_shepp_word_length(const PosePair& p) {
  return reeds_shepp_word(p.from, p.to, 1).length();
}
double shortest_length(const PosePair& p) { return reeds_shepp_length(p.from, p.to, 1); }

/// Nanoseconds per call: the least of five rounds.
template <class Call>
double nanoseconds(std::size_t count, const Call& call) {
  double least = std::numeric_limits<double>::infinity();
  volatile double sum = 0;  // keeps the calls
  for (int round = 0; round < 5; ++round) {
    const auto start = Clock::now();
    double total = 0;
    for (std::size_t i = 0; i < count; ++i) total += call(i);
    sum = sum + total;
    least = std::min(least, 1000 * micros_since(start) / static_cast<double>(count));
  }
  return least;
}

template <class Length>
void print_time(const char* label, const std::vector<PosePair>& pairs, const Length& length) {
  const auto call = [&](std::size_t i) { return length(pairs[i]); };
  std::printf("  %-20s %7.0f ns per call\n", label, nanoseconds(pairs.size(), call));
}

#ifdef TUTAVIA_WITH_OMPL

namespace ob = ompl::base;

/// Lengths differ if they do by more than this share.
constexpr double tolerance = 1e-9;

/// The distance from `to` at which moves end that start at `from`, with turns of radius 1.
double miss(const SteeringWord& word, const Pose& from, const Pose& to) {
  double x = from.position.x(), y = from.position.y(), heading = from.heading;
  for (std::size_t i = 0; i < word.size; ++i) {
    const double length = word.moves[i].length, side = static_cast<double>(word.moves[i].steering);
    if (word.moves[i].steering == Steering::straight) {
      x += length * std::cos(heading);
      y += length * std::sin(heading);
    } else {
      const double next = heading + side * length;
      x += side * (std::sin(next) - std::sin(heading));
      y -= side * (std::cos(next) - std::cos(heading));
      heading = next;
    }
  }
  const double turn = std::remainder(heading - to.heading, 2 * std::numbers::pi);
  return std::hypot(x - to.position.x(), y - to.position.y()) + std::abs(turn);
}

/// OMPL's words, move by move.
SteeringWord word_of(const ob::DubinsStateSpace::DubinsPath& path) {
  SteeringWord word;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto type = path.type_[i];
    word.push_back({type == ob::DubinsStateSpace::DUBINS_LEFT       ? Steering::left
                    : type == ob::DubinsStateSpace::DUBINS_STRAIGHT ? Steering::straight
                                                                    : Steering::right,
                    path.length_[i]});
  }
  return word;
}
SteeringWord word_of(const ob::ReedsSheppStateSpace::ReedsSheppPath& path) {
  SteeringWord word;
  for (std::size_t i = 0; i < 5; ++i) {
    const auto type = path.type_[i];
    if (type == ob::ReedsSheppStateSpace::RS_NOP) continue;
    word.push_back({type == ob::ReedsSheppStateSpace::RS_LEFT       ? Steering::left
                    : type == ob::ReedsSheppStateSpace::RS_STRAIGHT ? Steering::straight
                                                                    : Steering::right,
                    path.length_[i]});
  }
  return word;
}

SteeringWord peer_word(const ob::DubinsStateSpace& space, const ob::State* a, const ob::State* b) {
  return word_of(space.dubins(a, b));
}
SteeringWord peer_word(const ob::ReedsSheppStateSpace& space, const ob::State* a,
                       const ob::State* b) {
  return word_of(space.reedsShepp(a, b));
}

/// How often one length is longer than the other, and the worst pair.
struct Difference {
  std::size_t count = 0;
  double largest = 0;
  PosePair worst{};

  void add(double difference, const PosePair& pair) {
    ++count;
    if (difference <= largest) return;
    largest = difference;
    worst = pair;
  }
  void print(const char* label) const {
    std::printf("  %s: %zu", label, count);
    if (count > 0) {
      const auto& [a, b] = worst;
      std::printf(", most by %.2g: (%.17g, %.17g, %.17g) to (%.17g, %.17g, %.17g)", largest,
                  a.position.x(), a.position.y(), a.heading, b.position.x(), b.position.y(),
                  b.heading);
    }
    std::puts("");
  }
};

/// Whether no length is longer than that of an OMPL word that reaches the goal.
template <class Space, class Length>
bool compare(const std::vector<PosePair>& pairs, const Length& length) {
  const auto space = std::make_shared<Space>(1.0);
  using State = ob::ScopedState<ob::SE2StateSpace>;
  std::vector<std::pair<State, State>> states;
  for (const PosePair& pair : pairs) {
    states.emplace_back(State(space), State(space));
    const auto set = [](State& state, const Pose& pose) {
      state->setXY(pose.position.x(), pose.position.y());
      state->setYaw(pose.heading);
    };
    set(states.back().first, pair.from);
    set(states.back().second, pair.to);
  }
  const auto peer_length = [&](std::size_t i) {
    return space->distance(states[i].first.get(), states[i].second.get());
  };
  double largest = 0;
  Difference longer, shorter, missed;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const PosePair& pair = pairs[i];
    const double theirs = peer_length(i), difference = (length(pair) - theirs) / theirs;
    const SteeringWord word = peer_word(*space, states[i].first.get(), states[i].second.get());
    if (const double by = miss(word, pair.from, pair.to); by > tolerance) {
      missed.add(by, pair);
      continue;
    }
    largest = std::max(largest, std::abs(difference));
    if (difference > tolerance) longer.add(difference, pair);
    if (difference < -tolerance) shorter.add(-difference, pair);
  }
  std::printf("  largest relative difference from OMPL: %.2g\n", largest);
  longer.print("longer than OMPL's");
  shorter.print("shorter than OMPL's");
  missed.print("not compared, OMPL's word misses the goal");
  std::printf("  %-20s %7.0f ns per call\n", "OMPL", nanoseconds(pairs.size(), peer_length));
  return longer.count == 0;
}

#endif

int run(const Arguments& args) {
  const std::vector<PosePair> pairs = random_pairs(args);
  std::printf("%zu pairs of poses in squares of 0.1 to 100 radii, seed %llu\n", pairs.size(),
              static_cast<unsigned long long>(args.seed));
  bool never_longer = true;
  std::puts("Dubins");
  print_time("dubins_word", pairs, dubins_length);
#ifdef TUTAVIA_WITH_OMPL
  never_longer = compare<ob::DubinsStateSpace>(pairs, dubins_length) && never_longer;
#endif
  std::puts("Reeds-Shepp");
  print_time("reeds_shepp_word", pairs, reeds_shepp_word_length);
  print_time("reeds_shepp_length", pairs, shortest_length);
#ifdef TUTAVIA_WITH_OMPL
  never_longer = compare<ob::ReedsSheppStateSpace>(pairs, shortest_length) && never_longer;
#else
  std::puts("built without OMPL (libompl-dev): nothing to compare with");
#endif
  return never_longer ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments args;
  CLI::App app("Dubins and Reeds-Shepp words, beside OMPL's", "tutavia-bench-steering");
  app.add_option("--pairs", args.pairs, "Pairs of random poses")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  app.add_option("--seed", args.seed, "Of the poses")->capture_default_str();
  return bench::run_program(app, argc, argv, [&] { return run(args); });
}
