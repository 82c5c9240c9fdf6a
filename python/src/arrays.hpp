// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "tutavia/geometry/point.hpp"

/// \file
/// Points and tables of numbers from what Python users pass, and back.

namespace tutavia_python {

namespace py = pybind11;
using namespace tutavia;

using Numbers = py::array_t<double, py::array::c_style>;

/// A pair of numbers: a tuple, a list or an array of two. Raises InvalidInput, which names it.
Point to_point(py::handle value, const char* name);

/// The same, of finite numbers.
Point to_finite_point(py::handle value, const char* name);

/// A number. Raises InvalidInput.
double to_number(py::handle value, const char* name);

/// A whole number from 0 to `most`, also one of numpy. Raises InvalidOption.
std::uint64_t to_count(py::handle value, const char* name,
                       std::uint64_t most = std::numeric_limits<std::uint64_t>::max());

/// A number that may be None. Raises InvalidInput.
std::optional<double> to_optional_number(py::handle value, const char* name);

/// A real array of `columns` columns and any number of rows. Raises InvalidInput for other shapes
/// and for dtypes that are no real numbers.
Numbers to_table(py::handle value, py::ssize_t columns, const char* name);

/// A real array of one dimension with `rows` numbers. Raises InvalidInput.
Numbers to_column(py::handle value, py::ssize_t rows, const char* name);

/// Whether this is a number or an array without dimensions.
bool is_number(py::handle value);

/// A real array of one dimension. Raises InvalidInput, also for NaN.
Numbers to_column_without_nan(py::handle value, const char* name);

/// An array of shape (n,) or (n, 2), filled by `at(i)`.
template <class At>
Numbers make_column(std::size_t rows, const At& at) {
  Numbers array(static_cast<py::ssize_t>(rows));
  double* const data = array.mutable_data();
  for (std::size_t i = 0; i < rows; ++i) data[i] = at(i);
  return array;
}
template <class At>
Numbers make_points(std::size_t rows, const At& at) {
  Numbers array({static_cast<py::ssize_t>(rows), py::ssize_t{2}});
  double* const data = array.mutable_data();
  for (std::size_t i = 0; i < rows; ++i) {
    const Point& p = at(i);
    data[2 * i] = p.x();
    data[2 * i + 1] = p.y();
  }
  return array;
}

/// What the state of a pickle starts with.
struct PickleHead {
  py::tuple values;
  friend py::tuple operator+(const PickleHead& head, const py::tuple& state) {
    return py::reinterpret_steal<py::tuple>(PySequence_Concat(head.values.ptr(), state.ptr()));
  }
};
PickleHead pickle_head(const char* kind);

/// Raises InvalidInput for a state that is not of this kind and size, or that another version
/// wrote.
void check_pickle(const py::tuple& state, const char* kind, std::size_t size);

}  // namespace tutavia_python
