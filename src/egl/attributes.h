// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// attributes.h: attribute lists of both widths, EGLint and EGLAttrib, read pair by pair. [EGL 1.5, 2.1]
#pragma once

#include <EGL/egl.h>

#include <algorithm>
#include <limits>

namespace rc::egl {

// A null list is an empty one. A value is not touched before it is asked for: lists with an unknown name may end there.
class Attributes {
 public:
  explicit Attributes(const EGLint *list) : mNarrow(list) {}
  explicit Attributes(const EGLAttrib *list) : mWide(list) {}

  bool more() const { return (mNarrow && *mNarrow != EGL_NONE) || (mWide && *mWide != EGL_NONE); }
  EGLAttrib name() const { return at(0); }
  EGLAttrib value() const { return at(1); }
  // For attributes that are numbers: what does not fit is as large as it can be, which no attribute allows.
  EGLint number() const {
    using Limits = std::numeric_limits<EGLint>;
    return static_cast<EGLint>(std::clamp<EGLAttrib>(value(), Limits::min(), Limits::max()));
  }
  void advance() { (mNarrow ? void(mNarrow += 2) : void(mWide += 2)); }

 private:
  EGLAttrib at(int i) const { return mNarrow ? mNarrow[i] : mWide[i]; }

  const EGLint *mNarrow = nullptr;
  const EGLAttrib *mWide = nullptr;
};

// What may stand behind a name.
using ValueCheck = bool (*)(EGLint value);

inline bool anyValue(EGLint) { return true; }
inline bool countValue(EGLint value) { return value >= 0; }
inline bool booleanValue(EGLint value) { return value == EGL_FALSE || value == EGL_TRUE; }
template <EGLint... Values>
bool oneOf(EGLint value) {
  return ((value == Values) || ...);
}
template <EGLint Bits>
bool bitsOf(EGLint value) {
  return (value & ~Bits) == 0;
}

}  // namespace rc::egl
