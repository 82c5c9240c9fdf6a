// SPDX-License-Identifier: MIT
#include "tutavia/registry/options/bound_option.hpp"

#include <string>
#include <vector>

#include "support/catch.hpp"
#include "tutavia/registry.hpp"

namespace tutavia::detail {

namespace {

/// A text that is not the value of an option, and that its type knows.
std::string other_text(const BoundOption& option) {
  const OptionKind& kind = *option.field->kind;
  const std::string now = to_text(option.value());
  if (kind.type == OptionKind::Type::choice) {
    return std::string(now == kind.names.front() ? kind.names.back() : kind.names.front());
  }
  if (kind.type == OptionKind::Type::whole_number) return now == "17" ? "18" : "17";
  return now == "0.1234567890123" ? "4.5" : "0.1234567890123";
}

/// Sets each option alone. Returns the number of options.
template <class A>
std::size_t set_each() {
  INFO(A::name);
  A algorithm{};
  const auto options = bind_options(&algorithm, OptionTable<A>::fields.all);
  for (std::size_t i = 0; i < options.size(); ++i) {
    A changed{};
    const auto bound = bind_options(&changed, OptionTable<A>::fields.all);
    const std::string text = other_text(bound[i]);
    INFO(bound[i].name << "=" << text);
    const std::vector<OptionText> texts{{bound[i].name, text}};
    REQUIRE(set_options(A::name, bound, texts));
    for (std::size_t j = 0; j < bound.size(); ++j) {
      CHECK(to_text(bound[j].value()) == (i == j ? text : to_text(options[j].value())));
    }
  }
  return options.size();
}

template <class... A>
std::size_t set_all(AlgorithmList<A...>) {
  return (std::size_t{0} + ... + set_each<A>());
}

TEST_CASE("every option of every algorithm can be set, alone, and read back") {
  CHECK(set_all(Searches{}) > 30);
  CHECK(set_all(Smoothers{}) > 15);
}

TEST_CASE("texts set the members that they name") {
  RrtStar tree;
  const std::vector<OptionText> texts{
      {"max_iterations", "5000"}, {"goal_bias", "0.1"}, {"step", "0.25"}, {"neighbours", "radius"}};
  REQUIRE(set_options("rrt_star", bind_options(&tree, OptionTable<RrtStar>::fields.all), texts));
  CHECK(tree.max_iterations == 5000);
  CHECK(tree.goal_bias == 0.1);
  CHECK(tree.step == 0.25);
  CHECK(tree.neighbours == Neighbours::radius);
  CHECK(tree.rewire_factor == RrtStar{}.rewire_factor);

  SsaAStar ssa;
  const std::vector<OptionText> nested{{"weights.density", "0.5"}};
  REQUIRE(set_options("ssa_astar", bind_options(&ssa, OptionTable<SsaAStar>::fields.all), nested));
  CHECK(ssa.weights.density == 0.5);
  CHECK(ssa.weights.chebyshev == SsaAStar{}.weights.chebyshev);
}

template <class A>
std::string refused(const std::vector<OptionText>& texts) {
  A algorithm{};
  const auto set =
      set_options(A::name, bind_options(&algorithm, OptionTable<A>::fields.all), texts);
  REQUIRE_FALSE(set);
  CHECK(set.error().code == PlanError::invalid_option);
  return set.error().detail;
}

TEST_CASE("what cannot be set is named, with what was expected and the nearest option") {
  CHECK(refused<RrtStar>({{"iteration", "5"}}) ==
        "rrt_star: unknown option \"iteration\"; did you mean max_iterations?");
  CHECK(refused<RrtStar>({{"iterations", "5"}}) ==
        "rrt_star: unknown option \"iterations\"; did you mean max_iterations?");
  CHECK(refused<RrtStar>({{"zzz", "5"}}) ==
        "rrt_star: unknown option \"zzz\"; known: step goal_bias max_iterations neighbours "
        "rewire_factor");
  CHECK(refused<Jps>({{"weight", "5"}}) == "jps: unknown option \"weight\"; there are none");
  CHECK(refused<AStar>({{"costs", "5"}}) ==
        "astar: unknown option \"costs\"; known: heuristic successors");
  CHECK(refused<SsaAStar>({{"weights", "5"}}).find("unknown option \"weights\"") !=
        std::string::npos);
  CHECK(refused<RrtStar>({{"max_iterations", "many"}}) ==
        "rrt_star: max_iterations: expected a whole number from 0 to 4294967295, got \"many\"");
  CHECK(refused<RrtStar>({{"max_iterations", ""}}) ==
        "rrt_star: max_iterations: expected a whole number from 0 to 4294967295, got \"\"");
  CHECK(refused<RrtStar>({{"goal_bias", "nan"}}) ==
        "rrt_star: goal_bias: expected a number, got \"nan\"");
  CHECK(refused<RrtStar>({{"step", "x"}}) ==
        "rrt_star: step: expected a number or none, got \"x\"");
  CHECK(refused<DeltaSmoother>({{"join", "glue"}}) ==
        "delta: join: expected paper or tangent, got \"glue\"");
  CHECK(refused<SafeRrtStar>({{"prune", "1"}}) ==
        "safe_rrt_star: prune: expected false or true, got \"1\"");
  CHECK(refused<RrtStar>({{"max_iterations", "5"}, {"step", "1"}, {"max_iterations", "5"}}) ==
        "rrt_star: option \"max_iterations\" is given twice");
}

TEST_CASE("a setter keeps all options, set or not") {
  const std::vector<OptionText> texts{{"fullness", "0.5"}};
  OptionSetter setter("bezier", OptionTable<BezierSmoother>::fields.all, texts);
  BezierSmoother bezier;
  setter.set(&bezier);
  CHECK(setter.result());
  REQUIRE(setter.settings().size() == 2);
  CHECK(setter.settings()[0].name == "trim");
  CHECK(std::get<double>(setter.settings()[0].value) == BezierSmoother{}.trim);
  CHECK(setter.settings()[1].name == "fullness");
  CHECK(std::get<double>(setter.settings()[1].value) == 0.5);
}

}  // namespace

}  // namespace tutavia::detail
