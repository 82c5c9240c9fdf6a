// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>
#include <vector>

#include <pybind11/stl.h>

#include "bindings.hpp"
#include "plan/registry.hpp"
#include "tutavia/registry.hpp"
#include "tutavia/registry/nearest_name.hpp"

/// \file
/// The registry's tables for Python.

namespace tutavia_python {

namespace {

using namespace tutavia;

py::list options_of(const AlgorithmDescription& algorithm) {
  py::list options;
  for (const OptionDescription& option : algorithm.options) {
    options.append(py::make_tuple(option.name, option.type, option.unit, option.default_value,
                                  option.sentence));
  }
  return options;
}

template <class Any>
bool has(const std::vector<Any>& algorithms, const std::string& name) {
  return std::any_of(algorithms.begin(), algorithms.end(),
                     [&](const Any& algorithm) { return algorithm.name == name; });
}

}  // namespace

void bind_descriptions(py::module_& m) {
  using namespace pybind11::literals;
  // (name, sentence, works on a LatticeSpace, on a CellSpace, options)
  m.def("_describe_searches", [] {
    const auto& lattice = plan_program::lattice_algorithms();
    const auto& cells = plan_program::cell_algorithms();
    py::list all;
    for (const AlgorithmDescription& search : describe_searches()) {
      const bool is_vehicle = has(lattice.vehicle_searches, search.name);
      all.append(py::make_tuple(
          search.name, search.sentence, is_vehicle || has(lattice.searches, search.name),
          is_vehicle || has(cells.searches, search.name), options_of(search)));
    }
    return all;
  });
  m.def("_describe_smoothers", [] {
    const auto& lattice = plan_program::lattice_algorithms();
    const auto& cells = plan_program::cell_algorithms();
    py::list all;
    for (const AlgorithmDescription& smoother : describe_smoothers()) {
      const bool is_vehicle = has(lattice.vehicle_smoothers, smoother.name);
      all.append(py::make_tuple(
          smoother.name, smoother.sentence, is_vehicle || has(lattice.smoothers, smoother.name),
          is_vehicle || has(cells.smoothers, smoother.name), options_of(smoother)));
    }
    return all;
  });
  m.def(
      "_nearest_name",
      [](const std::string& word, const std::vector<std::string>& names) {
        return tutavia::nearest_name(word, names);
      },
      "word"_a, "names"_a);
}

}  // namespace tutavia_python
