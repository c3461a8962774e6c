// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// archive.h: a scene as bytes, for the way from the loader's process to ours. Both ends are this program, so the bytes
// need no version; sizes are checked all the same, because the loader may have been damaged by what it read.
#pragma once

#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "scene/scene.h"

namespace rc::tool {

class Writer {
 public:
  template <class T>
  void value(T &item) {
    mBytes.append(reinterpret_cast<const char *>(&item), sizeof item);
  }
  template <class Array>
  void plain(Array &items) {
    size_t count = items.size();
    value(count);
    mBytes.append(reinterpret_cast<const char *>(items.data()), count * sizeof(*items.data()));
  }
  template <class T>
  size_t resize(std::vector<T> &items) {
    size_t count = items.size();
    value(count);
    return count;
  }
  std::string take() { return std::move(mBytes); }

 private:
  std::string mBytes;
};

class Reader {
 public:
  explicit Reader(std::string_view bytes) : mBytes(bytes) {}

  template <class T>
  void value(T &item) {
    std::memcpy(&item, take(sizeof item).data(), sizeof item);
  }
  template <class Array>
  void plain(Array &items) {
    size_t count = 0;
    value(count);
    constexpr size_t kSize = sizeof(*items.data());
    if (count > mBytes.size() / kSize) throw std::runtime_error("the loader's answer is cut short");
    items.resize(count);
    if (count > 0) std::memcpy(items.data(), take(count * kSize).data(), count * kSize);
  }
  template <class T>
  size_t resize(std::vector<T> &items) {
    size_t count = 0;
    value(count);
    if (count > mBytes.size()) throw std::runtime_error("the loader's answer is cut short");
    items.resize(count);
    return count;
  }

 private:
  std::string_view take(size_t size) {
    if (size > mBytes.size()) throw std::runtime_error("the loader's answer is cut short");
    const std::string_view front = mBytes.substr(0, size);
    mBytes.remove_prefix(size);
    return front;
  }

  std::string_view mBytes;
};

std::string packed(const Scene &scene);
Scene unpacked(std::string_view bytes);

}  // namespace rc::tool
