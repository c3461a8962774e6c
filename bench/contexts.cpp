// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// contexts [threads [frames]]: contexts that draw at once, one on each thread of the program, against one alone: what
// they cost each other. RAYCORE_THREADS says how many workers each has. Prints processor time too, which counts
// whatever else the machine does.
#include <EGL/egl.h>
#include <RC/rc.h>
#include <RC/rcu.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <thread>
#include <vector>

namespace {

constexpr int kCells = 60, kSide = 256;

std::vector<float> sheet() {
  std::vector<float> vertices;
  for (int cell = 0; cell < kCells * kCells; ++cell) {
    for (const auto &[di, dj] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
      const auto row = cell / kCells, column = cell % kCells;
      const float x = float(row + di) / kCells - 0.5f, z = float(column + dj) / kCells - 0.5f;
      vertices.insert(vertices.end(), {2 * x, 0.2f * std::sin(9 * x) * std::cos(8 * z), 2 * z});
    }
  }
  return vertices;
}

void drawFrames(EGLDisplay display, EGLConfig config, int frames) {
  const EGLint size[] = {EGL_WIDTH, kSide, EGL_HEIGHT, kSide, EGL_NONE};
  const EGLSurface surface = eglCreatePbufferSurface(display, config, size);
  const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
  if (!eglMakeCurrent(display, surface, surface, context)) std::exit(1);
  const std::vector<float> vertices = sheet();
  rcuPerspective(50, 1, 0.1f, 100);
  rcuLookAt(0.3f, 1.5f, 2.5f, 0, 0, 0, 0, 1, 0);
  rcEnable(RC_LIGHTING);
  rcEnable(RC_LIGHT0);
  rcMaterialf(RC_FRONT_AND_BACK, RC_REFLECTION, 0.4f);
  rcEnableClientState(RC_VERTEX_ARRAY);
  for (int frame = 0; frame < frames; ++frame) {
    rcVertexPointer(3, RC_FLOAT, 0, vertices.data());
    rcDrawArrays(RC_QUADS, 0, RCsizei(vertices.size() / 3));
    if (!eglSwapBuffers(display, surface)) std::exit(1);
  }
  eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display, context);
  eglDestroySurface(display, surface);
}

struct Times {
  double wall, processor;
};

Times draw(EGLDisplay display, EGLConfig config, int threads, int frames) {
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t before = std::clock();
  std::vector<std::thread> running;
  running.reserve(size_t(threads));
  for (int i = 0; i < threads; ++i) running.emplace_back([&] { drawFrames(display, config, frames); });
  for (std::thread &thread : running) thread.join();
  return {std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
          double(std::clock() - before) / CLOCKS_PER_SEC};
}

}  // namespace

int main(int argc, char **argv) {
  const int threads = argc > 1 ? std::atoi(argv[1]) : 2, frames = argc > 2 ? std::atoi(argv[2]) : 50;
  const EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglInitialize(display, nullptr, nullptr) || !eglChooseConfig(display, nullptr, &config, 1, &count)) return 1;
  draw(display, config, threads, 3);  // warms up
  const Times alone = draw(display, config, 1, frames), together = draw(display, config, threads, frames);
  std::printf(
      "1 context: %.2f s, %.2f s of processors; %d contexts at once: %.2f s, %.2f s; processor time for each %.2f "
      "times that of one alone\n",
      alone.wall, alone.processor, threads, together.wall, together.processor,
      together.processor / threads / alone.processor);
}
