// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// accessor.h: numbers of an accessor. [glTF 2.0, 3.6.2]
// In: Document, accessor's index.  Out: floats (normalised where it says so) or whole numbers, sparse ones included.
#pragma once

#include <vector>

#include "gltf/document.h"

namespace rc::tool::gltf {

struct Numbers {
  std::vector<float> values;
  size_t width = 1;  // numbers an element

  size_t count() const { return values.size() / width; }
};

// widths: numbers an element that are allowed here, such as {3, 4}.
Numbers readNumbers(Document &document, const Value &accessorIndex, std::initializer_list<size_t> widths);

// Elements of one whole number each.
std::vector<uint32_t> readIndices(Document &document, const Value &accessorIndex);

// Four whole numbers each.
std::vector<Joints> readJoints(Document &document, const Value &accessorIndex);

std::vector<Vec2> asVec2(const Numbers &numbers);
std::vector<Vec3> asVec3(const Numbers &numbers);
std::vector<Vec4> asVec4(const Numbers &numbers);  // a missing fourth number is 1
std::vector<Mat4> asMat4(const Numbers &numbers);

}  // namespace rc::tool::gltf
