// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// json.h: a value of a JSON document and its place in it, so that every complaint says where.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "input/error.h"
#include "scene/math.h"

namespace rc::tool::gltf {

using Json = nlohmann::json;

class Value {
 public:
  Value(const Json *json, std::string place) : mJson(json), mPlace(std::move(place)) {}

  // Members: a missing one gives a Value that is not there.
  bool there() const { return mJson != nullptr; }
  explicit operator bool() const { return there(); }
  Value operator[](const char *key) const;
  Value at(const char *key) const;  // rejects a missing one

  // Elements of an array; a value that is not there has none.
  size_t size() const;
  Value operator[](size_t index) const;

  const std::string &place() const { return mPlace; }
  template <class... Arguments>
  [[noreturn]] void complain(fmt::format_string<Arguments...> text, Arguments &&...arguments) const {
    reject("{}: {}", mPlace, fmt::format(text, std::forward<Arguments>(arguments)...));
  }

  // What is not there has the default.
  float number(float missing) const;
  bool boolean(bool missing) const;
  std::string text(const std::string &missing = {}) const;
  size_t count(size_t missing) const;  // a whole number, not negative
  int index(size_t end) const;         // into an array of end elements; -1 if not there
  std::vector<float> numbers() const;
  std::vector<float> numbers(size_t wanted) const;  // exactly so many
  std::vector<int> indices(size_t end) const;
  Vec3 vec3(const Vec3 &missing) const;

 private:
  const Json *mJson;
  std::string mPlace;
};

}  // namespace rc::tool::gltf
