// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "tutavia/any_algorithm.hpp"
#include "tutavia/core/expected.hpp"
#include "tutavia/grid/cell_costs.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/registry/algorithm_text.hpp"
#include "tutavia/space/cell_space.hpp"
#include "tutavia/space/lattice_space.hpp"

/// \file
/// Every algorithm of the library for both kinds of space.

namespace plan_program {

/// The searches and smoothers that work on spaces of type S: with default options, and by name with
/// options as texts.
template <class S>
struct Algorithms {
  template <class Any>
  using Make = tutavia::Expected<Any, tutavia::Failure> (*)(std::string_view,
                                                            std::span<const tutavia::OptionText>);

  std::vector<tutavia::AnySearch<S>> searches;
  std::vector<tutavia::AnySmoother<S>> smoothers;
  std::vector<tutavia::AnySearch<S>> vehicle_searches;     ///< not among the searches
  std::vector<tutavia::AnySmoother<S>> vehicle_smoothers;  ///< beside `none`
  Make<tutavia::AnySearch<S>> make_search;
  Make<tutavia::AnySmoother<S>> make_smoother;
};

/// Algorithms for workspaces. Each list has its own source file, because it takes longest to
/// compile.
const Algorithms<tutavia::LatticeSpace>& lattice_algorithms();

/// Algorithms for grid maps.
const Algorithms<tutavia::CellSpace>& cell_algorithms();

/// Whether a search takes the costs of cells.
bool takes_costs(std::string_view search);

/// A search on cells with costs. Errors: those of `make_search`; `invalid_option` if it takes none.
tutavia::Expected<tutavia::AnySearch<tutavia::CellSpace>, tutavia::Failure> make_search_with_costs(
    std::string_view search, std::span<const tutavia::OptionText> options,
    const std::shared_ptr<const tutavia::CellCosts>& costs);

}  // namespace plan_program
