// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Which loader reads a file.
#include "foreign/read.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <span>

#include "gltf/parts.h"
#include "input/error.h"
#include "input/file.h"
#include "load/load.h"

namespace rc::tool {
namespace {

std::string standardInput() { return {std::istreambuf_iterator<char>(std::cin), {}}; }

bool looksLikeGltf(const std::string &name, const std::string &bytes) {
  const std::string extension = extensionOf(name);
  if (extension == ".glb" || extension == ".gltf") return true;
  const size_t first = bytes.find_first_not_of(" \t\r\n");
  return name == "-" && (bytes.starts_with("glTF") || (first != bytes.npos && bytes[first] == '{'));
}

// Assimp takes some files that hold nothing for success.
void checkSomething(const Scene &scene) {
  if (scene.nodes.empty() && scene.meshes.empty()) reject("there is nothing in it");
}

// The library leaves triangles out that have a corner nowhere.
void noteCornersNowhere(Scene &scene) {
  const auto isNowhere = [](const Vec3 &v) { return !std::isfinite(v.x + v.y + v.z); };
  for (const Mesh &mesh : scene.meshes) {
    size_t triangles = 0, lost = 0;
    for (const Primitive &primitive : mesh.primitives) {
      triangles += primitive.triangles();
      if (std::ranges::none_of(primitive.positions, isNowhere)) continue;
      for (size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
        const auto corners = std::span(primitive.indices).subspan(i, 3);
        lost += std::ranges::any_of(corners, [&](uint32_t corner) { return isNowhere(primitive.positions[corner]); });
      }
    }
    if (lost == 0) continue;
    scene.note(fmt::format("mesh \"{}\": {} of {} triangles have a corner that is not finite; not drawn", mesh.name,
                           lost, triangles));
  }
}

Scene readAny(const std::string &name) {
  const std::string extension = extensionOf(name);
  if (name == "-" || extension == ".glb" || extension == ".gltf") {
    const std::string bytes = name == "-" ? standardInput() : readFile(name);
    if (!looksLikeGltf(name, bytes)) reject("only glTF is read from standard input");
    return gltf::readGltf(bytes, std::filesystem::absolute(name).parent_path().string());
  }
  if (extension.empty() || !foreign::reads(extension)) reject("\"{}\" is no model format that is read", extension);
  Scene scene = foreign::readFile(name);
  checkSomething(scene);
  return scene;
}

}  // namespace

Scene readModel(const std::string &name) {
  Scene scene = readAny(name);
  noteCornersNowhere(scene);
  return scene;
}

}  // namespace rc::tool
