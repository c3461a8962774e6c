// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// The module raycore._core.
#include "core.h"

PYBIND11_MODULE(_core, module) {
  module.doc() = "The RayCore API in C, checked; the package raycore is what programs import.";
  raycore::addErrors(module);
  raycore::addContext(module);
  raycore::addCalls(module);
  raycore::addParameters(module);
  raycore::addArrays(module);
  raycore::addImages(module);
}
