// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "frames/glass.h"

#include "frames/shapes.h"

namespace rc::bench {
namespace {

const Surface kGlass{.colour = Vec3(1), .reflection = 0.08f, .transmittance = 0.92f, .refractionIndex = 1.5f};
const Surface kMirror{.colour = Vec3(0.9f), .reflection = 0.9f};

Mesh of(Mesh mesh, const Surface &surface) {
  mesh.surface = surface;
  return mesh;
}

FrameScene spheres() {
  const std::optional<Soup> box = loadSoup("cornell", "");
  FrameScene scene{"spheres", "", cornellMeshes(*box), {}, box->camera, {box->light}};
  scene.meshes.push_back(of(ball({180, 110, 330}, 100, 36, 72), {Vec3(0.05f), 0.6f, 80, 0.85f}));
  scene.meshes.push_back(of(ball({390, 110, 200}, 100, 36, 72), kGlass));
  return scene;
}

FrameScene aboutKnot(const char *name, std::vector<Mesh> others) {
  FrameScene scene{name, "", std::move(others), {}, {{0, 2.2f, 5}, {0, 0.7f, 0}, 40}, {{4, 7, 5}}};
  scene.meshes.push_back(of(quad({-12, 0, 12}, {24, 0, 0}, {0, 0, -24}), {.colour = Vec3(0.5f), .reflection = 0.25f}));
  scene.meshes.push_back(of(knot({0, 1.1f, -0.9f}, 0.9f, 0.14f), {.colour = {0.9f, 0.6f, 0.4f}}));
  return scene;
}

}  // namespace

std::optional<FrameScene> loadGlassScene(const std::string &name) {
  if (name == "spheres") return spheres();
  if (name == "balls") {
    return aboutKnot("balls", {of(ball({-1.3f, 0.72f, 0.6f}, 0.7f, 96, 192), kGlass),
                               of(ball({1.4f, 0.82f, -0.4f}, 0.8f, 96, 192), kMirror)});
  }
  if (name == "panes") {
    return aboutKnot("panes", {of(box({-1.5f, 0.02f, 0.6f}, {-0.1f, 1.7f, 0.7f}), kGlass),
                               of(box({0.1f, 0.02f, 0.9f}, {1.3f, 1.3f, 1}), kGlass),
                               of(quad({-2.5f, 0.05f, -3}, {5, 0, 0}, {0, 2.6f, 0}), kMirror)});
  }
  return std::nullopt;
}

}  // namespace rc::bench
