// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "api/thirty_scenes.h"

#include "RC/rc.h"
#include "RC/rcu.h"
#include "api/context.h"
#include "base/instruction_set.h"
#include "rcddi/random_scenes.h"

namespace rc::test {
namespace {

using Pixels = std::vector<uint32_t>;

struct Memory final : api::DrawSurface {
  hal::Target backBuffer() override { return {pixels.data(), kSceneWidth, kSceneHeight}; }

  Pixels pixels = Pixels(kScenePixels);
};

Pixels randomPicture(uint32_t number, int framesBefore) {
  const auto device = hal::createDevice("cpu", settings().threads);
  Memory memory;
  for (int i = framesBefore; i >= 0; --i) {
    const RandomScene scene(number + uint32_t(i));
    hal::SceneView view = scene.view();
    view.camera.columns = kSceneWidth;
    view.camera.rows = kSceneHeight;
    device->trace(view, memory.backBuffer());
  }
  return memory.pixels;
}

void draw(const Triangles &triangles) {
  std::vector<float> vertices;
  for (const hal::HotTriangle &t : triangles) {
    for (const Vec3 &v : {t.v0, t.v1, t.v2}) vertices.insert(vertices.end(), {v.x, v.y, v.z});
  }
  rcEnableClientState(RC_VERTEX_ARRAY);
  rcVertexPointer(3, RC_FLOAT, 0, vertices.data());
  rcDrawArrays(RC_TRIANGLES, 0, RCsizei(vertices.size() / 3));
  rcVertexPointer(3, RC_FLOAT, 0, nullptr);
}

void setStage() {
  static const float position[] = {2, 4, 3, 1}, diffuse[] = {0.8f, 0.75f, 0.6f};
  rcEnable(RC_LIGHTING);
  rcEnable(RC_LIGHT0);
  rcLightfv(RC_LIGHT0, RC_POSITION, position);
  rcLightfv(RC_LIGHT0, RC_DIFFUSE, diffuse);
  rcClearColor(0.2f, 0.3f, 0.4f, 1);
  rcuPerspective(50, float(kSceneWidth) / kSceneHeight, 0.1f, 100);
  rcuLookAt(0.5f, 1.5f, 2.5f, 0.5f, 0, 0, 0, 1, 0);
}

struct ApiScene {
  RCenum structure;
  int cells;  // 20000 triangles are built in parallel; few are fitted to the last frame's tree
  bool isStatic;
  bool glass;
  RCenum rendering;
};

constexpr ApiScene kBuilt[kApiScenes] = {
    {RC_STRUCTURE_BVH, 100, true, false, RC_DONT_CARE},    {RC_STRUCTURE_KD_TREE, 100, true, false, RC_DONT_CARE},
    {RC_STRUCTURE_BVH, 100, false, false, RC_DONT_CARE},   {RC_STRUCTURE_BVH, 20, false, true, RC_NICEST},
    {RC_STRUCTURE_KD_TREE, 20, false, true, RC_DONT_CARE}, {RC_STRUCTURE_BVH, 30, true, true, RC_FASTEST_AND_NICEST},
};

void drawScene(const ApiScene &scene, float time) {
  const float shares[] = {scene.glass ? 0.4f : 0, scene.glass ? 0.3f : 0};
  if (scene.isStatic) rcStaticSceneBegin();
  rcMaterialf(RC_FRONT_AND_BACK, RC_REFLECTION, shares[0]);
  rcMaterialf(RC_FRONT_AND_BACK, RC_TRANSMITTANCE, shares[1]);
  rcPushMatrix();
  rcRotatef(40 * time, 0, 1, 0);
  draw(knot(scene.cells));
  rcPopMatrix();
  rcMaterialf(RC_FRONT_AND_BACK, RC_REFLECTION, 0);
  rcMaterialf(RC_FRONT_AND_BACK, RC_TRANSMITTANCE, 0);
  draw(terrain(scene.cells));
  if (scene.isStatic) rcStaticSceneEnd();
}

Pixels apiPicture(const ApiScene &scene, int framesBefore) {
  api::Context context(settings());
  Memory memory;
  context.attach(&memory);
  api::setCurrentContext(&context);
  setStage();
  rcHint(RC_STRUCTURE_HINT, scene.structure);
  rcHint(RC_RENDERING_HINT, scene.rendering);
  for (int i = framesBefore; i >= 0; --i) {
    drawScene(scene, 0.1f * float(i));
    rcFinish();
    context.endFrame();
  }
  api::setCurrentContext(nullptr);
  return memory.pixels;
}

}  // namespace

std::vector<uint32_t> pictureOfScene(int scene, int framesBefore) {
  limitInstructionSet(settings().instructionSet);
  if (scene < kRandomScenes) return randomPicture(uint32_t(scene * kRandomStep) + 1, framesBefore);
  return apiPicture(kBuilt[scene - kRandomScenes], framesBefore);
}

}  // namespace rc::test
