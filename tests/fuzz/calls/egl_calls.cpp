// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Calls of EGL whose pointers come with sizes, name files or windows, or may wait.
#include <string>

#include "calls/functions.h"
#include "egl/vendor_calls.h"

namespace rc::fuzz {
namespace {

// There is no X server: a native display is none, a native window null or the number of no window.
void getDisplay(const Site &site) { site.world.note(eglGetDisplay(EGL_DEFAULT_DISPLAY)); }

template <class Pointer>
void getPlatformDisplay(const Site &site) {
  const EGLenum platform = site.in.token();
  using Value = std::conditional_t<std::is_same_v<Pointer, PFNEGLGETPLATFORMDISPLAYPROC>, EGLAttrib, EGLint>;
  const Argument<const Value *> list(site);
  const auto function = reinterpret_cast<Pointer>(eglGetProcAddress(site.function.data()));
  site.world.note(function(platform, nullptr, list.value));
}

// Without a window system a null window is a surface of 800 x 480 pixels: too many for every input.
unsigned long window(Input &in) { return in.raw<uint32_t>() == 0x10203040 ? 0 : 77; }

void createWindowSurface(const Site &site) {
  void *display = site.world.handle(site.in), *config = site.world.handle(site.in);
  const auto native = window(site.in);
  const Argument<const EGLint *> list(site);
  site.world.note(eglCreateWindowSurface(display, config, native, list.value));
}

template <class Pointer, class Value>
void createPlatformSurface(const Site &site) {
  void *display = site.world.handle(site.in), *config = site.world.handle(site.in);
  unsigned long native = window(site.in);
  void *pointer = site.in.below(8) ? &native : nullptr;
  const Argument<const Value *> list(site);
  const auto function = reinterpret_cast<Pointer>(eglGetProcAddress(site.function.data()));
  site.world.note(function(display, config, pointer, list.value));
}

// Pictures are small, so that an input takes milliseconds, or too large for memory.
void createPbuffer(const Site &site) {
  void *display = site.world.handle(site.in), *config = site.world.handle(site.in);
  Argument<const EGLint *> list(site);
  for (EGLint *pair = list.memory.get(); pair && *pair != EGL_NONE; pair += 2) {
    const bool isSide = pair[0] == EGL_WIDTH || pair[0] == EGL_HEIGHT;
    if (isSide && pair[1] > 32 && pair[1] < 16384) pair[1] %= 32;
  }
  site.world.note(eglCreatePbufferSurface(display, config, list.value));
}

void chooseConfig(const Site &site) {
  void *display = site.world.handle(site.in);
  const Argument<const EGLint *> list(site);
  const EGLint size = site.in.byte() % 64 - 2;
  const std::unique_ptr<EGLConfig[]> configs(new EGLConfig[size_t(std::max(size, 0))]);
  Argument<EGLint *> count(site);
  eglChooseConfig(display, list.value, site.in.below(4) ? configs.get() : nullptr, size, count.value);
}

void getConfigs(const Site &site) {
  void *display = site.world.handle(site.in);
  const EGLint size = site.in.byte() % 64 - 2;
  const std::unique_ptr<EGLConfig[]> configs(new EGLConfig[size_t(std::max(size, 0))]);
  Argument<EGLint *> count(site);
  eglGetConfigs(display, site.in.below(4) ? configs.get() : nullptr, size, count.value);
}

// Nothing is written where somebody could miss it.
void dumpSystem(const Site &site) {
  constexpr const char *kFiles[] = {nullptr, "", "/dev/null", "/nowhere/at/all", "/"};
  void *display = site.world.handle(site.in);
  eglDumpSystemRC(display, site.in.oneOf(kFiles));
}

void getProcAddress(const Site &site) {
  if (site.in.below(8) == 0) return void(eglGetProcAddress(nullptr));
  if (site.in.flag()) return void(eglGetProcAddress(functionOf(site.in.raw<uint16_t>()).name));
  std::string name(site.in.below(32), 'e');
  for (char &c : name) c = char(site.in.byte());
  eglGetProcAddress(name.c_str());
}

template <class Pointer, class Value>
void createSync(const Site &site) {
  void *display = site.world.handle(site.in);
  const EGLenum type = site.in.below(4) ? EGL_SYNC_FENCE : site.in.token();
  const Argument<const Value *> list(site);
  const auto function = reinterpret_cast<Pointer>(eglGetProcAddress(site.function.data()));
  site.world.noteSync(function(display, type, list.value));
}

template <class Pointer>
void waitSync(const Site &site) {
  void *display = site.world.handle(site.in), *sync = site.world.handle(site.in);
  const EGLint flags = site.in.integer();
  const auto function = reinterpret_cast<Pointer>(eglGetProcAddress(site.function.data()));
  if (site.world.isOwn(sync)) function(display, sync, flags);
}

void clientWaitSync(const Site &site) {
  void *display = site.world.handle(site.in), *sync = site.world.handle(site.in);
  const EGLint flags = site.in.integer();
  const auto function = reinterpret_cast<PFNEGLCLIENTWAITSYNCPROC>(eglGetProcAddress(site.function.data()));
  function(display, sync, flags, site.in.byte());
}

void swapWithDamage(const Site &site) {
  void *display = site.world.handle(site.in), *surface = site.world.handle(site.in);
  const EGLint count = site.in.byte() % 8 - 2;
  const std::unique_ptr<EGLint[]> rectangles(new EGLint[size_t(4 * std::max(count, 1))]);
  for (EGLint i = 0; i < 4 * count; ++i) rectangles[size_t(i)] = site.in.integer();
  const auto function =
      reinterpret_cast<PFNEGLSWAPBUFFERSWITHDAMAGEKHRPROC>(eglGetProcAddress("eglSwapBuffersWithDamageKHR"));
  function(display, surface, site.in.below(4) ? rectangles.get() : nullptr, count);
}

constexpr Function kCalls[] = {
    {"eglGetDisplay", getDisplay},
    {"eglGetPlatformDisplay", getPlatformDisplay<PFNEGLGETPLATFORMDISPLAYPROC>},
    {"eglGetPlatformDisplayEXT", getPlatformDisplay<PFNEGLGETPLATFORMDISPLAYEXTPROC>},
    {"eglCreateWindowSurface", createWindowSurface},
    {"eglCreatePlatformWindowSurface", createPlatformSurface<PFNEGLCREATEPLATFORMWINDOWSURFACEPROC, EGLAttrib>},
    {"eglCreatePlatformPixmapSurface", createPlatformSurface<PFNEGLCREATEPLATFORMPIXMAPSURFACEPROC, EGLAttrib>},
    {"eglCreatePlatformWindowSurfaceEXT", createPlatformSurface<PFNEGLCREATEPLATFORMWINDOWSURFACEEXTPROC, EGLint>},
    {"eglCreatePlatformPixmapSurfaceEXT", createPlatformSurface<PFNEGLCREATEPLATFORMPIXMAPSURFACEEXTPROC, EGLint>},
    {"eglCreatePbufferSurface", createPbuffer},
    {"eglChooseConfig", chooseConfig},
    {"eglGetConfigs", getConfigs},
    {"eglDumpSystemRC", dumpSystem},
    {"eglGetProcAddress", getProcAddress},
    {"eglCreateSync", createSync<PFNEGLCREATESYNCPROC, EGLAttrib>},
    {"eglCreateSyncKHR", createSync<PFNEGLCREATESYNCKHRPROC, EGLint>},
    {"eglWaitSync", waitSync<PFNEGLWAITSYNCPROC>},
    {"eglWaitSyncKHR", waitSync<PFNEGLWAITSYNCKHRPROC>},
    {"eglClientWaitSync", clientWaitSync},
    {"eglClientWaitSyncKHR", clientWaitSync},
    {"eglSwapBuffersWithDamageKHR", swapWithDamage},
};

}  // namespace

std::span<const Function> eglCalls() { return kCalls; }

}  // namespace rc::fuzz
