// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "frames/stage.h"

#include <EGL/egl.h>
#include <RC/rcu.h>

#include <array>
#include <cstdio>
#include <cstdlib>

#include "base/stopwatch.h"

namespace rc::bench {
Stage::Stage(const FrameScene &scene, int width, int height, int threads)
    : mScene(scene), mWidth(width), mHeight(height) {
  setenv("RAYCORE_THREADS", std::to_string(threads).c_str(), 1);
  const EGLint size[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
  mDisplay = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  EGLConfig config;
  EGLint count = 0;
  if (!eglInitialize(mDisplay, nullptr, nullptr) || !eglChooseConfig(mDisplay, nullptr, &config, 1, &count) ||
      !(mSurface = eglCreatePbufferSurface(mDisplay, config, size)) ||
      !(mContext = eglCreateContext(mDisplay, config, EGL_NO_CONTEXT, nullptr)) ||
      !eglMakeCurrent(mDisplay, mSurface, mSurface, mContext)) {
    std::fprintf(stderr, "EGL error 0x%04X\n", unsigned(eglGetError()));
    std::exit(1);
  }
  setUp();
}

Stage::~Stage() {
  eglMakeCurrent(mDisplay, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(mDisplay, mContext);
  eglDestroySurface(mDisplay, mSurface);
}

void Stage::setUp() {
  const Camera &camera = mScene.camera;
  static const float ambient[] = {0.15f, 0.15f, 0.15f, 1}, white[] = {1, 1, 1, 1};
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
  rcClearColor(0.1f, 0.15f, 0.25f, 1);
  rcuPerspective(camera.degrees, float(mWidth) / float(mHeight), 0.01f, 10000);
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
  return name;
}

void Stage::drawMesh(const Mesh &mesh, const std::vector<Vec3> &vertices, RCuint material) const {
  rcBindMaterial(material);
  rcEnableClientState(RC_VERTEX_ARRAY);
  rcVertexPointer(3, RC_FLOAT, 0, vertices.data());
  if (!mesh.normals.empty()) {
    rcEnableClientState(RC_NORMAL_ARRAY);
    rcNormalPointer(RC_FLOAT, 0, mesh.normals.data());
  }
  rcDrawArrays(RC_TRIANGLES, 0, RCsizei(vertices.size()));
  rcDisableClientState(RC_NORMAL_ARRAY);
}

FrameTimes Stage::draw(int frame) {
  mDeformed.resize(mScene.moving.size());
  for (size_t i = 0; i < mDeformed.size(); ++i) deform(mScene.moving[i], frame, mDeformed[i]);
  FrameTimes times;
  const Stopwatch submitting;
  for (size_t i = 0; i < mDeformed.size(); ++i) drawMesh(mScene.moving[i], mDeformed[i], mMovingMaterial);
  if (mScene.moving.empty()) rcClearColor(0.1f, 0.15f, frame % 2 ? 0.25f : 0.26f, 1);  // else nothing has changed
  times.submit = submitting.milliseconds();
  const Stopwatch finishing;
  rcFinish();
  times.finish = finishing.milliseconds();
  return times;
}

double Stage::rays() const {
  RCfloat rays = 0;
  rcGetFloatv(RC_FRAME_RAYS, &rays);
  return double(rays);
}

void Stage::save(const std::string &path) const {
  std::vector<unsigned char> pixels(size_t(mWidth) * size_t(mHeight) * 4);
  rcReadPixels(0, 0, mWidth, mHeight, RC_RGBA, RC_UNSIGNED_BYTE, pixels.data());
  std::FILE *file = std::fopen(path.c_str(), "wb");
  if (!file) return std::perror(path.c_str());
  std::fprintf(file, "P6\n%d %d\n255\n", mWidth, mHeight);
  for (int y = mHeight - 1; y >= 0; --y) {
    for (int x = 0; x < mWidth; ++x) std::fwrite(&pixels[4 * (size_t(y) * size_t(mWidth) + size_t(x))], 1, 3, file);
  }
  std::fclose(file);
}

}  // namespace rc::bench
