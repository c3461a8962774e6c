// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Contexts: an EGL pbuffer without any display, current in the thread that enters the `with` block.
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include "core.h"

namespace raycore {
namespace {

EGLDisplay display() {
  const EGLDisplay shown = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
  if (!eglInitialize(shown, nullptr, nullptr)) throw std::runtime_error("EGL cannot be initialised");
  return shown;
}

[[noreturn]] void failed(const char *call) {
  char text[64];
  std::snprintf(text, sizeof text, "%s failed: EGL error 0x%04X", call, static_cast<unsigned>(eglGetError()));
  throw std::runtime_error(text);
}

EGLConfig configWith(EGLDisplay on, int samples) {
  const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT,
                           EGL_RED_SIZE,     8,
                           EGL_GREEN_SIZE,   8,
                           EGL_BLUE_SIZE,    8,
                           EGL_ALPHA_SIZE,   8,
                           EGL_SAMPLES,      samples > 1 ? samples : 0,
                           EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglChooseConfig(on, wanted, &config, 1, &count) || count < 1) {
    throw py::value_error("samples: 1, 4, 8 or 16 expected, got " + std::to_string(samples));
  }
  return config;
}

struct Current {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLSurface surface = EGL_NO_SURFACE;
  EGLContext context = EGL_NO_CONTEXT;

  static Current get() { return {eglGetCurrentDisplay(), eglGetCurrentSurface(EGL_DRAW), eglGetCurrentContext()}; }
  bool make() const { return eglMakeCurrent(display, surface, surface, context); }
};

class Context {
 public:
  Context(int width, int height, int samples, const Context *share) : mWidth(width), mHeight(height) {
    if (width < 1 || height < 1 || width > kLargest || height > kLargest) {
      throw py::value_error("width, height: 1 ... 16384 expected, got " + std::to_string(width) + ", " +
                            std::to_string(height));
    }
    mOwn.display = display();
    const EGLConfig config = configWith(mOwn.display, samples);
    const EGLint size[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
    mOwn.surface = eglCreatePbufferSurface(mOwn.display, config, size);
    if (mOwn.surface == EGL_NO_SURFACE) failed("eglCreatePbufferSurface");
    mOwn.context = eglCreateContext(mOwn.display, config, share ? share->mOwn.context : EGL_NO_CONTEXT, nullptr);
    if (mOwn.context == EGL_NO_CONTEXT) failed("eglCreateContext");
  }
  Context(const Context &) = delete;
  ~Context() { close(); }

  Context &enter() {
    if (mOwn.context == EGL_NO_CONTEXT) throw std::runtime_error("the context is closed");
    mBefore = Current::get();
    if (!mOwn.make()) failed("eglMakeCurrent");
    hearErrors();
    return *this;
  }

  void exit() {
    if (mBefore.context != EGL_NO_CONTEXT) {
      mBefore.make();
    } else {
      eglMakeCurrent(mOwn.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    mBefore = {};
  }

  void close() {
    if (mOwn.context == EGL_NO_CONTEXT) return;
    if (eglGetCurrentContext() == mOwn.context) exit();
    forgetArrays(mOwn.context);
    eglDestroyContext(mOwn.display, mOwn.context);
    if (mOwn.surface != EGL_NO_SURFACE) eglDestroySurface(mOwn.display, mOwn.surface);
    mOwn = {};
  }

  // The end of the frame, as at eglSwapBuffers: dynamic geometry ends here.
  void swap() {
    if (eglGetCurrentContext() != mOwn.context) throw std::runtime_error("the context is not current");
    const bool done = eglSwapBuffers(mOwn.display, mOwn.surface);
    throwIfFailed();
    if (!done) failed("eglSwapBuffers");
  }

  int width() const { return mWidth; }
  int height() const { return mHeight; }

 private:
  static constexpr int kLargest = 16384;
  int mWidth, mHeight;
  Current mOwn, mBefore;
};

}  // namespace

void addContext(py::module_ &module) {
  using namespace py::literals;
  py::class_<Context>(module, "Context", "A context with a picture of width x height pixels in memory.")
      .def(py::init<int, int, int, const Context *>(), "width"_a = 800, "height"_a = 480, "samples"_a = 1,
           "share"_a = nullptr)
      .def("__enter__", &Context::enter, py::return_value_policy::reference)
      .def("__exit__", [](Context &context, const py::args &) { context.exit(); })
      .def("make_current", [](Context &context) { context.enter(); })
      .def("close", &Context::close)
      .def("swap", &Context::swap, "Ends the frame: what was drawn outside a static scene is gone afterwards.")
      .def_property_readonly("width", &Context::width)
      .def_property_readonly("height", &Context::height);
}

}  // namespace raycore
