// SPDX-License-Identifier: MIT
#include "arrays.hpp"

#include <cmath>

#include "failures.hpp"

namespace tutavia_python {

namespace {

/// The version of what pickles hold. Raise it whenever the states of any class change.
constexpr int pickle_format = 2;

std::string text_of(py::handle value) {
  std::string text = py::repr(value);
  constexpr std::size_t longest = 80;
  return text.size() <= longest ? text : text.substr(0, longest) + "...";
}

[[noreturn]] void refuse(const char* name, const std::string& expected, py::handle found) {
  raise(PlanError::invalid_input,
        std::string(name) + ": expected " + expected + ", got " + text_of(found));
}

/// Forgets what a conversion raised, but not KeyboardInterrupt and its like.
void clear_error() {
  if (PyErr_Occurred() == nullptr) return;
  if (PyErr_ExceptionMatches(PyExc_Exception) == 0) throw py::error_already_set();
  PyErr_Clear();
}

bool read_number(PyObject* item, double& value) {
  value = PyFloat_AsDouble(item);
  if (value != -1.0 || PyErr_Occurred() == nullptr) return true;
  clear_error();
  return false;
}

std::string shape_of(const py::array& array) {
  return "shape " + std::string(py::str(array.attr("shape")));
}

/// The array, if its numbers are real ones.
py::array to_array(py::handle value, const char* name) {
  if (py::hasattr(value, "mask")) refuse(name, "an array without a mask", value);
  py::array array;
  try {
    array = py::array::ensure(value);
  } catch (py::error_already_set&) {
  }
  PyErr_Clear();
  if (!array) refuse(name, "an array of numbers", value);
  const char kind = array.dtype().kind();
  if (kind != 'f' && kind != 'i' && kind != 'u') {
    raise(PlanError::invalid_input, std::string(name) +
                                        ": expected an array of real numbers, got one of dtype " +
                                        std::string(py::str(array.dtype())));
  }
  return array;
}

Numbers to_doubles(const py::array& array) {
  return py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(array);
}

}  // namespace

Point to_point(py::handle value, const char* name) {
  constexpr const char* expected = "two numbers (x, y)";
  double x = 0, y = 0;
  PyObject* const pair = value.ptr();
  if (PyTuple_CheckExact(pair) || PyList_CheckExact(pair)) {
    const bool is_point = PySequence_Fast_GET_SIZE(pair) == 2 &&
                          read_number(PySequence_Fast_GET_ITEM(pair, 0), x) &&
                          read_number(PySequence_Fast_GET_ITEM(pair, 1), y);
    if (!is_point) refuse(name, expected, value);
    return {x, y};
  }
  const bool has_no_order = PyAnySet_Check(pair) || PyDict_Check(pair);
  if (PyUnicode_Check(pair) || PyBytes_Check(pair) || has_no_order) refuse(name, expected, value);
  const auto sequence = py::reinterpret_steal<py::object>(PySequence_Fast(pair, ""));
  clear_error();
  const bool is_point = sequence && PySequence_Fast_GET_SIZE(sequence.ptr()) == 2 &&
                        read_number(PySequence_Fast_GET_ITEM(sequence.ptr(), 0), x) &&
                        read_number(PySequence_Fast_GET_ITEM(sequence.ptr(), 1), y);
  if (!is_point) refuse(name, expected, value);
  return {x, y};
}

Point to_finite_point(py::handle value, const char* name) {
  const Point p = to_point(value, name);
  if (!p.allFinite()) refuse(name, "two finite numbers (x, y)", value);
  return p;
}

double to_number(py::handle value, const char* name) {
  double number = 0;
  if (!read_number(value.ptr(), number)) refuse(name, "a number", value);
  return number;
}

std::optional<double> to_optional_number(py::handle value, const char* name) {
  if (value.is_none()) return std::nullopt;
  double number = 0;
  if (!read_number(value.ptr(), number)) refuse(name, "a number or None", value);
  return number;
}

std::uint64_t to_count(py::handle value, const char* name, std::uint64_t most) {
  if (!PyBool_Check(value.ptr())) {
    const auto number = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
    const std::uint64_t count = number ? PyLong_AsUnsignedLongLong(number.ptr()) : 0;
    const bool is_read = number && PyErr_Occurred() == nullptr;
    clear_error();
    if (is_read && count <= most) return count;
  }
  raise(PlanError::invalid_option, std::string(name) + ": expected a whole number from 0 to " +
                                       std::to_string(most) + ", got " + text_of(value));
}

Numbers to_table(py::handle value, py::ssize_t columns, const char* name) {
  const py::array array = to_array(value, name);
  if (array.ndim() == 1 && array.size() == 0) return Numbers(std::vector<py::ssize_t>{0, columns});
  if (array.ndim() != 2 || array.shape(1) != columns) {
    raise(PlanError::invalid_input, std::string(name) + ": expected an array of shape (n, " +
                                        std::to_string(columns) + "), got " + shape_of(array));
  }
  return to_doubles(array);
}

bool is_number(py::handle value) {
  if (PyFloat_Check(value.ptr()) || PyLong_Check(value.ptr())) return true;
  if (PyNumber_Check(value.ptr()) == 0) return false;
  const py::array array = py::array::ensure(value);  // tables may call themselves numbers
  clear_error();
  return array && array.ndim() == 0;
}

Numbers to_column_without_nan(py::handle value, const char* name) {
  const py::array array = to_array(value, name);
  if (array.ndim() != 1) {
    raise(PlanError::invalid_input,
          std::string(name) + ": expected an array of shape (n,), got " + shape_of(array));
  }
  Numbers numbers = to_doubles(array);
  for (py::ssize_t i = 0; i < numbers.size(); ++i) {
    if (!std::isnan(numbers.at(i))) continue;
    raise(PlanError::invalid_input, std::string(name) + "[" + std::to_string(i) + "] is nan");
  }
  return numbers;
}

Numbers to_column(py::handle value, py::ssize_t rows, const char* name) {
  const py::array array = to_array(value, name);
  if (array.ndim() != 1 || array.shape(0) != rows) {
    raise(PlanError::invalid_input, std::string(name) + ": expected an array of shape (" +
                                        std::to_string(rows) + ",), got " + shape_of(array));
  }
  return to_doubles(array);
}

PickleHead pickle_head(const char* kind) {
  return {py::make_tuple(kind, pickle_format,
                         py::module_::import("tutavia._native").attr("__version__"))};
}

void check_pickle(const py::tuple& state, const char* kind, std::size_t size) {
  const py::tuple head = pickle_head(kind).values;
  const bool is_known = state.size() >= 3 && state[0].equal(head[0]);
  if (!is_known) raise(PlanError::invalid_input, std::string("this is no pickle of a ") + kind);
  if (!state[1].equal(head[1]) || !state[2].equal(head[2]) || state.size() != size) {
    raise(PlanError::invalid_input,
          std::string("the pickle of this ") + kind + " is from tutavia " +
              std::string(py::str(state[2])) + " (format " + std::string(py::str(state[1])) +
              "), this is tutavia " + std::string(py::str(head[2])) + " (format " +
              std::to_string(pickle_format) + "): install the same version in both processes");
  }
}

}  // namespace tutavia_python
