// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// error.h: how a check inside an egl* function says that it failed. [EGL 1.5, 3.1]
#pragma once

#include <EGL/egl.h>

namespace rc::egl {

// Thrown inside a call, never out of it: the error code of a check that failed.
struct EglError {
  EGLint code;
};

inline void require(bool condition, EGLint code) {
  if (!condition) throw EglError{code};
}

}  // namespace rc::egl
