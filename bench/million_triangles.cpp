// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// A landscape of a million triangles as a static scene, one frame of 800 x 480, through the public API.
// Prints how long each step takes and the peak of memory; ends with code 1 above 2 GiB, or if nothing is seen.
// Arguments: number of triangles. RAYCORE_ACCEL chooses the structure.
#include <EGL/egl.h>
#include <RC/rc.h>
#include <RC/rcu.h>
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

double millisecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

bool makeContext() {
  const EGLint size[] = {EGL_WIDTH, 800, EGL_HEIGHT, 480, EGL_NONE};
  const EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  EGLConfig config;
  EGLint count = 0;
  if (!eglInitialize(display, nullptr, nullptr) || !eglChooseConfig(display, nullptr, &config, 1, &count)) return false;
  const EGLSurface surface = eglCreatePbufferSurface(display, config, size);
  return eglMakeCurrent(display, surface, surface, eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr));
}

void makeLandscape(int cells, std::vector<float> &vertices, std::vector<RCuint> &indices) {
  const int side = cells + 1;
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      const float x = float(i) / float(cells) * 20 - 10, z = float(j) / float(cells) * 20 - 10;
      vertices.insert(vertices.end(), {x, std::sin(x) * std::cos(1.3f * z) + 0.1f * std::sin(9 * x + 7 * z), z});
    }
  }
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      const RCuint a = RCuint(i * side + j), b = a + 1, c = a + RCuint(side), d = c + 1;
      indices.insert(indices.end(), {a, b, d, a, d, c});
    }
  }
}

void setLight() {
  static const float direction[] = {1, 1, 0.5f, 0}, ambient[] = {0.3f, 0.3f, 0.35f}, diffuse[] = {0.8f, 0.75f, 0.6f};
  rcEnable(RC_LIGHTING);
  rcEnable(RC_LIGHT0);
  rcLightfv(RC_LIGHT0, RC_POSITION, direction);
  rcLightfv(RC_LIGHT0, RC_AMBIENT, ambient);
  rcLightfv(RC_LIGHT0, RC_DIFFUSE, diffuse);
}

}  // namespace

int main(int argc, char **argv) {
  const int wanted = argc > 1 ? std::atoi(argv[1]) : 1000000;
  if (wanted < 2) return std::fprintf(stderr, "usage: %s [number of triangles, at least 2]\n", argv[0]), 2;
  if (!makeContext()) return std::fprintf(stderr, "EGL error 0x%04X\n", unsigned(eglGetError())), 1;
  std::vector<float> vertices;
  std::vector<RCuint> indices;
  makeLandscape(int(std::ceil(std::sqrt(wanted / 2.0))), vertices, indices);
  setLight();
  rcuLookAt(0, 4, 12, 0, 0, 0, 0, 1, 0);

  auto start = std::chrono::steady_clock::now();
  rcStaticSceneBegin();
  rcEnableClientState(RC_VERTEX_ARRAY);
  rcVertexPointer(3, RC_FLOAT, 0, vertices.data());
  rcDrawElements(RC_TRIANGLES, RCsizei(indices.size()), RC_UNSIGNED_INT, indices.data());
  const double submit = millisecondsSince(start);
  start = std::chrono::steady_clock::now();
  rcStaticSceneEnd();
  const double build = millisecondsSince(start);
  start = std::chrono::steady_clock::now();
  rcFinish();
  const double trace = millisecondsSince(start);

  RCint triangles = 0, rays = 0;
  rcGetIntegerv(RC_FRAME_TRIANGLES, &triangles);
  rcGetIntegerv(RC_FRAME_RAYS, &rays);
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const double mebibytes = double(usage.ru_maxrss) / 1024;
  std::printf("%d triangles: submit %.0f ms, build %.0f ms, trace %.0f ms (%d rays), peak memory %.0f MiB\n", triangles,
              submit, build, trace, rays, mebibytes);
  return mebibytes < 2048 && rays > 800 * 480 ? 0 : 1;
}
