// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "draw/stage.h"

#include <RC/rc.h>

#include <cmath>

#include "draw/resample.h"

namespace rc::tool {
namespace {

constexpr int kColumns = 96, kRows = 48;
constexpr float kSphereRadii = 40, kGroundRadii = 12;
constexpr float kPi = 3.14159265f;

RCuint makeMaterial() {
  RCuint name = 0;
  rcBindMaterial(0);
  rcGenMaterials(1, &name);
  rcBindMaterial(name);
  return name;
}

void setTexture(const Image &image) {
  const Image fitting = forDevice(image);
  RCuint name = 0;
  rcGenTextures(1, &name);
  rcBindTexture(RC_TEXTURE_2D, name);
  rcEnable(RC_LARGE_TEXTURES);
  rcTexParameteri(RC_TEXTURE_2D, RC_TEXTURE_OPAQUE_ALPHA, 1);
  rcTexParameteri(RC_TEXTURE_2D, RC_TEXTURE_MIN_FILTER, RC_LINEAR_MIPMAP_LINEAR);
  rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGBA, fitting.width, fitting.height, 0, RC_RGBA, RC_UNSIGNED_BYTE,
               fitting.rgba.data());
  rcTexParameteri(RC_TEXTURE_2D, RC_TEXTURE_WRAP_T, RC_CLAMP_TO_EDGE);
  rcEnable(RC_TEXTURE_2D);
}

Image checker() {
  constexpr int kSize = 128;
  Image image{"checker", kSize, kSize, {}};
  for (int i = 0; i < kSize * kSize; ++i) {
    const bool light = (i % kSize < kSize / 2) == (i / kSize < kSize / 2);
    const uint8_t c = light ? 205 : 95;
    image.rgba.insert(image.rgba.end(), {c, c, c, 255});
  }
  return image;
}

RCuint sphereMaterial(const Image &image) {
  const RCuint name = makeMaterial();
  setTexture(image);
  return name;
}

RCuint groundMaterial(GroundKind kind) {
  const RCuint name = makeMaterial();
  const float grey[] = {0.62f, 0.62f, 0.62f, 1}, share[] = {0.45f, 0.45f, 0.45f};
  rcMaterialfv(RC_FRONT_AND_BACK, RC_AMBIENT_AND_DIFFUSE, grey);
  if (kind == GroundKind::Mirror) rcMaterialfv(RC_FRONT_AND_BACK, RC_REFLECTION, share);
  if (kind != GroundKind::Checker) return name;
  setTexture(checker());
  rcTexParameteri(RC_TEXTURE_2D, RC_TEXTURE_WRAP_T, RC_REPEAT);
  return name;
}

void plainState() {
  for (const RCenum cap :
       {RC_CULL_FACE, RC_ALPHA_TEST, RC_USE_TEXTURE_ONLY, RC_USE_TRANSMITTANCE_SHADOW, RC_USE_TEXTURE_ALPHA_SHADOW}) {
    rcDisable(cap);
  }
  for (const RCenum array : {RC_NORMAL_ARRAY, RC_COLOR_ARRAY}) rcDisableClientState(array);
  rcMatrixMode(RC_MODELVIEW);
  rcLoadIdentity();
}

void submit(RCenum mode, const std::vector<Vec3> &points, const std::vector<Vec2> &uvs) {
  rcEnableClientState(RC_VERTEX_ARRAY);
  rcEnableClientState(RC_TEXTURE_COORD_ARRAY);
  rcVertexPointer(3, RC_FLOAT, 0, points.data());
  rcTexCoordPointer(2, RC_FLOAT, 0, uvs.data());
  rcDrawArrays(mode, 0, RCsizei(points.size()));
}

}  // namespace

Stage::Stage(const Background &background, GroundKind ground, bool zUp) : mZUp(zUp) {
  const Vec3 &c = background.colour;
  rcClearColor(c.x, c.y, c.z, 1);
  if (background.sphere) mSphere = sphereMaterial(*background.sphere);
  if (ground != GroundKind::None) mGround = groundMaterial(ground);
}

std::string Stage::materialName(unsigned name) const {
  if (name == 0) return {};
  return name == mSphere ? "background" : name == mGround ? "ground" : std::string();
}

void Stage::draw(const Bounds &bounds) const {
  plainState();
  if (mGround) drawGround(bounds);
  if (mSphere) drawSphere(bounds);
}

// The middle of the picture is in front: -z, or y where z is up.
void Stage::drawSphere(const Bounds &bounds) const {
  std::vector<Vec3> points;
  std::vector<Vec2> uvs;
  const float radius = kSphereRadii * std::max(bounds.radius(), 1e-6f);
  const auto corner = [&](int column, int row) {
    const Vec2 uv(float(column) / kColumns, float(row) / kRows);
    const float around = 2 * kPi * (uv.x - 0.5f), down = kPi * uv.y;
    const Vec3 d(std::sin(around) * std::sin(down), std::cos(down), -std::cos(around) * std::sin(down));
    points.push_back(bounds.centre() + radius * (mZUp ? Vec3(d.x, -d.z, d.y) : d));
    uvs.push_back(uv);
  };
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      corner(column, row);
      corner(column, row + 1);
      corner(column + 1, row + 1);
      corner(column + 1, row);
    }
  }
  rcBindMaterial(mSphere);
  rcEnable(RC_USE_TEXTURE_ONLY);
  submit(RC_QUADS, points, uvs);
  rcDisable(RC_USE_TEXTURE_ONLY);
}

void Stage::drawGround(const Bounds &bounds) const {
  const float radius = std::max(bounds.radius(), 1e-6f), half = kGroundRadii * radius;
  const Vec3 c = bounds.centre();
  const float level = (mZUp ? bounds.low.z : bounds.low.y) - 1e-4f * radius;
  std::vector<Vec3> points;
  std::vector<Vec2> uvs;
  for (const Vec2 &at : {Vec2(-1, 1), Vec2(1, 1), Vec2(1, -1), Vec2(-1, -1)}) {
    const Vec2 way = half * at;
    points.push_back(mZUp ? Vec3(c.x + way.x, c.y - way.y, level) : Vec3(c.x + way.x, level, c.z + way.y));
    uvs.push_back(at * kGroundRadii);
  }
  rcBindMaterial(mGround);
  submit(RC_QUADS, points, uvs);
}

}  // namespace rc::tool
