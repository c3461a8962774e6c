// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Each error that the specification lists for each function, as a table: a call that must fail, and how.
#include <functional>

#include "RC/rc.h"
#include "egl/egl_fixture.h"

namespace rc::test {
namespace {

// What the calls are made with: all of it valid, nothing current.
struct World {
  EGLDisplay display, other;  // other: not initialised
  EGLConfig config, opaque;   // opaque: without alpha
  EGLSurface surface, texture;
  EGLContext context;
};

struct Case {
  const char *call;
  EGLint error;
  std::function<bool(const World &)> succeeds;
};

const EGLint kUnknown[] = {0x7777, 1, EGL_NONE};
const EGLAttrib kUnknownWide[] = {0x7777, 1, EGL_NONE};
EGLint gValue;
EGLAttrib gWide;

// Every function that takes a display, with nothing wrong but the display.
struct DisplayCase {
  const char *name;
  std::function<bool(EGLDisplay)> call;
};
const DisplayCase kDisplayCases[] = {
    {"eglBindTexImage", [](EGLDisplay d) { return eglBindTexImage(d, nullptr, EGL_BACK_BUFFER); }},
    {"eglChooseConfig", [](EGLDisplay d) { return eglChooseConfig(d, nullptr, nullptr, 0, &gValue); }},
    {"eglClientWaitSync", [](EGLDisplay d) { return eglClientWaitSync(d, nullptr, 0, 0) != EGL_FALSE; }},
    {"eglCopyBuffers", [](EGLDisplay d) { return eglCopyBuffers(d, nullptr, 0); }},
    {"eglCreateContext", [](EGLDisplay d) { return eglCreateContext(d, nullptr, nullptr, nullptr) != nullptr; }},
    {"eglCreateImage",
     [](EGLDisplay d) { return eglCreateImage(d, nullptr, EGL_GL_TEXTURE_2D, nullptr, nullptr) != nullptr; }},
    {"eglCreatePbufferFromClientBuffer",
     [](EGLDisplay d) {
       return eglCreatePbufferFromClientBuffer(d, EGL_OPENVG_IMAGE, nullptr, nullptr, nullptr) != nullptr;
     }},
    {"eglCreatePbufferSurface", [](EGLDisplay d) { return eglCreatePbufferSurface(d, nullptr, nullptr) != nullptr; }},
    {"eglCreatePixmapSurface", [](EGLDisplay d) { return eglCreatePixmapSurface(d, nullptr, 0, nullptr) != nullptr; }},
    {"eglCreatePlatformPixmapSurface",
     [](EGLDisplay d) { return eglCreatePlatformPixmapSurface(d, nullptr, nullptr, nullptr) != nullptr; }},
    {"eglCreatePlatformWindowSurface",
     [](EGLDisplay d) { return eglCreatePlatformWindowSurface(d, nullptr, nullptr, nullptr) != nullptr; }},
    {"eglCreateSync", [](EGLDisplay d) { return eglCreateSync(d, EGL_SYNC_FENCE, nullptr) != nullptr; }},
    {"eglCreateWindowSurface", [](EGLDisplay d) { return eglCreateWindowSurface(d, nullptr, 0, nullptr) != nullptr; }},
    {"eglDestroyContext", [](EGLDisplay d) { return eglDestroyContext(d, nullptr); }},
    {"eglDestroyImage", [](EGLDisplay d) { return eglDestroyImage(d, nullptr); }},
    {"eglDestroySurface", [](EGLDisplay d) { return eglDestroySurface(d, nullptr); }},
    {"eglDestroySync", [](EGLDisplay d) { return eglDestroySync(d, nullptr); }},
    {"eglGetConfigAttrib", [](EGLDisplay d) { return eglGetConfigAttrib(d, nullptr, EGL_RED_SIZE, &gValue); }},
    {"eglGetConfigs", [](EGLDisplay d) { return eglGetConfigs(d, nullptr, 0, &gValue); }},
    {"eglGetSyncAttrib", [](EGLDisplay d) { return eglGetSyncAttrib(d, nullptr, EGL_SYNC_TYPE, &gWide); }},
    {"eglMakeCurrent", [](EGLDisplay d) { return eglMakeCurrent(d, nullptr, nullptr, kNothing); }},
    {"eglQueryContext", [](EGLDisplay d) { return eglQueryContext(d, nullptr, EGL_CONFIG_ID, &gValue); }},
    {"eglQueryString", [](EGLDisplay d) { return eglQueryString(d, EGL_VENDOR) != nullptr; }},
    {"eglQuerySurface", [](EGLDisplay d) { return eglQuerySurface(d, nullptr, EGL_WIDTH, &gValue); }},
    {"eglReleaseTexImage", [](EGLDisplay d) { return eglReleaseTexImage(d, nullptr, EGL_BACK_BUFFER); }},
    {"eglSurfaceAttrib", [](EGLDisplay d) { return eglSurfaceAttrib(d, nullptr, EGL_MIPMAP_LEVEL, 0); }},
    {"eglSwapBuffers", [](EGLDisplay d) { return eglSwapBuffers(d, nullptr); }},
    {"eglSwapInterval", [](EGLDisplay d) { return eglSwapInterval(d, 1); }},
    {"eglWaitSync", [](EGLDisplay d) { return eglWaitSync(d, nullptr, 0); }},
};

template <EGLint... Values>
const EGLint *list() {
  static const EGLint values[] = {Values..., EGL_NONE};
  return values;
}

bool made(EGLSurface surface) { return surface != EGL_NO_SURFACE; }
bool pbufferMade(const World &w, const EGLint *attributes) {
  return made(eglCreatePbufferSurface(w.display, w.config, attributes));
}
bool contextMade(const World &w, const EGLint *attributes) {
  return made(eglCreateContext(w.display, w.config, EGL_NO_CONTEXT, attributes));
}

const Case kCases[] = {
    {"eglBindAPI", EGL_BAD_PARAMETER, [](const World &) { return eglBindAPI(EGL_OPENVG_API); }},
    {"eglBindAPI", EGL_BAD_PARAMETER, [](const World &) { return eglBindAPI(EGL_OPENGL_API); }},
    {"eglBindAPI", EGL_BAD_PARAMETER, [](const World &) { return eglBindAPI(EGL_NONE); }},
    {"eglBindTexImage", EGL_BAD_SURFACE,
     [](const World &w) { return eglBindTexImage(w.display, kNothing, EGL_BACK_BUFFER); }},
    {"eglBindTexImage of what is no texture", EGL_BAD_MATCH,
     [](const World &w) { return eglBindTexImage(w.display, w.surface, EGL_BACK_BUFFER); }},
    {"eglBindTexImage", EGL_BAD_PARAMETER,
     [](const World &w) { return eglBindTexImage(w.display, w.texture, EGL_SINGLE_BUFFER); }},
    {"eglChooseConfig", EGL_BAD_PARAMETER,
     [](const World &w) { return eglChooseConfig(w.display, nullptr, nullptr, 0, nullptr); }},
    {"eglChooseConfig", EGL_BAD_ATTRIBUTE,
     [](const World &w) { return eglChooseConfig(w.display, kUnknown, nullptr, 0, &gValue); }},
    {"eglClientWaitSync", EGL_BAD_PARAMETER,
     [](const World &w) { return eglClientWaitSync(w.display, kNothing, 0, 0) != EGL_FALSE; }},
    {"eglCopyBuffers", EGL_BAD_SURFACE, [](const World &w) { return eglCopyBuffers(w.display, kNothing, 5); }},
    {"eglCopyBuffers", EGL_BAD_NATIVE_PIXMAP, [](const World &w) { return eglCopyBuffers(w.display, w.surface, 5); }},
    {"eglCreateContext", EGL_BAD_CONFIG,
     [](const World &w) { return made(eglCreateContext(w.display, kNothing, nullptr, nullptr)); }},
    {"eglCreateContext", EGL_BAD_CONTEXT,
     [](const World &w) { return made(eglCreateContext(w.display, w.config, kNothing, nullptr)); }},
    {"eglCreateContext", EGL_BAD_ATTRIBUTE, [](const World &w) { return contextMade(w, kUnknown); }},
    {"eglCreateContext: OpenGL ES 2", EGL_BAD_CONFIG,
     [](const World &w) { return contextMade(w, list<EGL_CONTEXT_MAJOR_VERSION, 2>()); }},
    {"eglCreateContext: OpenGL ES 3.1", EGL_BAD_CONFIG,
     [](const World &w) { return contextMade(w, list<EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 1>()); }},
    {"eglCreateContext: OpenGL ES 1.2", EGL_BAD_MATCH,
     [](const World &w) { return contextMade(w, list<EGL_CONTEXT_MINOR_VERSION, 2>()); }},
    {"eglCreateContext: OpenGL ES 9", EGL_BAD_MATCH,
     [](const World &w) { return contextMade(w, list<EGL_CONTEXT_MAJOR_VERSION, 9>()); }},
    {"eglCreateContext: OpenGL's profile", EGL_BAD_ATTRIBUTE,
     [](const World &w) { return contextMade(w, list<EGL_CONTEXT_OPENGL_PROFILE_MASK, 1>()); }},
    {"eglCreateContext: unknown flag", EGL_BAD_ATTRIBUTE,
     [](const World &w) { return contextMade(w, list<EGL_CONTEXT_FLAGS_KHR, 0x100>()); }},
    {"eglCreateContext: robust access", EGL_BAD_MATCH,
     [](const World &w) { return contextMade(w, list<EGL_CONTEXT_OPENGL_ROBUST_ACCESS, EGL_TRUE>()); }},
    {"eglCreateImage", EGL_BAD_CONTEXT,
     [](const World &w) { return made(eglCreateImage(w.display, kNothing, EGL_GL_TEXTURE_2D, nullptr, nullptr)); }},
    {"eglCreateImage: unknown target", EGL_BAD_PARAMETER,
     [](const World &w) { return made(eglCreateImage(w.display, w.context, 0x7777, nullptr, nullptr)); }},
    {"eglCreateImage: unknown texture", EGL_BAD_PARAMETER,
     [](const World &w) {
       return made(eglCreateImage(w.display, w.context, EGL_GL_TEXTURE_2D, EGLClientBuffer(99), nullptr));
     }},
    {"eglCreateImage: texture 0", EGL_BAD_PARAMETER,
     [](const World &w) { return made(eglCreateImage(w.display, w.context, EGL_GL_TEXTURE_2D, nullptr, nullptr)); }},
    {"eglCreateImage: no context", EGL_BAD_MATCH,
     [](const World &w) { return made(eglCreateImage(w.display, nullptr, EGL_GL_TEXTURE_2D, nullptr, nullptr)); }},
    {"eglCreateImage: unknown attribute", EGL_BAD_PARAMETER,
     [](const World &w) {
       return made(eglCreateImage(w.display, w.context, EGL_GL_TEXTURE_2D, EGLClientBuffer(1), kUnknownWide));
     }},
    {"eglCreatePbufferFromClientBuffer", EGL_BAD_CONFIG,
     [](const World &w) {
       return made(eglCreatePbufferFromClientBuffer(w.display, EGL_OPENVG_IMAGE, nullptr, kNothing, nullptr));
     }},
    {"eglCreatePbufferFromClientBuffer", EGL_BAD_PARAMETER,
     [](const World &w) {
       return made(eglCreatePbufferFromClientBuffer(w.display, EGL_OPENVG_IMAGE, kNothing, w.config, nullptr));
     }},
    {"eglCreatePbufferSurface", EGL_BAD_CONFIG,
     [](const World &w) { return made(eglCreatePbufferSurface(w.display, kNothing, nullptr)); }},
    {"eglCreatePbufferSurface", EGL_BAD_ATTRIBUTE, [](const World &w) { return pbufferMade(w, kUnknown); }},
    {"eglCreatePbufferSurface: a window's attribute", EGL_BAD_ATTRIBUTE,
     [](const World &w) { return pbufferMade(w, list<EGL_RENDER_BUFFER, EGL_BACK_BUFFER>()); }},
    {"eglCreatePbufferSurface: width", EGL_BAD_PARAMETER,
     [](const World &w) { return pbufferMade(w, list<EGL_WIDTH, -1>()); }},
    {"eglCreatePbufferSurface: height", EGL_BAD_PARAMETER,
     [](const World &w) { return pbufferMade(w, list<EGL_HEIGHT, -1>()); }},
    {"eglCreatePbufferSurface: too large", EGL_BAD_ALLOC,
     [](const World &w) { return pbufferMade(w, list<EGL_WIDTH, 100000, EGL_HEIGHT, 1>()); }},
    {"eglCreatePbufferSurface: format without target", EGL_BAD_MATCH,
     [](const World &w) { return pbufferMade(w, list<EGL_TEXTURE_FORMAT, EGL_TEXTURE_RGB>()); }},
    {"eglCreatePbufferSurface: target without format", EGL_BAD_MATCH,
     [](const World &w) { return pbufferMade(w, list<EGL_TEXTURE_TARGET, EGL_TEXTURE_2D>()); }},
    {"eglCreatePbufferSurface: a texture of 48 texels", EGL_BAD_ATTRIBUTE,
     [](const World &w) {
       return pbufferMade(w, list<EGL_TEXTURE_FORMAT, EGL_TEXTURE_RGB, EGL_TEXTURE_TARGET, EGL_TEXTURE_2D, EGL_WIDTH,
                                  48, EGL_HEIGHT, 64>());
     }},
    {"eglCreatePbufferSurface: alpha where there is none", EGL_BAD_MATCH,
     [](const World &w) {
       return made(eglCreatePbufferSurface(
           w.display, w.opaque,
           list<EGL_TEXTURE_FORMAT, EGL_TEXTURE_RGBA, EGL_TEXTURE_TARGET, EGL_TEXTURE_2D, EGL_WIDTH, 64>()));
     }},
    {"eglCreatePbufferSurface: unknown format", EGL_BAD_ATTRIBUTE,
     [](const World &w) { return pbufferMade(w, list<EGL_TEXTURE_FORMAT, 7>()); }},
    {"eglCreatePbufferSurface: sRGB", EGL_BAD_MATCH,
     [](const World &w) { return pbufferMade(w, list<EGL_GL_COLORSPACE, EGL_GL_COLORSPACE_SRGB>()); }},
    {"eglCreatePbufferSurface: OpenVG's linear colours", EGL_BAD_MATCH,
     [](const World &w) { return pbufferMade(w, list<EGL_VG_COLORSPACE, EGL_VG_COLORSPACE_LINEAR>()); }},
    {"eglCreatePixmapSurface", EGL_BAD_CONFIG,
     [](const World &w) { return made(eglCreatePixmapSurface(w.display, kNothing, 5, nullptr)); }},
    {"eglCreatePixmapSurface", EGL_BAD_NATIVE_PIXMAP,
     [](const World &w) { return made(eglCreatePixmapSurface(w.display, w.config, 5, nullptr)); }},
    {"eglCreatePixmapSurface", EGL_BAD_ATTRIBUTE,
     [](const World &w) { return made(eglCreatePixmapSurface(w.display, w.config, 5, kUnknown)); }},
    {"eglCreatePlatformPixmapSurface", EGL_BAD_NATIVE_PIXMAP,
     [](const World &w) { return made(eglCreatePlatformPixmapSurface(w.display, w.config, nullptr, nullptr)); }},
    {"eglCreatePlatformWindowSurface", EGL_BAD_CONFIG,
     [](const World &w) { return made(eglCreatePlatformWindowSurface(w.display, kNothing, nullptr, nullptr)); }},
    {"eglCreatePlatformWindowSurface", EGL_BAD_NATIVE_WINDOW,
     [](const World &w) { return made(eglCreatePlatformWindowSurface(w.display, w.config, nullptr, nullptr)); }},
    {"eglCreateSync: nothing is current", EGL_BAD_MATCH,
     [](const World &w) { return made(eglCreateSync(w.display, EGL_SYNC_FENCE, nullptr)); }},
    {"eglCreateSync: unknown type", EGL_BAD_PARAMETER,
     [](const World &w) { return made(eglCreateSync(w.display, EGL_SYNC_CL_EVENT, nullptr)); }},
    {"eglCreateSync: a fence has no attributes", EGL_BAD_ATTRIBUTE,
     [](const World &w) { return made(eglCreateSync(w.display, EGL_SYNC_FENCE, kUnknownWide)); }},
    {"eglCreateWindowSurface", EGL_BAD_CONFIG,
     [](const World &w) { return made(eglCreateWindowSurface(w.display, kNothing, 0, nullptr)); }},
    {"eglCreateWindowSurface", EGL_BAD_NATIVE_WINDOW,
     [](const World &w) { return made(eglCreateWindowSurface(w.display, w.config, 5, nullptr)); }},
    {"eglCreateWindowSurface", EGL_BAD_ATTRIBUTE,
     [](const World &w) { return made(eglCreateWindowSurface(w.display, w.config, 0, kUnknown)); }},
    {"eglCreateWindowSurface: a pbuffer's attribute", EGL_BAD_ATTRIBUTE,
     [](const World &w) { return made(eglCreateWindowSurface(w.display, w.config, 0, list<EGL_WIDTH, 5>())); }},
    {"eglDestroyContext", EGL_BAD_CONTEXT, [](const World &w) { return eglDestroyContext(w.display, w.surface); }},
    {"eglDestroyImage", EGL_BAD_PARAMETER, [](const World &w) { return eglDestroyImage(w.display, kNothing); }},
    {"eglDestroySurface", EGL_BAD_SURFACE, [](const World &w) { return eglDestroySurface(w.display, w.context); }},
    {"eglDestroySync", EGL_BAD_PARAMETER, [](const World &w) { return eglDestroySync(w.display, kNothing); }},
    {"eglGetConfigAttrib", EGL_BAD_CONFIG,
     [](const World &w) { return eglGetConfigAttrib(w.display, kNothing, EGL_RED_SIZE, &gValue); }},
    {"eglGetConfigAttrib", EGL_BAD_ATTRIBUTE,
     [](const World &w) { return eglGetConfigAttrib(w.display, w.config, 0x7777, &gValue); }},
    {"eglGetConfigs", EGL_BAD_PARAMETER, [](const World &w) { return eglGetConfigs(w.display, nullptr, 0, nullptr); }},
    {"eglGetCurrentSurface", EGL_BAD_PARAMETER, [](const World &) { return made(eglGetCurrentSurface(EGL_WIDTH)); }},
    {"eglGetPlatformDisplay", EGL_BAD_PARAMETER,
     [](const World &) { return eglGetPlatformDisplay(0x7777, nullptr, nullptr) != EGL_NO_DISPLAY; }},
    {"eglGetPlatformDisplay: surfaceless has no native display", EGL_BAD_PARAMETER,
     [](const World &) {
       return eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, kNothing, nullptr) != EGL_NO_DISPLAY;
     }},
    {"eglGetPlatformDisplay", EGL_BAD_ATTRIBUTE,
     [](const World &) {
       return eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, kUnknownWide) != EGL_NO_DISPLAY;
     }},
    {"eglGetPlatformDisplay: X11", EGL_BAD_ATTRIBUTE,
     [](const World &) {
       return eglGetPlatformDisplay(EGL_PLATFORM_X11_KHR, nullptr, kUnknownWide) != EGL_NO_DISPLAY;
     }},
    {"eglInitialize", EGL_BAD_DISPLAY, [](const World &) { return eglInitialize(EGL_NO_DISPLAY, nullptr, nullptr); }},
    {"eglInitialize: X11 without a server", EGL_NOT_INITIALIZED,
     [](const World &w) { return eglInitialize(w.other, nullptr, nullptr); }},
    {"eglMakeCurrent: release", EGL_BAD_DISPLAY,
     [](const World &) { return eglMakeCurrent(EGL_NO_DISPLAY, nullptr, nullptr, nullptr); }},
    {"eglMakeCurrent", EGL_BAD_SURFACE,
     [](const World &w) { return eglMakeCurrent(w.display, kNothing, w.surface, w.context); }},
    {"eglMakeCurrent: read", EGL_BAD_SURFACE,
     [](const World &w) { return eglMakeCurrent(w.display, w.surface, kNothing, w.context); }},
    {"eglMakeCurrent", EGL_BAD_CONTEXT,
     [](const World &w) { return eglMakeCurrent(w.display, w.surface, w.surface, kNothing); }},
    {"eglMakeCurrent: no context", EGL_BAD_MATCH,
     [](const World &w) { return eglMakeCurrent(w.display, w.surface, w.surface, nullptr); }},
    {"eglMakeCurrent: draw alone", EGL_BAD_MATCH,
     [](const World &w) { return eglMakeCurrent(w.display, w.surface, nullptr, w.context); }},
    {"eglMakeCurrent: read alone", EGL_BAD_MATCH,
     [](const World &w) { return eglMakeCurrent(w.display, nullptr, w.surface, w.context); }},
    {"eglQueryContext", EGL_BAD_CONTEXT,
     [](const World &w) { return eglQueryContext(w.display, kNothing, EGL_CONFIG_ID, &gValue); }},
    {"eglQueryContext", EGL_BAD_ATTRIBUTE,
     [](const World &w) { return eglQueryContext(w.display, w.context, EGL_WIDTH, &gValue); }},
    {"eglQueryContext", EGL_BAD_PARAMETER,
     [](const World &w) { return eglQueryContext(w.display, w.context, EGL_CONFIG_ID, nullptr); }},
    {"eglQueryString", EGL_BAD_PARAMETER,
     [](const World &w) { return eglQueryString(w.display, EGL_WIDTH) != nullptr; }},
    {"eglQueryString without a display", EGL_BAD_DISPLAY,
     [](const World &) { return eglQueryString(EGL_NO_DISPLAY, EGL_VENDOR) != nullptr; }},
    {"eglQuerySurface", EGL_BAD_SURFACE,
     [](const World &w) { return eglQuerySurface(w.display, kNothing, EGL_WIDTH, &gValue); }},
    {"eglQuerySurface", EGL_BAD_ATTRIBUTE,
     [](const World &w) { return eglQuerySurface(w.display, w.surface, EGL_RED_SIZE, &gValue); }},
    {"eglQuerySurface", EGL_BAD_PARAMETER,
     [](const World &w) { return eglQuerySurface(w.display, w.surface, EGL_WIDTH, nullptr); }},
    {"eglQuerySurface: the age of what is not current", EGL_BAD_SURFACE,
     [](const World &w) { return eglQuerySurface(w.display, w.surface, EGL_BUFFER_AGE_EXT, &gValue); }},
    {"eglReleaseTexImage", EGL_BAD_SURFACE,
     [](const World &w) { return eglReleaseTexImage(w.display, kNothing, EGL_BACK_BUFFER); }},
    {"eglReleaseTexImage", EGL_BAD_MATCH,
     [](const World &w) { return eglReleaseTexImage(w.display, w.surface, EGL_BACK_BUFFER); }},
    {"eglReleaseTexImage", EGL_BAD_PARAMETER,
     [](const World &w) { return eglReleaseTexImage(w.display, w.texture, 0); }},
    {"eglSurfaceAttrib", EGL_BAD_SURFACE,
     [](const World &w) { return eglSurfaceAttrib(w.display, kNothing, EGL_MIPMAP_LEVEL, 1); }},
    {"eglSurfaceAttrib", EGL_BAD_ATTRIBUTE,
     [](const World &w) { return eglSurfaceAttrib(w.display, w.surface, EGL_WIDTH, 1); }},
    {"eglSurfaceAttrib", EGL_BAD_PARAMETER,
     [](const World &w) { return eglSurfaceAttrib(w.display, w.surface, EGL_SWAP_BEHAVIOR, 1); }},
    {"eglSurfaceAttrib: nothing to resolve", EGL_BAD_MATCH,
     [](const World &
            w) { return eglSurfaceAttrib(w.display, w.surface, EGL_MULTISAMPLE_RESOLVE, EGL_MULTISAMPLE_RESOLVE_BOX); }},
    {"eglSwapBuffers", EGL_BAD_SURFACE, [](const World &w) { return eglSwapBuffers(w.display, kNothing); }},
    {"eglSwapBuffers: not current", EGL_BAD_SURFACE,
     [](const World &w) { return eglSwapBuffers(w.display, w.surface); }},
    {"eglSwapInterval", EGL_BAD_CONTEXT, [](const World &w) { return eglSwapInterval(w.display, 1); }},
    {"eglTerminate", EGL_BAD_DISPLAY, [](const World &) { return eglTerminate(EGL_NO_DISPLAY); }},
    {"eglWaitNative", EGL_BAD_PARAMETER, [](const World &) { return eglWaitNative(7); }},
    {"eglWaitSync", EGL_BAD_PARAMETER, [](const World &w) { return eglWaitSync(w.display, kNothing, 0); }},
};

class EglErrors : public Egl {
 protected:
  World world() {
    World w;
    w.display = mDisplay;
    w.other = eglGetPlatformDisplay(EGL_PLATFORM_X11_KHR, nullptr, nullptr);
    w.config = choose({EGL_ALPHA_SIZE, 8});
    w.opaque = mConfig;
    w.surface = pbufferOf(w.config, {EGL_WIDTH, 8, EGL_HEIGHT, 8});
    w.texture = pbufferOf(w.config, {EGL_WIDTH, 8, EGL_HEIGHT, 8, EGL_TEXTURE_FORMAT, EGL_TEXTURE_RGB,
                                     EGL_TEXTURE_TARGET, EGL_TEXTURE_2D});
    w.context = context(w.config);
    return w;
  }
};

TEST_F(EglErrors, EveryListedOne) {
  const World w = world();
  ASSERT_TRUE(w.surface && w.texture && w.context && w.other);
  for (const Case &row : kCases) {
    EXPECT_FALSE(row.succeeds(w)) << row.call;
    EXPECT_EQ(eglGetError(), row.error) << row.call;
    EXPECT_EQ(eglGetError(), EGL_SUCCESS) << row.call << ": told once";
  }
}

TEST_F(EglErrors, OfDisplays) {
  const EGLDisplay closed = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
  for (const DisplayCase &row : kDisplayCases) {
    if (std::strcmp(row.name, "eglQueryString") != 0) {  // which has answers without a display
      EXPECT_FALSE(row.call(EGL_NO_DISPLAY)) << row.name;
      EXPECT_EQ(eglGetError(), EGL_BAD_DISPLAY) << row.name;
    }
    EXPECT_FALSE(row.call(kNothing)) << row.name;
    EXPECT_EQ(eglGetError(), EGL_BAD_DISPLAY) << row.name;
    EXPECT_FALSE(row.call(closed)) << row.name;
    EXPECT_EQ(eglGetError(), EGL_NOT_INITIALIZED) << row.name;
  }
}

TEST_F(EglErrors, ASuccessIsAVerdictToo) {
  EXPECT_FALSE(eglSwapBuffers(mDisplay, kNothing));
  EXPECT_TRUE(eglGetConfigs(mDisplay, nullptr, 0, &gValue));
  expectError(EGL_SUCCESS);
}

TEST_F(EglErrors, OnlyWithSomethingCurrent) {
  const EGLSurface surface = pbuffer();
  ASSERT_TRUE(eglMakeCurrent(mDisplay, surface, surface, context()));
  const EGLSync sync = eglCreateSync(mDisplay, EGL_SYNC_FENCE, nullptr);
  EXPECT_FALSE(eglWaitSync(mDisplay, sync, 1));
  expectError(EGL_BAD_PARAMETER);
  EXPECT_EQ(eglClientWaitSync(mDisplay, sync, 8, 0), EGL_FALSE);
  expectError(EGL_BAD_PARAMETER);
  EXPECT_FALSE(eglGetSyncAttrib(mDisplay, sync, EGL_WIDTH, &gWide));
  expectError(EGL_BAD_ATTRIBUTE);
  EXPECT_FALSE(eglGetSyncAttrib(mDisplay, sync, EGL_SYNC_TYPE, nullptr));
  expectError(EGL_BAD_PARAMETER);
  ASSERT_TRUE(eglMakeCurrent(mDisplay, nullptr, nullptr, context()));
  EXPECT_FALSE(eglSwapInterval(mDisplay, 1));
  expectError(EGL_BAD_SURFACE);
  eglReleaseThread();
  EXPECT_FALSE(eglWaitSync(mDisplay, sync, 0));
  expectError(EGL_BAD_MATCH);
}

TEST_F(EglErrors, SharingAcrossDisplays) {
  const EGLDisplay surfaceless = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
  ASSERT_TRUE(eglInitialize(surfaceless, nullptr, nullptr));
  EXPECT_FALSE(eglCreateContext(surfaceless, mConfig, context(), nullptr));
  expectError(EGL_BAD_MATCH);
  EXPECT_FALSE(eglCreateWindowSurface(surfaceless, mConfig, 0, nullptr));
  expectError(EGL_BAD_NATIVE_WINDOW);
  EXPECT_TRUE(eglTerminate(surfaceless));
}

}  // namespace
}  // namespace rc::test
