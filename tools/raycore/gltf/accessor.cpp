// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "gltf/accessor.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace rc::tool::gltf {
namespace {

struct Component {
  size_t token, bytes;
  float largest;  // what 1 is as a normalised number
  bool isSigned, isFloat;
};

constexpr std::array kComponents{
    Component{5120, 1, 127.0f, true, false},   Component{5121, 1, 255.0f, false, false},
    Component{5122, 2, 32767.0f, true, false}, Component{5123, 2, 65535.0f, false, false},
    Component{5125, 4, 1.0f, false, false},    Component{5126, 4, 1.0f, true, true},
};

struct Type {
  const char *name;
  size_t width;
};

constexpr std::array kTypes{Type{"SCALAR", 1}, Type{"VEC2", 2}, Type{"VEC3", 3}, Type{"VEC4", 4},
                            Type{"MAT2", 4},   Type{"MAT3", 9}, Type{"MAT4", 16}};

// An accessor without data is zeros: what it may have at most, since no bytes of the file back it.
constexpr size_t kMostZeros = 1 << 24;

struct Layout {
  const Component *component;
  size_t width, count;
  bool normalised;

  size_t elementBytes() const { return component->bytes * width; }
};

const Component &componentOf(const Value &token) {
  const size_t wanted = token.count(0);
  for (const Component &component : kComponents) {
    if (component.token == wanted) return component;
  }
  token.complain("{} is no type of numbers", wanted);
}

size_t widthOf(const Value &type) {
  const std::string name = type.text();
  for (const Type &known : kTypes) {
    if (name == known.name) return known.width;
  }
  type.complain("\"{}\" is no type of elements", name);
}

double numberAt(const Component &component, const char *at) {
  const auto as = [&]<class T>(T value) {
    std::memcpy(&value, at, sizeof value);
    return double(value);
  };
  if (component.isFloat) return as(float{});
  if (component.bytes == 4) return as(uint32_t{});
  if (component.bytes == 2) return component.isSigned ? as(int16_t{}) : as(uint16_t{});
  return component.isSigned ? as(int8_t{}) : as(uint8_t{});
}

// Calls store(index, number) for every number of elements that lie in a view.
template <class Store>
void eachNumber(Document &document, const Value &holder, const Layout &layout, Store store) {
  const Document::View view = document.view(holder.at("bufferView").index(document.countOf("bufferViews")));
  const size_t offset = holder["byteOffset"].count(0), size = layout.elementBytes();
  const size_t stride = view.stride == 0 ? size : view.stride;
  const size_t available = offset > view.bytes.size() ? 0 : view.bytes.size() - offset;
  const bool fits = layout.count == 0 || (available >= size && (layout.count - 1) <= (available - size) / stride);
  if (!fits) {
    holder.complain("{} elements of {} bytes from byte {} on are not within the view's {} bytes", layout.count, size,
                    offset, view.bytes.size());
  }
  for (size_t i = 0; i < layout.count; ++i) {
    const char *element = view.bytes.data() + offset + i * stride;
    for (size_t k = 0; k < layout.width; ++k) {
      store(i * layout.width + k, numberAt(*layout.component, element + k * layout.component->bytes));
    }
  }
}

template <class Store>
void sparseNumbers(Document &document, const Value &sparse, const Layout &layout, Store store) {
  const size_t count = sparse.at("count").count(0);
  if (count > layout.count) sparse["count"].complain("is {} of {} elements", count, layout.count);
  const Value indices = sparse.at("indices");
  std::vector<size_t> places(count);
  const Layout whole{&componentOf(indices.at("componentType")), 1, count, false};
  eachNumber(document, indices, whole, [&](size_t i, double number) {
    if (number < 0 || number >= double(layout.count)) indices.complain("names element {} of {}", number, layout.count);
    places[i] = size_t(number);
  });
  const Layout values{layout.component, layout.width, count, layout.normalised};
  eachNumber(document, sparse.at("values"), values, [&](size_t i, double number) {
    store(places[i / layout.width] * layout.width + i % layout.width, number);
  });
}

// Numbers as they are; the layout tells what they mean.
template <class T>
std::pair<Layout, std::vector<T>> read(Document &document, const Value &accessorIndex) {
  const int index = accessorIndex.index(document.countOf("accessors"));
  const Value accessor = document["accessors"][size_t(index)];
  const Layout layout{&componentOf(accessor.at("componentType")), widthOf(accessor.at("type")),
                      accessor.at("count").count(0), accessor["normalized"].boolean(false)};
  if (!accessor["bufferView"] && layout.count > kMostZeros) {
    accessor["count"].complain("{} elements have no data", layout.count);
  }
  if (std::is_integral_v<T> && layout.component->isSigned) accessorIndex.complain("its numbers are not unsigned");
  std::vector<T> numbers;
  const auto store = [&](size_t i, double number) { numbers[i] = static_cast<T>(number); };
  if (accessor["bufferView"]) {
    const size_t bytes = document.view(accessor["bufferView"].index(document.countOf("bufferViews"))).bytes.size();
    if (layout.count > bytes) accessor["count"].complain("is {}, but its view has {} bytes", layout.count, bytes);
    numbers.resize(layout.count * layout.width);
    eachNumber(document, accessor, layout, store);
  } else {
    numbers.resize(layout.count * layout.width);
  }
  if (accessor["sparse"]) sparseNumbers(document, accessor["sparse"], layout, store);
  return {layout, std::move(numbers)};
}

template <class Vector>
std::vector<Vector> vectors(const Numbers &numbers) {
  std::vector<Vector> result(numbers.count(), Vector(1));
  constexpr size_t kWidth = sizeof(Vector) / sizeof(float);
  for (size_t i = 0; i < result.size(); ++i) {
    std::memcpy(static_cast<void *>(&result[i]), &numbers.values[i * numbers.width],
                std::min(kWidth, numbers.width) * sizeof(float));
  }
  return result;
}

}  // namespace

Numbers readNumbers(Document &document, const Value &accessorIndex, std::initializer_list<size_t> widths) {
  auto [layout, values] = read<float>(document, accessorIndex);
  if (std::find(widths.begin(), widths.end(), layout.width) == widths.end()) {
    accessorIndex.complain("its elements have {} numbers, which do not belong here", layout.width);
  }
  if (layout.normalised && !layout.component->isFloat) {
    for (float &value : values) value = std::max(value / layout.component->largest, -1.0f);
  }
  return {std::move(values), layout.width};
}

std::vector<uint32_t> readIndices(Document &document, const Value &accessorIndex) {
  auto [layout, values] = read<uint32_t>(document, accessorIndex);
  if (layout.width != 1) accessorIndex.complain("its elements are no indices");
  return std::move(values);
}

std::vector<Joints> readJoints(Document &document, const Value &accessorIndex) {
  const auto [layout, values] = read<uint32_t>(document, accessorIndex);
  if (layout.width != 4) accessorIndex.complain("its elements are not four joints");
  std::vector<Joints> joints(values.size() / 4);
  for (size_t i = 0; i < values.size(); ++i) joints[i / 4][i % 4] = values[i];
  return joints;
}

std::vector<Vec2> asVec2(const Numbers &numbers) { return vectors<Vec2>(numbers); }
std::vector<Vec3> asVec3(const Numbers &numbers) { return vectors<Vec3>(numbers); }
std::vector<Vec4> asVec4(const Numbers &numbers) { return vectors<Vec4>(numbers); }
std::vector<Mat4> asMat4(const Numbers &numbers) { return vectors<Mat4>(numbers); }

}  // namespace rc::tool::gltf
