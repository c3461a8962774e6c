// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Any sequence of calls, of every function of the library, with any arguments that a program can give: wild tokens,
// numbers, names and handles, and pointers that are null or as good as a correct program's. Several contexts, shared
// or not, on two threads that take turns or run at the same time. Pictures are small, and really traced.
#include "calls/functions.h"

namespace rc::fuzz {
namespace {

constexpr size_t kMostSteps = 160;

struct Steps {
  World &world;
  Input &in;
};

// A call of any function.
void call(Steps &steps) {
  const Function &function = functionOf(steps.in.raw<uint16_t>());
  function.call({steps.world, steps.in, function.name});
}

// What a program does first: a context and a surface, perhaps one to be used as a texture, current on this thread.
void begin(Steps &steps) {
  constexpr uint8_t kForTexture = 0x80;
  EGLint list[] = {EGL_WIDTH,
                   EGLint(12 + steps.in.below(16)),
                   EGL_HEIGHT,
                   12,
                   EGL_TEXTURE_FORMAT,
                   EGL_NO_TEXTURE,
                   EGL_TEXTURE_TARGET,
                   EGL_NO_TEXTURE,
                   EGL_NONE};
  const uint8_t choice = steps.in.byte();
  if (choice & kForTexture) list[1] = list[3] = 16, list[5] = EGL_TEXTURE_RGB, list[7] = EGL_TEXTURE_2D;
  const EGLDisplay display = steps.world.display(choice);
  const EGLConfig config = steps.world.config(steps.in.byte());
  eglInitialize(display, nullptr, nullptr);
  const EGLContext share = steps.in.flag() ? eglGetCurrentContext() : EGL_NO_CONTEXT;
  const EGLSurface surface = eglCreatePbufferSurface(display, config, list);
  const EGLContext context = eglCreateContext(display, config, share, nullptr);
  steps.world.note(surface);
  steps.world.note(context);
  eglMakeCurrent(display, surface, surface, context);
  rcuPerspective(60, 1.5f, 1, 100);
  rcuLookAt(0, 0, 3, 0, 0, 0, 0, 1, 0);
}

void makeCurrent(Steps &steps) {
  void *display = steps.world.handle(steps.in), *surface = steps.world.handle(steps.in);
  void *context = steps.world.handle(steps.in);
  eglMakeCurrent(display, surface, surface, context);
}

void swap(Steps &) { eglSwapBuffers(eglGetCurrentDisplay(), eglGetCurrentSurface(EGL_DRAW)); }

// Triangles before the eye.
void draw(Steps &steps) {
  static constexpr float kCorners[] = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0, 0, 0, 1, 0, 1, -1};
  rcBindBuffer(RC_ARRAY_BUFFER, 0);
  rcEnableClientState(RC_VERTEX_ARRAY);
  rcVertexPointer(3, RC_FLOAT, 0, nullptr);
  const auto count = RCsizei(std::min<uint64_t>(6, World::drawable()));  // as the other arrays allow
  rcVertexPointer(3, RC_FLOAT, 0, kCorners);
  rcDrawArrays(steps.in.flag() ? RC_TRIANGLES : RC_QUADS, 0, count);
  rcVertexPointer(3, RC_FLOAT, 0, World::vertices(4 * size_t{steps.in.byte()}));
}

void loadTexture(Steps &steps) {
  RCubyte texels[16 * 16 * 4];
  Spread random(steps.in.byte());
  for (RCubyte &texel : texels) texel = RCubyte(random.next());
  constexpr uint8_t kWithAlpha = 1, kSixteenths = 2;
  const uint8_t kind = steps.in.byte();
  const RCenum format = kind & kWithAlpha ? RC_RGBA : RC_RGB;
  if (kind & kSixteenths) {
    for (size_t alpha = 3; alpha < sizeof texels; alpha += 4) texels[alpha] %= 17;  // there in part: see opaqueAlpha
  }
  rcEnable(RC_TEXTURE_2D);
  // 16 texels are a multiple of every alignment.
  rcTexImage2D(RC_TEXTURE_2D, 0, RCint(format), 16, 16, 0, format, RC_UNSIGNED_BYTE, texels);
}

// Everything that can be asked for by the tokens of a page; the first page is that of our extensions.
void ask(Steps &steps) {
  constexpr RCenum kExtensions = 0x52430000, kPage = 64;
  const auto page = RCenum(steps.in.below(65536 / kPage));
  const uint8_t way = steps.in.byte();
  const RCenum first = page == 0 ? kExtensions : page * kPage;
  for (RCenum token = first; token < first + kPage; ++token) {
    RCfloat floats[64];
    RCint integers[64];
    RCfixed fixed[64];
    RCboolean booleans[64];
    if (way & 1) rcGetFloatv(token, floats);
    if (way & 2) rcGetIntegerv(token, integers);
    if (way & 4) rcGetFixedv(token, fixed);
    if (way & 8) rcGetBooleanv(token, booleans);
    if (way & 16) rcIsEnabled(token), rcGetString(token);
    if (way & 32) rcGetTexParameteriv(RC_TEXTURE_2D, token, integers), rcGetTexEnvfv(RC_TEXTURE_ENV, token, floats);
    if (way & 64) rcGetLightfv(RC_LIGHT0, token, floats), rcGetMaterialfv(RC_FRONT, token, floats);
    if (way & 128) rcGetBufferParameteriv(RC_ARRAY_BUFFER, token, integers);
  }
}

constexpr void (*kSteps[])(Steps &) = {begin, makeCurrent, swap, draw, loadTexture};
constexpr uint8_t kFirstPrepared = 224;  // smaller codes are plain calls
constexpr uint8_t kQuestion = 250;

void step(Steps &steps) {
  const uint8_t code = steps.in.byte();
  if (code == kQuestion) return ask(steps);
  code < kFirstPrepared ? call(steps) : kSteps[code % std::size(kSteps)](steps);
}

void runAll(World &world, Input in) {
  Steps steps{world, in};
  begin(steps);
  for (size_t i = 0; i < kMostSteps && !in.empty(); ++i) step(steps);
  eglReleaseThread();
}

// Steps of both threads, one after the other; a turn is a few steps.
void runInTurns(World &world, Worker &worker, Input in) {
  Steps steps{world, in};
  begin(steps);
  size_t count = 0;
  const auto turn = [&] {
    for (size_t n = 1 + in.below(16); n > 0 && count < kMostSteps && !in.empty(); --n, ++count) step(steps);
  };
  while (count < kMostSteps && !in.empty()) {
    turn();
    worker.run(turn);
  }
  worker.run([] { eglReleaseThread(); });
}

enum Mode { kAlone, kTurns, kTogether };

Mode modeOf(uint8_t code) { return code < 192 ? kAlone : code < 240 ? kTurns : kTogether; }

}  // namespace

void run(Input in) {
  static Worker &worker = *new Worker;  // it waits when the process ends
  const uint8_t *data = in.data();
  const size_t size = in.left();
  const Mode mode = modeOf(in.byte());
  World world;
  switch (mode) {
    case kAlone:
      return runAll(world, in);
    case kTurns:
      return runInTurns(world, worker, in);
    case kTogether: {
      const size_t half = size / 2;
      worker.start([&] { runAll(world, Input(data + half, size - half)); });
      runAll(world, Input(data, half));
      worker.await();
    }
  }
}

}  // namespace rc::fuzz
