// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include <algorithm>
#include <numeric>

#include "gltf/accessor.h"
#include "gltf/parts.h"

namespace rc::tool::gltf {
namespace {

enum Mode : size_t { kPoints, kLines, kLineLoop, kLineStrip, kTriangles, kTriangleStrip, kTriangleFan };

// Any of the triangle modes as a list.
std::vector<uint32_t> asTriangles(const std::vector<uint32_t> &in, size_t mode) {
  std::vector<uint32_t> out;
  if (mode == kTriangles) {
    out.assign(in.begin(), in.begin() + std::ptrdiff_t(in.size() - in.size() % 3));
    return out;
  }
  for (size_t i = 2; i < in.size(); ++i) {
    const bool fan = mode == kTriangleFan, odd = i % 2 == 1;
    const uint32_t a = fan ? in[0] : in[i - 2], b = in[i - 1], c = in[i];
    out.insert(out.end(), {!fan && odd ? b : a, !fan && odd ? a : b, c});
  }
  return out;
}

// Reads an attribute that must be as long as the positions; empty if there is none.
template <class Read>
auto attribute(const Value &accessor, size_t vertices, Read read) -> decltype(read()) {
  if (!accessor) return {};
  auto values = read();
  if (values.size() != vertices) accessor.complain("{} elements for {} vertices", values.size(), vertices);
  return values;
}

void readSkinning(Document &document, const Value &attributes, Primitive &primitive) {
  const size_t vertices = primitive.positions.size();
  const Value joints = attributes["JOINTS_0"], weights = attributes["WEIGHTS_0"];
  if (!joints || !weights) return;
  primitive.joints = attribute(joints, vertices, [&] { return readJoints(document, joints); });
  primitive.weights = attribute(weights, vertices, [&] { return asVec4(readNumbers(document, weights, {4})); });
  if (attributes["JOINTS_1"]) document.scene.note("more than four joints a vertex: the first four are used");
  for (Vec4 &w : primitive.weights) {
    const float sum = w.x + w.y + w.z + w.w;
    if (sum > 0) w /= sum;
  }
}

void readAttributes(Document &document, const Value &attributes, Primitive &primitive) {
  const auto vectors = [&](const char *key) {
    const Value accessor = attributes[key];
    return attribute(accessor, primitive.positions.size(),
                     [&] { return asVec3(readNumbers(document, accessor, {3})); });
  };
  primitive.positions = asVec3(readNumbers(document, attributes.at("POSITION"), {3}));
  primitive.normals = vectors("NORMAL");
  for (size_t set = 0; set < primitive.uvs.size(); ++set) {
    const Value accessor = attributes[set == 0 ? "TEXCOORD_0" : "TEXCOORD_1"];
    primitive.uvs[set] =
        attribute(accessor, primitive.positions.size(), [&] { return asVec2(readNumbers(document, accessor, {2})); });
  }
  const Value colors = attributes["COLOR_0"];
  primitive.colors = attribute(colors, primitive.positions.size(), [&] {
    return asVec4(readNumbers(document, colors, {3, 4}));
  });
  readSkinning(document, attributes, primitive);
}

void readTargets(Document &document, const Value &targets, Primitive &primitive) {
  for (size_t i = 0; i < targets.size(); ++i) {
    const auto vectors = [&](const char *key) {
      const Value accessor = targets[i][key];
      return attribute(accessor, primitive.positions.size(),
                       [&] { return asVec3(readNumbers(document, accessor, {3})); });
    };
    primitive.targets.push_back({vectors("POSITION"), vectors("NORMAL")});
  }
}

std::vector<uint32_t> verticesInOrder(Document &document, const Value &about, size_t vertices) {
  if (!about["indices"]) {
    std::vector<uint32_t> all(vertices);
    std::iota(all.begin(), all.end(), 0u);
    return all;
  }
  std::vector<uint32_t> indices = readIndices(document, about["indices"]);
  for (size_t i = 0; i < indices.size(); ++i) {
    if (indices[i] >= vertices) {
      about["indices"].complain("index {} is {}, but there are {} vertices", i, indices[i], vertices);
    }
  }
  return indices;
}

void readPrimitive(Document &document, const Value &about, Mesh &mesh) {
  Primitive primitive;
  const size_t mode = about["mode"].count(kTriangles);
  if (mode > kTriangleFan) about["mode"].complain("{} is no mode", mode);
  if (about["extensions"]["KHR_draco_mesh_compression"] || !about.at("attributes")["POSITION"]) {
    return document.scene.note(about.place() + ": no positions that can be read; not drawn");
  }
  primitive.material = about["material"].index(document.scene.materials.size());
  readAttributes(document, about["attributes"], primitive);
  readTargets(document, about["targets"], primitive);
  const std::vector<uint32_t> order = verticesInOrder(document, about, primitive.positions.size());
  if (mode < kTriangles) return document.scene.note("points and lines: rays meet surfaces only; not drawn");
  primitive.indices = asTriangles(order, mode);
  mesh.primitives.push_back(std::move(primitive));
}

}  // namespace

void readMeshes(Document &document) {
  const Value meshes = document["meshes"];
  for (size_t i = 0; i < meshes.size(); ++i) {
    Mesh mesh{meshes[i]["name"].text(), {}, meshes[i]["weights"].numbers()};
    const Value primitives = meshes[i].at("primitives");
    for (size_t k = 0; k < primitives.size(); ++k) readPrimitive(document, primitives[k], mesh);
    document.scene.meshes.push_back(std::move(mesh));
  }
}

}  // namespace rc::tool::gltf
