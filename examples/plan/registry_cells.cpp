// SPDX-License-Identifier: MIT
#include "tutavia/registry.hpp"

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "registry.hpp"

namespace plan_program {

const Algorithms<tutavia::CellSpace>& cell_algorithms() {
  using Space = tutavia::CellSpace;
  static const Algorithms<Space> all{
      tutavia::all_searches<Space>(),     tutavia::all_smoothers<Space>(),
      tutavia::vehicle_searches<Space>(), tutavia::vehicle_smoothers<Space>(),
      &tutavia::make_search<Space>,       &tutavia::make_smoother<Space>};
  return all;
}

namespace {

using tutavia::AStar;
using tutavia::AutoSearch;
using tutavia::CellSpace;
using tutavia::Dijkstra;
using tutavia::Failure;

template <class A>
tutavia::Expected<tutavia::AnySearch<CellSpace>, Failure> with_costs(
    std::span<const tutavia::OptionText> options,
    const std::shared_ptr<const tutavia::CellCosts>& costs) {
  A search{};
  tutavia::detail::OptionSetter setter(A::name, tutavia::detail::OptionTable<A>::fields.all,
                                       options);
  setter.set(&search);
  if (!setter.result()) return tutavia::Unexpected{setter.result().error()};
  search.costs = costs;
  auto any = tutavia::erase_search<CellSpace>(search);
  any.options = setter.settings();
  return any;
}

}  // namespace

bool takes_costs(std::string_view search) {
  return search == AutoSearch::name || search == AStar::name || search == Dijkstra::name;
}

tutavia::Expected<tutavia::AnySearch<CellSpace>, Failure> make_search_with_costs(
    std::string_view search, std::span<const tutavia::OptionText> options,
    const std::shared_ptr<const tutavia::CellCosts>& costs) {
  if (search == AutoSearch::name && options.empty()) return with_costs<AStar>(options, costs);
  if (search == AStar::name) return with_costs<AStar>(options, costs);
  if (search == Dijkstra::name) return with_costs<Dijkstra>(options, costs);
  return tutavia::fail(tutavia::PlanError::invalid_option,
                       std::string(search) + ": takes no costs of cells");
}

}  // namespace plan_program
