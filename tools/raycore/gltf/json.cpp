// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "gltf/json.h"

#include <nlohmann/json.hpp>

namespace rc::tool::gltf {

Value Value::operator[](const char *key) const {
  const std::string place = mPlace.empty() ? key : mPlace + "." + key;
  if (!mJson) return {nullptr, place};
  if (!mJson->is_object()) complain("is not an object");
  const auto found = mJson->find(key);
  return {found == mJson->end() ? nullptr : &*found, place};
}

Value Value::at(const char *key) const {
  Value value = (*this)[key];
  if (!value) value.complain("is missing");
  return value;
}

size_t Value::size() const {
  if (!mJson) return 0;
  if (!mJson->is_array()) complain("is not an array");
  return mJson->size();
}

Value Value::operator[](size_t index) const { return {&(*mJson)[index], fmt::format("{}[{}]", mPlace, index)}; }

float Value::number(float missing) const {
  if (!mJson) return missing;
  if (!mJson->is_number()) complain("is not a number");
  return mJson->get<float>();
}

bool Value::boolean(bool missing) const {
  if (!mJson) return missing;
  if (!mJson->is_boolean()) complain("is neither true nor false");
  return mJson->get<bool>();
}

std::string Value::text(const std::string &missing) const {
  if (!mJson) return missing;
  if (!mJson->is_string()) complain("is not a string");
  return mJson->get<std::string>();
}

size_t Value::count(size_t missing) const {
  if (!mJson) return missing;
  if (!mJson->is_number_unsigned()) complain("is not a whole number from 0 on");
  return mJson->get<size_t>();
}

int Value::index(size_t end) const {
  if (!mJson) return -1;
  const size_t value = count(0);
  if (value >= end) complain("names {} of {}", value, end);
  return static_cast<int>(value);
}

std::vector<float> Value::numbers() const {
  std::vector<float> values;
  for (size_t i = 0; i < size(); ++i) values.push_back((*this)[i].number(0));
  return values;
}

std::vector<float> Value::numbers(size_t wanted) const {
  if (size() != wanted) complain("has {} numbers instead of {}", size(), wanted);
  return numbers();
}

std::vector<int> Value::indices(size_t end) const {
  std::vector<int> values;
  for (size_t i = 0; i < size(); ++i) values.push_back((*this)[i].index(end));
  return values;
}

Vec3 Value::vec3(const Vec3 &missing) const {
  if (!mJson) return missing;
  const std::vector<float> v = numbers(3);
  return {v[0], v[1], v[2]};
}

}  // namespace rc::tool::gltf
