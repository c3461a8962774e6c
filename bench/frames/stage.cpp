// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "frames/stage.h"

#include <RC/rcu.h>

#include <array>

#include "base/stopwatch.h"

namespace rc::bench {

Stage::Stage(const FrameScene &scene, int width, int height) : mScene(scene), mScreen(width, height) { setUp(); }

void Stage::setUp() {
  const Camera &camera = mScene.camera;
  static const float ambient[] = {kAmbient, kAmbient, kAmbient, 1}, white[] = {1, 1, 1, 1};
  rcEnable(RC_LIGHTING);
  for (size_t i = 0; i < mScene.lights.size(); ++i) {
    const auto light = RCenum(RC_LIGHT0 + i);
    const float position[] = {mScene.lights[i].x, mScene.lights[i].y, mScene.lights[i].z, 1};
    rcEnable(light);
    rcLightfv(light, RC_POSITION, position);
    rcLightfv(light, RC_AMBIENT, ambient);
    rcLightfv(light, RC_DIFFUSE, white);
    rcLightfv(light, RC_SPECULAR, white);
  }
  rcClearColor(kBackground.x, kBackground.y, kBackground.z, 1);
  rcuPerspective(camera.degrees, float(mScreen.width()) / float(mScreen.height()), 0.01f, 10000);
  rcuLookAt(camera.eye.x, camera.eye.y, camera.eye.z, camera.at.x, camera.at.y, camera.at.z, 0, 1, 0);
  rcDepthBounce(mScene.bounces);
  rcStaticSceneBegin();
  for (const Mesh &mesh : mScene.meshes) drawMesh(mesh, mesh.vertices, makeMaterial(mesh.surface));
  rcStaticSceneEnd();
  if (!mScene.moving.empty()) mMovingMaterial = makeMaterial(mScene.moving[0].surface);
}

RCuint Stage::makeMaterial(const Surface &surface) const {
  RCuint name = 0;
  rcGenMaterials(1, &name);
  rcBindMaterial(name);
  const auto grey = [](float value) { return std::array{value, value, value, 1.0f}; };
  const float colour[] = {surface.colour.x, surface.colour.y, surface.colour.z, 1};
  rcMaterialfv(RC_FRONT_AND_BACK, RC_AMBIENT_AND_DIFFUSE, colour);
  rcMaterialfv(RC_FRONT_AND_BACK, RC_SPECULAR, grey(surface.specular).data());
  rcMaterialf(RC_FRONT_AND_BACK, RC_SHININESS, surface.shininess);
  rcMaterialfv(RC_FRONT_AND_BACK, RC_REFLECTION, grey(surface.reflection).data());
  rcMaterialfv(RC_FRONT_AND_BACK, RC_TRANSMITTANCE, grey(surface.transmittance).data());
  rcMaterialf(RC_FRONT_AND_BACK, RC_REFRACTION_INDEX, surface.refractionIndex);
  return name;
}

void Stage::drawMesh(const Mesh &mesh, const std::vector<Vec3> &vertices, RCuint material) const {
  rcBindMaterial(material);
  (mesh.surface.transmittance > 0 ? rcEnable : rcDisable)(RC_USE_TRANSMITTANCE_SHADOW);
  rcEnableClientState(RC_VERTEX_ARRAY);
  rcVertexPointer(3, RC_FLOAT, 0, vertices.data());
  if (!mesh.normals.empty()) {
    rcEnableClientState(RC_NORMAL_ARRAY);
    rcNormalPointer(RC_FLOAT, 0, mesh.normals.data());
  }
  rcDrawArrays(RC_TRIANGLES, 0, RCsizei(vertices.size()));
  rcDisableClientState(RC_NORMAL_ARRAY);
}

void Stage::deformAll(int frame) {
  mDeformed.resize(mScene.moving.size());
  for (size_t i = 0; i < mDeformed.size(); ++i) deform(mScene.moving[i], frame, mDeformed[i]);
}

void Stage::submit(int frame) const {
  for (size_t i = 0; i < mDeformed.size(); ++i) drawMesh(mScene.moving[i], mDeformed[i], mMovingMaterial);
  // Else nothing has changed.
  const float blue = kBackground.z + (frame % 2 ? 0 : 0.01f);
  if (mScene.moving.empty()) rcClearColor(kBackground.x, kBackground.y, blue, 1);
}

FrameTimes Stage::draw(int frame) {
  deformAll(frame);
  FrameTimes times;
  const Stopwatch submitting;
  submit(frame);
  times.submit = submitting.milliseconds();
  const Stopwatch finishing;
  rcFinish();
  times.finish = finishing.milliseconds();
  return times;
}

double Stage::film(int first, int frames, bool finishes) {
  const Stopwatch watch;
  for (int frame = first; frame < first + frames; ++frame) {
    deformAll(frame);
    submit(frame);
    if (finishes) rcFinish();
    mScreen.swap();
  }
  mScreen.wait();
  return watch.milliseconds() / frames;
}

double Stage::rays() const {
  RCfloat rays = 0;
  rcGetFloatv(RC_FRAME_RAYS, &rays);
  return double(rays);
}

}  // namespace rc::bench
