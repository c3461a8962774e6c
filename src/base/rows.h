// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// rows.h: a vector of plain values that does not fill what it grows by: whoever resizes it writes the rows.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>

#include "base/memory.h"

namespace rc {

template <class T>
struct NoFill : Counted<T> {
  NoFill() = default;
  template <class U>
  NoFill(const NoFill<U> &) noexcept {}

  template <class U>
  void construct(U *place) noexcept(std::is_nothrow_default_constructible_v<U>) {
    ::new (static_cast<void *>(place)) U;
  }
  template <class U, class... Arguments>
  void construct(U *place, Arguments &&...arguments) {
    std::construct_at(place, std::forward<Arguments>(arguments)...);
  }
};

template <class T>
using Rows = std::vector<T, NoFill<T>>;

}  // namespace rc
