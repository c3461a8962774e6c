// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// random_scenes.h: scenes of everything that shading knows, chosen by a number: lights of all kinds, mirrors, glass in
// glass, textures with holes, normal maps, vertex colours, culled sides, fog; static and dynamic triangles.
#pragma once

#include "common/meshes.h"

namespace rc::test {

class RandomScene {
 public:
  explicit RandomScene(uint32_t number);
  RandomScene(const RandomScene &) = delete;
  RandomScene &operator=(const RandomScene &) = delete;

  const hal::SceneView &view() const { return mView; }

 private:
  struct Set {
    Triangles triangles;
    std::vector<hal::TriangleAttributes> attributes;
    ddk::Accel accel;
  };

  float uniform(float least, float most) { return std::uniform_real_distribution<float>(least, most)(mRandom); }
  bool chance(float share) { return uniform(0, 1) < share; }
  size_t below(size_t count) { return size_t(uniform(0, float(count))) % count; }
  Vec3 vector(float size);
  Rgb colour() { return {uniform(0, 1), uniform(0, 1), uniform(0, 1)}; }

  void makeTextures();
  void makeMaterials();
  void makeLights();
  void addBall(Set &set, const Vec3 &centre, float radius, int cells);
  void addSheet(Set &set);
  void finish(Set &set);
  uint32_t randomFlags(uint32_t material);
  void setView();

  std::mt19937 mRandom;
  std::vector<std::vector<uint32_t>> mTexels;
  std::vector<hal::TextureView> mTextures;
  std::vector<hal::MaterialRow> mMaterials{hal::kNamedMaterials};
  std::vector<hal::LightRow> mLights;
  std::array<Set, 2> mSets;
  hal::SceneView mView;
};

}  // namespace rc::test
