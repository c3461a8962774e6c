// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Errors of the API as exceptions of Python. The text comes from rcDebugMessageCallbackRCX.
#include "core.h"

namespace raycore {
namespace {

PyObject *gError = nullptr;  // the class raycore.Error; lives as long as the module
thread_local std::string tMessage;

void RC_APIENTRY keepFirst(RCenum, RCenum, RCuint, RCenum, RCsizei length, const RCchar *message, const RCvoid *) {
  if (tMessage.empty()) tMessage.assign(message, static_cast<size_t>(length));
}

}  // namespace

void hearErrors() { rcDebugMessageCallbackRCX(keepFirst, nullptr); }

void throwIfFailed() {
  const RCenum error = rcGetError();
  if (error == RC_NO_ERROR) return;
  std::string message = std::exchange(tMessage, {});
  if (message.empty()) message = "no context is current; make one: with raycore.Context(800, 480): ...";
  const py::object exception = py::reinterpret_borrow<py::object>(gError)(message);
  exception.attr("code") = error;
  PyErr_SetObject(gError, exception.ptr());
  throw py::error_already_set();
}

std::string describe(const py::array &array) {
  return "shape " + std::string(py::str(array.attr("shape"))) + ", dtype " + std::string(py::str(array.dtype()));
}

py::array numbers(const py::object &object, const std::string &name) {
  const py::array array = py::array::ensure(object);
  if (!array) {
    PyErr_Clear();
    throw py::type_error(name + ": an array of numbers expected, got " + std::string(py::str(object.get_type())));
  }
  const char kind = array.dtype().kind();
  if (kind != 'f' && kind != 'i' && kind != 'u') {
    throw py::type_error(name + ": dtype float or int expected, got " + describe(array));
  }
  return array;
}

Array<float> floats(const py::object &object, const std::string &name, py::ssize_t columns) {
  const py::array array = numbers(object, name);
  if (array.ndim() != 2 || array.shape(1) != columns) {
    throw py::value_error(name + ": shape (n, " + std::to_string(columns) + ") expected, got " + describe(array));
  }
  return Array<float>(array);
}

std::vector<float> values(const py::object &object, const std::string &name) {
  const Array<float> array(numbers(object, name));
  return {array.data(), array.data() + array.size()};
}

void addErrors(py::module_ &module) {
  gError = PyErr_NewExceptionWithDoc(
      "raycore.Error", "A call failed: function, error, argument and what is allowed; `code` is the RC_* error.",
      PyExc_RuntimeError, nullptr);
  module.attr("Error") = py::reinterpret_borrow<py::object>(gError);
}

}  // namespace raycore
