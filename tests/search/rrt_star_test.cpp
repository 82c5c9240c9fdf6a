// SPDX-License-Identifier: MIT
#include "tutavia/search/rrt_star.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "support/scale.hpp"
#include "support/tree_contract.hpp"
#include "tutavia/certify/certify.hpp"
#include "tutavia/search/rrt.hpp"
#include "tutavia/search/tangent_graph.hpp"
#include "tutavia/world/maps.hpp"

namespace {

using namespace tutavia;

TEST_CASE("RrtStar keeps the contracts of searchers and of trees, by either rule", "[soak]") {
  test::tree_contract(RrtStar{}, 0xd039bc3e07348d86);
  test::tree_contract(RrtStar{.neighbours = Neighbours::radius}, 0xcd3386779b325701);
}

TEST_CASE("neighbour rules are those of Karaman and Frazzoli") {
  const detail::NeighbourRule rule{Neighbours::radius, 1};
  CHECK(rule.count(1000) == 29);  // 4.0774 * 6.9078 = 28.17
  CHECK(rule.radius(1000, 2500, 50) ==
        Approx(2 * std::sqrt(1.5) * std::sqrt(2500 / 3.141592653589793) *
               std::sqrt(std::log(1000) / 1000)));
  CHECK(rule.radius(1000, 2500, 2) == 2);
  CHECK(rule.count(1) == 1);
  CHECK(detail::NeighbourRule{Neighbours::k_nearest, 1e300}.count(50) == 50);
}

double median_ratio(std::uint32_t iterations, const Scene& scene, Neighbours neighbours) {
  const auto space = InflatedSpace::build(scene.workspace).value();
  Query query{.start = scene.start, .goal = scene.goals[0]};
  NoObserver no_observer;
  TangentGraph::Scratch tangents;
  const double optimum = TangentGraph{}.search(space, query, tangents, no_observer)->cost;
  RrtStar::Scratch scratch;
  std::vector<double> ratios;
  for (query.seed = 1; query.seed <= 5; ++query.seed) {
    const RrtStar search{.max_iterations = iterations, .neighbours = neighbours};
    ratios.push_back(search.search(space, query, scratch, no_observer)->cost / optimum);
    CHECK(ratios.back() >= 1 - 1e-9);
  }
  std::sort(ratios.begin(), ratios.end());
  return ratios[2];
}

TEST_CASE("paths become shorter with more iterations, and almost the shortest there are") {
  for (Scene scene : {maps::rrt_scene_1(), maps::rrt_scene_2()}) {
    INFO(scene.name);
    scene.workspace.safety_radius = 1;
    for (const Neighbours rule : {Neighbours::k_nearest, Neighbours::radius}) {
      const double few = median_ratio(1000, scene, rule), more = median_ratio(4000, scene, rule),
                   many = median_ratio(12000, scene, rule);
      CHECK(more < few);
      CHECK(many < more);
      CHECK(many < 1.01);
    }
  }
}

/// RRT* as it is printed: looks at every node, tests every candidate in the order of their numbers.
class PlainRrtStar {
 public:
  PlainRrtStar(const InflatedSpace& space, const Query& query, double step)
      : space_(space), query_(query), step_(step), random_(query.seed) {
    nodes_.push_back({query.start, 0, 0, detail::SearchTree::none});
  }

  void run(int iterations) {
    const Box& b = space_.bounds();
    for (int i = 0; i < iterations; ++i) {
      const bool towards_goal = goal_ == detail::SearchTree::none && random_.uniform() < 0.05;
      Point target = query_.goal;
      if (!towards_goal) {
        target.x() = random_.uniform(b.min.x(), b.max.x());
        target.y() = random_.uniform(b.min.y(), b.max.y());
      }
      const auto nearest = by_distance(target)[0];
      const Point from = nodes_[nearest].place, end = detail::steer(from, target, step_);
      if (end == from || !space_.segment_free(from, end)) continue;
      insert(end, nearest);
      const auto last = static_cast<detail::SearchTree::Node>(nodes_.size() - 1);
      if (end == query_.goal) {
        goal_ = last;
      } else if (goal_ == detail::SearchTree::none && distance(end, query_.goal) <= step_ &&
                 space_.segment_free(end, query_.goal)) {
        insert(query_.goal, last);
        goal_ = last + 1;
      }
    }
  }

  void check_same(const detail::SearchTree& tree) const {
    REQUIRE(tree.size() == nodes_.size());
    std::size_t different = 0;
    for (detail::SearchTree::Node i = 0; i < tree.size(); ++i) {
      if (tree.position(i) != nodes_[i].place || tree.parent(i) != nodes_[i].parent ||
          tree.cost(i) != nodes_[i].cost) {
        ++different;
      }
    }
    CHECK(different == 0);
  }

 private:
  struct Node {
    Point place;
    double cost, edge;
    detail::SearchTree::Node parent;
  };

  std::vector<detail::SearchTree::Node> by_distance(const Point& p) const {
    std::vector<std::pair<double, detail::SearchTree::Node>> order;
    for (detail::SearchTree::Node i = 0; i < nodes_.size(); ++i) {
      const double dx = nodes_[i].place.x() - p.x(), dy = nodes_[i].place.y() - p.y();
      order.push_back({dx * dx + dy * dy, i});
    }
    std::sort(order.begin(), order.end());
    std::vector<detail::SearchTree::Node> nodes;
    for (const auto& [square, node] : order) nodes.push_back(node);
    return nodes;
  }

  void insert(const Point& p, detail::SearchTree::Node parent) {
    auto near = by_distance(p);
    const double n = static_cast<double>(std::max<std::size_t>(nodes_.size(), 2));
    const double k = std::ceil(1.1 * 1.5 * std::exp(1.0) * std::log(n));
    near.resize(std::min(near.size(), static_cast<std::size_t>(k)));
    std::sort(near.begin(), near.end());
    Node added{p, 0, distance(nodes_[parent].place, p), parent};
    added.cost = nodes_[parent].cost + added.edge;
    for (const auto i : near) {
      const double edge = distance(nodes_[i].place, p);
      if (nodes_[i].cost + edge < added.cost && space_.segment_free(nodes_[i].place, p)) {
        added = {p, nodes_[i].cost + edge, edge, i};
      }
    }
    const auto number = static_cast<detail::SearchTree::Node>(nodes_.size());
    nodes_.push_back(added);
    for (const auto i : near) {
      const double edge = distance(nodes_[i].place, p);
      if (!(added.cost + edge < nodes_[i].cost) || !space_.segment_free(p, nodes_[i].place)) {
        continue;
      }
      nodes_[i] = {nodes_[i].place, added.cost + edge, edge, number};
      update_children(i);
    }
  }

  void update_children(detail::SearchTree::Node node) {
    for (detail::SearchTree::Node i = 1; i < nodes_.size(); ++i) {
      if (nodes_[i].parent != node) continue;
      nodes_[i].cost = nodes_[node].cost + nodes_[i].edge;
      update_children(i);
    }
  }

  const InflatedSpace& space_;
  Query query_;
  double step_;
  Random random_;
  std::vector<Node> nodes_;
  detail::SearchTree::Node goal_ = detail::SearchTree::none;
};

TEST_CASE("the tree is that of RRT* as it is printed, to the bit", "[soak]") {
  for (const Scene& scene : test::sampling_scenes()) {
    const auto space = InflatedSpace::build(scene.workspace).value();
    const double step = detail::default_step(space.bounds());
    for (std::uint64_t seed = 1; seed <= test::scaled(3); ++seed) {
      INFO(scene.name << ", seed " << seed);
      const Query query{.start = scene.start, .goal = scene.goals[0], .seed = seed};
      RrtStar::Scratch scratch;
      NoObserver no_observer;
      static_cast<void>(RrtStar{.max_iterations = 1000}.search(space, query, scratch, no_observer));
      PlainRrtStar plain(space, query, step);
      plain.run(1000);
      plain.check_same(scratch.tree);
    }
  }
}

TEST_CASE("at the end of its budget RrtStar gives the best path it has") {
  const Scene scene = maps::maze();
  const auto space = InflatedSpace::build(scene.workspace).value();
  Query query{.start = scene.start, .goal = scene.goals[0]};
  RrtStar::Scratch scratch;
  NoObserver no_observer;
  const RrtStar endless{.max_iterations = 4000000000u};
  query.budget.max_expansions = 3000;
  const auto limited = endless.search(space, query, scratch, no_observer);
  REQUIRE(limited);
  CHECK(limited->stats.expanded == 3000);
  query.budget = {};
  CHECK(test::same_curve(limited->curve,
                         RrtStar{}.search(space, query, scratch, no_observer)->curve));
  query.budget = Budget::for_seconds(0.05);
  const auto in_time = endless.search(space, query, scratch, no_observer);
  REQUIRE(in_time);
  CHECK(certify(space, in_time->curve).status == ProofStatus::proved);
  query.budget.max_expansions = 10;
  CHECK(endless.search(space, query, scratch, no_observer).error().code ==
        PlanError::budget_exhausted);
}

/// Asks to stop when the first path is found.
struct StopAtFirst : NoObserver {
  std::stop_source source;
  void improved(const Curve&, double) { source.request_stop(); }
};

TEST_CASE("a search that is cancelled has no path, even if it found one") {
  const Scene scene = maps::maze();
  const auto space = InflatedSpace::build(scene.workspace).value();
  StopAtFirst observer;
  Query query{.start = scene.start, .goal = scene.goals[0]};
  query.budget.stop = observer.source.get_token();
  RrtStar::Scratch scratch;
  const auto route = RrtStar{.max_iterations = 100000}.search(space, query, scratch, observer);
  REQUIRE_FALSE(route);
  CHECK(route.error().code == PlanError::cancelled);
  CHECK(route.error().stats.expanded < 20000);
}

}  // namespace
