// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// arguments.h: bytes as the arguments of a function, by their types. A pointer is null or points to as much memory as
// its function may touch, and no more.
#pragma once

#include <memory>
#include <string_view>
#include <tuple>

#include "calls/world.h"

namespace rc::fuzz {

struct Site {
  World &world;
  Input &in;
  std::string_view function;

  bool isEgl() const { return function.starts_with("egl"); }
  // Values behind a pointer to several.
  size_t valuesBehindPointer() const;
};

// Numbers.
template <class T>
struct Argument {
  T value;
  explicit Argument(const Site &site) : value(T(site.in.integer())) {}
};
template <>
struct Argument<unsigned> {  // tokens and names
  unsigned value;
  explicit Argument(const Site &site) : value(site.in.token()) {}
};
template <>
struct Argument<unsigned char> {
  unsigned char value;
  explicit Argument(const Site &site) : value(site.in.byte()) {}
};
template <>
struct Argument<float> {
  float value;
  explicit Argument(const Site &site) : value(site.in.number()) {}
};
template <>
struct Argument<double> {
  double value;
  explicit Argument(const Site &site) : value(double(site.in.number())) {}
};

// Handles of EGL, and names of objects in their place.
template <>
struct Argument<void *> {
  void *value;
  explicit Argument(const Site &site) : value(site.world.handle(site.in)) {}
};
template <>
struct Argument<const void *> {
  const void *value;
  explicit Argument(const Site &site) : value(site.world.handle(site.in)) {}
};
template <>
struct Argument<void **> {
  void *place = nullptr;
  void **value;
  explicit Argument(const Site &site) : value(site.in.byte() == 0 ? nullptr : &place) {}
  Argument(const Argument &other) : value(other.value ? &place : nullptr) {}
};

// Lists of attributes end with EGL_NONE; others have as many values as their function reads or writes.
template <class T>
requires std::is_arithmetic_v<T>
struct Argument<T *> {
  using Value = std::remove_const_t<T>;
  std::shared_ptr<Value[]> memory;
  T *value = nullptr;

  explicit Argument(const Site &site) {
    const size_t given = site.in.byte() % 32;
    if (given == 0) return;
    const bool isList = site.isEgl() && std::is_const_v<T>;
    const size_t size = isList ? 2 * (given / 2) + 1 : site.valuesBehindPointer();
    memory.reset(new Value[size]{});
    for (size_t i = 0; i < std::min(given, size); ++i) memory[i] = Argument<Value>(site).value;
    if (isList) memory[size - 1] = Value(EGL_NONE);
    value = memory.get();
  }
};

inline void RC_APIENTRY takeMessage(RCenum, RCenum, RCuint, RCenum, RCsizei, const RCchar *, const RCvoid *) {}

template <>
struct Argument<RCDEBUGPROCRCX> {
  RCDEBUGPROCRCX value;
  explicit Argument(const Site &site) : value(site.in.flag() ? takeMessage : nullptr) {}
};

// Calls a function of any type with what the input says.
template <class Result, class... Parameters>
void callWith(const Site &site, Result (*function)(Parameters...)) {
  std::tuple<Argument<Parameters>...> arguments{Argument<Parameters>(site)...};  // braces: from left to right
  std::apply(
      [&](auto &...argument) {
        if constexpr (std::is_same_v<Result, void *>) {
          site.world.note(function(argument.value...));
        } else {
          function(argument.value...);
        }
      },
      arguments);
}

}  // namespace rc::fuzz
