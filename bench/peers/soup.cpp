// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// soup.cpp: readers for exactly the files that the measurements need.
#include "peers/soup.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <sstream>

namespace rc::bench {
namespace {

void quad(Soup &soup, const Vec3 &a, const Vec3 &b, const Vec3 &c, const Vec3 &d) {
  for (const Vec3 &v : {a, b, c, a, c, d}) soup.vertices.push_back(v);
}

void block(Soup &soup, float height, const Vec2 (&foot)[4]) {
  const auto corner = [&](int i, float y) { return Vec3(foot[i % 4].x, y, foot[i % 4].y); };
  quad(soup, corner(0, height), corner(1, height), corner(2, height), corner(3, height));
  for (int i = 0; i < 4; ++i) quad(soup, corner(i, height), corner(i, 0), corner(i + 1, 0), corner(i + 1, height));
}

// The measured box of Cornell University: five walls, a lamp and two blocks; 32 triangles.
void makeCornell(Soup &soup) {
  quad(soup, {552.8f, 0, 0}, {0, 0, 0}, {0, 0, 559.2f}, {549.6f, 0, 559.2f});
  quad(soup, {556, 548.8f, 0}, {556, 548.8f, 559.2f}, {0, 548.8f, 559.2f}, {0, 548.8f, 0});
  quad(soup, {549.6f, 0, 559.2f}, {0, 0, 559.2f}, {0, 548.8f, 559.2f}, {556, 548.8f, 559.2f});
  quad(soup, {0, 0, 559.2f}, {0, 0, 0}, {0, 548.8f, 0}, {0, 548.8f, 559.2f});
  quad(soup, {552.8f, 0, 0}, {549.6f, 0, 559.2f}, {556, 548.8f, 559.2f}, {556, 548.8f, 0});
  quad(soup, {343, 548.7f, 227}, {343, 548.7f, 332}, {213, 548.7f, 332}, {213, 548.7f, 227});
  block(soup, 165, {{130, 65}, {82, 225}, {240, 272}, {290, 114}});
  block(soup, 330, {{423, 247}, {265, 296}, {314, 456}, {472, 406}});
}

// Positions and faces of an OBJ file; polygons become fans.
bool readObj(const std::string &path, Soup &soup) {
  std::ifstream file(path);
  std::vector<Vec3> positions;
  std::string line, word;
  while (std::getline(file, line)) {
    if (line.rfind("v ", 0) == 0) {
      Vec3 p;
      if (std::sscanf(line.c_str(), "v %f %f %f", &p.x, &p.y, &p.z) == 3) positions.push_back(p);
    } else if (line.rfind("f ", 0) == 0) {
      std::istringstream words(line.substr(2));
      std::vector<Vec3> corners;
      while (words >> word) {
        const long i = std::atol(word.c_str());
        corners.push_back(positions.at(size_t(i > 0 ? i - 1 : long(positions.size()) + i)));
      }
      for (size_t i = 2; i < corners.size(); ++i) {
        soup.vertices.insert(soup.vertices.end(), {corners[0], corners[i - 1], corners[i]});
      }
    }
  }
  return !soup.vertices.empty();
}

// The number behind the n-th occurrence of a key in the JSON text.
size_t numberOf(const std::string &json, const char *key, int occurrence) {
  size_t place = 0;
  for (int i = 0; i <= occurrence; ++i) {
    place = json.find(key, place);
    if (place == std::string::npos) return 0;
    place += std::strlen(key);
  }
  return std::strtoul(json.c_str() + place, nullptr, 10);
}

// The dragons: one mesh, float positions in the first buffer view, 32-bit indices in the second.
bool readDragonGlb(const std::string &path, Soup &soup) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (bytes.size() < 20) return false;
  uint32_t jsonLength = 0;
  std::memcpy(&jsonLength, bytes.data() + 12, 4);
  if (bytes.size() < size_t(jsonLength) + 28) return false;
  const std::string json = bytes.substr(20, jsonLength);
  const size_t vertexCount = numberOf(json, "\"count\":", 0), indexCount = numberOf(json, "\"count\":", 1);
  const char *blob = bytes.data() + 28 + jsonLength;
  const size_t indexOffset = numberOf(json, "\"byteOffset\":", 1);
  if (bytes.size() < 28 + size_t(jsonLength) + indexOffset + 4 * indexCount) return false;
  for (size_t i = 0; i < indexCount; ++i) {
    uint32_t index = 0;
    std::memcpy(&index, blob + indexOffset + 4 * i, 4);
    if (index >= vertexCount) return false;
    Vec3 p;
    std::memcpy(&p, blob + sizeof(Vec3) * index, sizeof p);
    soup.vertices.push_back(p);
  }
  return indexCount > 0;
}

// One landscape as fine as one likes, to see what time grows with.
bool makeHills(size_t triangles, Soup &soup) {
  const auto n = static_cast<int>(std::sqrt(double(triangles) / 2));
  const auto point = [&](int i, int j) {
    const float u = float(i) / float(n), v = float(j) / float(n);
    return Vec3(2 * u - 1, 0.1f * std::sin(9 * u) * std::cos(11 * v) + 0.02f * std::sin(57 * u * v + 40 * v),
                2 * v - 1);
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) quad(soup, point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1));
  }
  soup.camera = {{0.2f, 0.7f, 1.3f}, {0, 0, 0}, 50};
  soup.light = {1, 2, 1};
  return n > 0;
}

// The bunny becomes two units across and stands on y = -0.992.
void standBunny(Soup &soup) {
  Vec3 lower(kInfinity), upper(-kInfinity);
  for (const Vec3 &v : soup.vertices) lower = glm::min(lower, v), upper = glm::max(upper, v);
  const float scale = 2 / maxComponent(upper - lower);
  const Vec3 foot{(lower.x + upper.x) / 2, lower.y, (lower.z + upper.z) / 2};
  for (Vec3 &v : soup.vertices) v = (v - foot) * scale - Vec3(0, 0.992f, 0);
}

constexpr Camera kDragonCamera{{0.02f, 0.17f, 0.24f}, {-0.006f, 0.122f, 0}, 40};

}  // namespace

std::optional<Soup> loadSoup(const std::string &name, const std::string &folder) {
  Soup soup{name, {}, kDragonCamera, {0.3f, 0.5f, 0.4f}};
  bool found = false;
  if (name == "cornell") {
    makeCornell(soup);
    soup.camera = {{278, 273, -250}, {278, 273, 280}, 50};
    soup.light = {278, 500, 279};
    found = true;
  } else if (name == "bunny") {
    found = readObj(folder + "/obj/stanford-bunny.obj", soup);
    standBunny(soup);
    soup.camera = {{0.5f, 0.6f, 2.4f}, {0, -0.05f, 0}, 42};
    soup.light = {2, 3, 3};
  } else if (name == "sponza") {
    found = readObj(folder + "/noncommercial/sponza-dabrovic.obj", soup);
    soup.camera = {{-10.5f, 2.2f, 0.6f}, {6, 4.2f, -0.8f}, 60};
    soup.light = {1, 11, 0.5f};
  } else if (name.rfind("hills", 0) == 0) {
    found = makeHills(std::strtoul(name.c_str() + 5, nullptr, 10), soup);
  } else if (name == "dragon203k" || name == "dragon871k") {
    found = readDragonGlb(folder + "/gltf/stanford-dragon-" + name.substr(6) + ".glb", soup);
  }
  if (!found) return std::nullopt;
  return soup;
}

}  // namespace rc::bench
