// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// core.h: what the files of the Python module share. Each registers a family of functions; all of them check for
// errors the same way and take arrays the same way.
#pragma once

#include <RC/rcu.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <string>
#include <vector>

namespace py = pybind11;

namespace raycore {

void addErrors(py::module_ &module);
void addContext(py::module_ &module);
void addCalls(py::module_ &module);
void addParameters(py::module_ &module);
void addArrays(py::module_ &module);
void addImages(py::module_ &module);

// ---- errors ----------------------------------------------------------------------------------------------------

// Contexts of Python tell their errors here; throwIfFailed makes exceptions of them.
void hearErrors();
// Throws raycore.Error if a call since the last one failed.
void throwIfFailed();

// A function of the API as one of Python: the same arguments, an exception instead of a pending error.
template <class Result, class... Arguments, class... Extra>
void define(py::module_ &module, const char *name, Result (*function)(Arguments...), const Extra &...extra) {
  module.def(
      name,
      [function](Arguments... arguments) -> Result {
        if constexpr (std::is_void_v<Result>) {
          function(arguments...);
          throwIfFailed();
        } else {
          const Result result = function(arguments...);
          throwIfFailed();
          return result;
        }
      },
      extra...);
}

// ---- arrays ----------------------------------------------------------------------------------------------------

template <class Value>
using Array = py::array_t<Value, py::array::c_style | py::array::forcecast>;

// "shape (4, 2), dtype float64"
std::string describe(const py::array &array);

// The object as an array of numbers of any type; TypeError: "vertices: numbers expected, got dtype object".
py::array numbers(const py::object &object, const std::string &name);

// The object as packed floats of shape (n, columns); ValueError: "vertices: shape (n, 3) expected, got shape (4, 2)
// ...".
Array<float> floats(const py::object &object, const std::string &name, py::ssize_t columns);

// A number or a sequence of numbers.
std::vector<float> values(const py::object &object, const std::string &name);

// ---- contexts --------------------------------------------------------------------------------------------------

// The arrays of a context that is gone are let go.
void forgetArrays(void *context);

}  // namespace raycore
