// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "rcddi/random_scenes.h"

#include "rchal/units/coverage.h"

namespace rc::test {

using namespace rc::hal;

namespace {

constexpr size_t kMaterials = 6;

}  // namespace

RandomScene::RandomScene(uint32_t number) : mRandom(number) {
  makeTextures();
  makeMaterials();
  makeLights();
  for (Set &set : mSets) {
    for (int i = 0; i < 3; ++i) addBall(set, vector(2), uniform(0.3f, 1), 8);
    addSheet(set);
    finish(set);
  }
  // Glass in glass.
  const Vec3 centre = vector(1);
  addBall(mSets[0], centre, 0.9f, 8);
  addBall(mSets[0], centre, 0.5f, 8);
  finish(mSets[0]);
  setView();
}

Vec3 RandomScene::vector(float size) {
  const float x = uniform(-size, size), y = uniform(-size, size), z = uniform(-size, size);
  return {x, y, z};
}

void RandomScene::makeTextures() {
  for (int i = 0; i < 3; ++i) {
    const int size = 4 << below(3), levels = int(below(3)) + 1;
    TextureView texture;
    texture.width = texture.height = size;
    texture.levelCount = levels;
    texture.trilinear = chance(0.5f);
    texture.anisotropy = 1 << below(5);
    texture.hasAlpha = chance(0.6f);
    texture.opaqueAlpha = chance(0.5f) ? 16 : 255;
    for (int level = 0; level < levels; ++level) {
      std::vector<uint32_t> &texels = mTexels.emplace_back();
      const uint32_t opaque = texture.hasAlpha ? 0 : 0xff000000u;
      for (int k = 0; k < (size >> level) * (size >> level); ++k) texels.push_back(uint32_t(mRandom()) | opaque);
      texture.levels[size_t(level)] = texels.data();
    }
    mTextures.push_back(texture);
  }
}

void RandomScene::makeMaterials() {
  for (size_t i = 0; i < kMaterials; ++i) {
    MaterialRow &row = mMaterials[i];
    row.ambient = 0.4f * colour();
    row.diffuse = colour();
    if (chance(0.5f)) row.specular = colour();
    if (chance(0.2f)) row.emission = 0.3f * colour();
    if (chance(0.4f)) row.reflection = 0.5f * colour();
    if (chance(0.4f)) row.transmittance = 0.5f * colour();
    row.shadowTint = row.transmittance;
    row.shininess = chance(0.2f) ? 0 : uniform(0, 60);
    row.leastShine = leastShineOf(row.shininess);
    row.refractionIndex = uniform(1, 2);
    if (chance(0.5f)) row.texture = int32_t(below(3));
    if (chance(0.3f)) row.normalMap = int32_t(below(3));
    row.textureWrap = {Wrap(below(3)), Wrap(below(3))};
    row.normalWrap = {Wrap(below(3)), Wrap(below(3))};
    row.textureEnv = TextureEnv(below(5));
    row.textureEnvColor = colour();
  }
}

void RandomScene::makeLights() {
  const size_t count = 1 + below(3);
  for (size_t i = 0; i < count; ++i) {
    LightRow light;
    light.directional = chance(0.3f);
    light.position = light.directional ? glm::normalize(vector(1) + Vec3(0, 2, 0)) : vector(3) + Vec3(0, 4, 0);
    light.castsShadow = chance(0.8f);
    light.ambient = 0.2f * colour();
    light.diffuse = colour();
    if (chance(0.6f)) light.specular = colour();
    light.spot = !light.directional && chance(0.4f);
    light.spotDirection = normalizedOr(-light.position, {0, -1, 0});
    light.cosInner = 0.9f;
    light.cosOuter = 0.6f;
    light.spotExponent = uniform(0, 4);
    if (chance(0.4f)) light.linear = 0.1f;
    if (chance(0.3f)) light.rangeStart = 3, light.rangeEnd = 8;
    mLights.push_back(light);
  }
}

uint32_t RandomScene::randomFlags(uint32_t material) {
  uint32_t flags = 0;
  if (chance(0.6f)) flags |= kHasNormals;
  if (chance(0.3f)) flags |= kHasColors;
  if (chance(0.1f)) flags |= kTextureOnly;
  if (chance(0.3f)) flags |= kTransmittanceShadow;
  if (chance(0.3f)) flags |= kAlphaShadow;
  if (chance(0.3f)) flags |= kClockwiseFront;
  if (chance(0.2f)) flags |= chance(0.5f) ? kCullFront : kCullBack;
  if (chance(0.2f)) flags |= alphaTestFlags(uint32_t(below(8)), uniform(0, 1));
  if (mMaterials[material].normalMap != kNoTexture && chance(0.7f)) flags = (flags & ~kHasNormals) | kTangentFrame;
  return flags;
}

void RandomScene::addBall(Set &set, const Vec3 &centre, float radius, int cells) {
  const auto material = uint32_t(below(kMaterials));
  const uint32_t flags = randomFlags(material);
  for (HotTriangle t : gridSurface(cells, [&](float u, float v) {
         const float a = 3.14159265f * (0.02f + 0.96f * u), b = 6.2831853f * v;
         return centre + radius * Vec3(std::sin(a) * std::cos(b), std::cos(a), std::sin(a) * std::sin(b));
       })) {
    t.material = material;
    t.flags = flags;
    set.triangles.push_back(t);
    TriangleAttributes attributes{};
    const Vec3 corners[3] = {t.v0, t.v1, t.v2};
    for (size_t i = 0; i < 3; ++i) attributes.normal[i] = glm::normalize(corners[i] - centre);
    set.attributes.push_back(attributes);
  }
}

// Bumpy ground under everything, in one of the sets above the other.
void RandomScene::addSheet(Set &set) {
  const auto material = uint32_t(below(kMaterials));
  const uint32_t flags = randomFlags(material);
  const float y = uniform(-3.5f, -2.5f);
  for (HotTriangle t : gridSurface(6, [&](float u, float v) {
         return Vec3(10 * u - 5, y + 0.2f * std::sin(9 * u) * std::cos(7 * v), 10 * v - 5);
       })) {
    t.material = material;
    t.flags = flags;
    set.triangles.push_back(t);
    TriangleAttributes attributes{};
    for (Vec3 &normal : attributes.normal) normal = glm::normalize(Vec3(0, 1, 0) + vector(0.3f));
    set.attributes.push_back(attributes);
  }
}

void RandomScene::finish(Set &set) {
  for (size_t i = 0; i < set.triangles.size(); ++i) {
    HotTriangle &t = set.triangles[i];
    TriangleAttributes &attributes = set.attributes[i];
    setPlane(t);
    const Vec3 corners[3] = {t.v0, t.v1, t.v2};
    for (size_t k = 0; k < 3; ++k) {
      attributes.uv[k] = {0.4f * corners[k].x + 0.1f * corners[k].z, 0.3f * corners[k].y + 0.2f * corners[k].z};
      attributes.color[k] = Rgb(0.5f) + 0.5f * glm::sin(3.0f * corners[k]);
    }
    if (t.flags & kTangentFrame) {
      const Vec3 normal = glm::normalize(glm::cross(t.v1 - t.v0, t.v2 - t.v0)), tangent = glm::normalize(t.v1 - t.v0);
      attributes.normal[0] = tangent;
      attributes.normal[1] = glm::cross(normal, tangent);
      attributes.normal[2] = normal;
    }
  }
  set.accel = ddk::buildAccel(AccelKind::Bvh, set.triangles, Workers(1));
}

void RandomScene::setView() {
  for (size_t i = 0; i < 2; ++i) {
    mView.geometry[i] = {mSets[i].triangles, mSets[i].attributes, {}, mSets[i].accel.view(), false};
    for (const HotTriangle &t : mSets[i].triangles) mView.geometry[i].filtersShadow |= (t.flags & kFiltersShadow) != 0;
  }
  mView.materials = mMaterials;
  mView.textures = mTextures;
  mView.lights = mLights;
  mView.camera = {.eye = {0.3f, 0.2f, 6}, .left = -1.2f, .bottom = -0.8f, .width = 2.4f, .height = 1.6f, .near = 1.6f};
  mView.camera.parallel = chance(0.2f);
  if (mView.camera.parallel)
    mView.camera.left = -4, mView.camera.width = 8, mView.camera.bottom = -3, mView.camera.height = 6;
  mView.clearColor = colour();
  mView.maxBounces = int(below(7));
  mView.globalAmbient = 0.2f * colour();
  mView.mipmaps = chance(0.8f);
  mView.shadows = chance(0.9f);
  if (chance(0.3f)) mView.fog = {FogMode(1 + below(3)), 0.05f, 2, 20, colour()};
  if (chance(0.2f)) mView.minWeight = 0.02f;
  for (LightRow &light : mLights) light.sendsShadowRays = !light.directional && chance(0.7f);
}

}  // namespace rc::test
