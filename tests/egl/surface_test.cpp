// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Surfaces, contexts and what is current: attributes and their defaults, life and death. [EGL 1.5, 3.5, 3.7]
#include <algorithm>
#include <iterator>
#include <sstream>
#include <thread>

#include "RC/rc.h"
#include "egl/egl_fixture.h"

namespace rc::test {
namespace {

struct Default {
  EGLint name, value;
};

class Surfaces : public Egl {};

TEST_F(Surfaces, DefaultsOfAPbuffer) {
  const EGLSurface surface = pbufferOf(mConfig, {});
  const Default kDefaults[] = {
      {EGL_WIDTH, 0},
      {EGL_HEIGHT, 0},
      {EGL_CONFIG_ID, valueOf(mConfig, EGL_CONFIG_ID)},
      {EGL_LARGEST_PBUFFER, EGL_FALSE},
      {EGL_TEXTURE_FORMAT, EGL_NO_TEXTURE},
      {EGL_TEXTURE_TARGET, EGL_NO_TEXTURE},
      {EGL_MIPMAP_TEXTURE, EGL_FALSE},
      {EGL_MIPMAP_LEVEL, 0},
      {EGL_RENDER_BUFFER, EGL_BACK_BUFFER},
      {EGL_SWAP_BEHAVIOR, EGL_BUFFER_PRESERVED},
      {EGL_MULTISAMPLE_RESOLVE, EGL_MULTISAMPLE_RESOLVE_DEFAULT},
      {EGL_GL_COLORSPACE, EGL_GL_COLORSPACE_LINEAR},
      {EGL_VG_COLORSPACE, EGL_VG_COLORSPACE_sRGB},
      {EGL_VG_ALPHA_FORMAT, EGL_VG_ALPHA_FORMAT_NONPRE},
      {EGL_HORIZONTAL_RESOLUTION, EGL_UNKNOWN},
      {EGL_VERTICAL_RESOLUTION, EGL_UNKNOWN},
      {EGL_PIXEL_ASPECT_RATIO, EGL_UNKNOWN},
  };
  for (const Default &row : kDefaults) EXPECT_EQ(query(surface, row.name), row.value) << std::hex << row.name;
}

TEST_F(Surfaces, AWindowHasNoneOfAPbuffersAttributes) {
  const EGLint single[] = {EGL_RENDER_BUFFER, EGL_SINGLE_BUFFER, EGL_NONE};
  const EGLSurface window = eglCreateWindowSurface(mDisplay, mConfig, 0, single);
  ASSERT_TRUE(window);
  EXPECT_EQ(query(window, EGL_RENDER_BUFFER), EGL_SINGLE_BUFFER);
  for (const EGLint name :
       {EGL_LARGEST_PBUFFER, EGL_TEXTURE_FORMAT, EGL_TEXTURE_TARGET, EGL_MIPMAP_TEXTURE, EGL_MIPMAP_LEVEL}) {
    EXPECT_EQ(query(window, name, 4711), 4711) << "no error, and the value is left alone";
  }
}

TEST_F(Surfaces, AttributesAreKept) {
  const EGLConfig sampled = choose({EGL_RED_SIZE, 8, EGL_SAMPLES, 4});
  const EGLSurface surface = pbufferOf(sampled, {EGL_WIDTH, 64, EGL_HEIGHT, 32, EGL_TEXTURE_FORMAT, EGL_TEXTURE_RGB,
                                                 EGL_TEXTURE_TARGET, EGL_TEXTURE_2D, EGL_MIPMAP_TEXTURE, EGL_TRUE});
  EXPECT_EQ(query(surface, EGL_WIDTH), 64);
  EXPECT_EQ(query(surface, EGL_TEXTURE_FORMAT), EGL_TEXTURE_RGB);
  EXPECT_EQ(query(surface, EGL_TEXTURE_TARGET), EGL_TEXTURE_2D);
  EXPECT_EQ(query(surface, EGL_MIPMAP_TEXTURE), EGL_TRUE);
  const Default kChanges[] = {{EGL_MIPMAP_LEVEL, 3},
                              {EGL_MULTISAMPLE_RESOLVE, EGL_MULTISAMPLE_RESOLVE_BOX},
                              {EGL_SWAP_BEHAVIOR, EGL_BUFFER_DESTROYED}};
  for (const Default &row : kChanges) {
    EXPECT_TRUE(eglSurfaceAttrib(mDisplay, surface, row.name, row.value));
    EXPECT_EQ(query(surface, row.name), row.value);
  }
}

TEST_F(Surfaces, TheLargestPbuffer) {
  const EGLSurface surface = pbufferOf(mConfig, {EGL_WIDTH, 1 << 30, EGL_HEIGHT, 4, EGL_LARGEST_PBUFFER, EGL_TRUE});
  ASSERT_TRUE(surface);
  EXPECT_EQ(query(surface, EGL_WIDTH), valueOf(mConfig, EGL_MAX_PBUFFER_WIDTH));
  EXPECT_EQ(query(surface, EGL_HEIGHT), 4);
  EXPECT_EQ(query(surface, EGL_LARGEST_PBUFFER), EGL_TRUE);
}

TEST_F(Surfaces, TheAgeOfTheBackBuffer) {
  const EGLSurface surface = pbuffer();
  ASSERT_TRUE(eglMakeCurrent(mDisplay, surface, surface, context()));
  EXPECT_EQ(query(surface, EGL_BUFFER_AGE_EXT), 0) << "nothing was drawn";
  ASSERT_TRUE(eglSwapBuffers(mDisplay, surface));
  EXPECT_EQ(query(surface, EGL_BUFFER_AGE_EXT), 1);
}

TEST_F(Surfaces, ReadAndDrawMayDiffer) {
  const EGLSurface draw = pbuffer(), read = pbuffer(8, 8);
  const EGLContext made = context();
  ASSERT_TRUE(eglMakeCurrent(mDisplay, draw, read, made));
  EXPECT_EQ(eglGetCurrentSurface(EGL_DRAW), draw);
  EXPECT_EQ(eglGetCurrentSurface(EGL_READ), read);
  RCint viewport[4];
  rcGetIntegerv(RC_VIEWPORT, viewport);
  EXPECT_EQ(viewport[2], 32);
  EXPECT_FALSE(eglSwapBuffers(mDisplay, read));
  expectError(EGL_BAD_SURFACE);
  std::thread([&] {
    EXPECT_FALSE(eglMakeCurrent(mDisplay, read, read, context()));
    expectError(EGL_BAD_ACCESS);
  }).join();
}

TEST_F(Surfaces, AContextWithoutSurfaces) {
  const EGLContext made = context();
  ASSERT_TRUE(eglMakeCurrent(mDisplay, EGL_NO_SURFACE, EGL_NO_SURFACE, made));
  EXPECT_EQ(eglGetCurrentContext(), made);
  EXPECT_EQ(eglGetCurrentSurface(EGL_DRAW), EGL_NO_SURFACE);
  EGLint value = 0;
  EXPECT_TRUE(eglQueryContext(mDisplay, made, EGL_RENDER_BUFFER, &value));
  EXPECT_EQ(value, EGL_NONE);
  RCuint name = 0;
  rcGenTextures(1, &name);
  EXPECT_EQ(name, 1u);
  rcFinish();
  EXPECT_TRUE(eglWaitClient());
  EXPECT_EQ(rcGetError(), RCenum(RC_NO_ERROR));
}

TEST_F(Surfaces, WhatAContextDrawsTo) {
  const EGLint single[] = {EGL_RENDER_BUFFER, EGL_SINGLE_BUFFER, EGL_NONE};
  const EGLSurface window = eglCreateWindowSurface(mDisplay, mConfig, 0, single), off = pbuffer();
  const EGLContext made = context();
  EGLint value = 0;
  EXPECT_TRUE(eglQueryContext(mDisplay, made, EGL_RENDER_BUFFER, &value));
  EXPECT_EQ(value, EGL_NONE) << "it is not current";
  ASSERT_TRUE(eglMakeCurrent(mDisplay, window, window, made));
  EXPECT_TRUE(eglQueryContext(mDisplay, made, EGL_RENDER_BUFFER, &value));
  EXPECT_EQ(value, EGL_SINGLE_BUFFER);
  ASSERT_TRUE(eglMakeCurrent(mDisplay, off, off, made));
  EXPECT_TRUE(eglQueryContext(mDisplay, made, EGL_RENDER_BUFFER, &value));
  EXPECT_EQ(value, EGL_BACK_BUFFER);
  EXPECT_TRUE(eglQueryContext(mDisplay, made, EGL_CONTEXT_CLIENT_TYPE, &value));
  EXPECT_EQ(value, EGL_OPENGL_ES_API);
  EXPECT_TRUE(eglQueryContext(mDisplay, made, EGL_CONFIG_ID, &value));
  EXPECT_EQ(value, valueOf(mConfig, EGL_CONFIG_ID));
}

// Handles stay valid until what they name is no longer current. [EGL 1.5, 3.5.8, 3.7.2]
TEST_F(Surfaces, DestroyedWhileCurrent) {
  const EGLSurface surface = pbuffer(), other = pbuffer();
  const EGLContext made = context();
  ASSERT_TRUE(eglMakeCurrent(mDisplay, surface, surface, made));
  EXPECT_TRUE(eglDestroySurface(mDisplay, surface));
  EXPECT_TRUE(eglDestroyContext(mDisplay, made));
  EXPECT_TRUE(eglSwapBuffers(mDisplay, surface));
  EXPECT_EQ(query(surface, EGL_WIDTH), 32);
  ASSERT_TRUE(eglMakeCurrent(mDisplay, other, other, made)) << "the context is still current";
  EGLint value;
  EXPECT_FALSE(eglQuerySurface(mDisplay, surface, EGL_WIDTH, &value));
  expectError(EGL_BAD_SURFACE);
  ASSERT_TRUE(eglReleaseThread());
  EXPECT_FALSE(eglQueryContext(mDisplay, made, EGL_CONFIG_ID, &value));
  expectError(EGL_BAD_CONTEXT);
}

TEST_F(Surfaces, TerminatingEndsAllHandles) {
  const EGLSurface surface = pbuffer();
  const EGLContext made = context();
  ASSERT_TRUE(eglMakeCurrent(mDisplay, surface, surface, made));
  ASSERT_TRUE(eglTerminate(mDisplay));
  EXPECT_TRUE(eglTerminate(mDisplay)) << "once more is no error";
  EXPECT_EQ(eglGetCurrentContext(), made) << "it is used until it is released";
  ASSERT_TRUE(eglInitialize(mDisplay, nullptr, nullptr));
  ASSERT_TRUE(eglInitialize(mDisplay, nullptr, nullptr)) << "nor is this, and nothing is counted";
  EXPECT_FALSE(eglSwapBuffers(mDisplay, surface));
  expectError(EGL_BAD_SURFACE);
  EXPECT_TRUE(eglMakeCurrent(mDisplay, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT));
}

TEST_F(Surfaces, DisplaysArePlatformsAndTheirParameters) {
  const EGLAttrib screen[] = {EGL_PLATFORM_X11_SCREEN_KHR, 0, EGL_NONE};
  const EGLDisplay x11 = eglGetPlatformDisplay(EGL_PLATFORM_X11_KHR, nullptr, nullptr);
  EXPECT_EQ(eglGetPlatformDisplay(EGL_PLATFORM_X11_KHR, nullptr, nullptr), x11);
  EXPECT_NE(eglGetPlatformDisplay(EGL_PLATFORM_X11_KHR, nullptr, screen), x11);
  const EGLDisplay surfaceless = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
  EXPECT_NE(surfaceless, x11);
  ASSERT_TRUE(eglInitialize(surfaceless, nullptr, nullptr));
  EGLConfig config;
  EGLint count = 0, value = 0;
  EXPECT_TRUE(eglChooseConfig(surfaceless, nullptr, &config, 1, &count));
  EXPECT_EQ(count, 0) << "by default a config is for windows, and there are none";
  const EGLint off[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_NONE};
  EXPECT_TRUE(eglChooseConfig(surfaceless, off, &config, 1, &count));
  ASSERT_EQ(count, 1);
  EXPECT_TRUE(eglGetConfigAttrib(surfaceless, config, EGL_SURFACE_TYPE, &value));
  EXPECT_EQ(value & (EGL_WINDOW_BIT | EGL_PIXMAP_BIT), 0);
  EXPECT_TRUE(eglTerminate(surfaceless));
}

// Whether a name is one of a list of them, with spaces between.
bool contains(const char *list, const std::string &name) {
  std::istringstream words(list);
  return std::find(std::istream_iterator<std::string>(words), {}, name) != std::istream_iterator<std::string>();
}

TEST_F(Surfaces, ExtensionsAndTheirFunctions) {
  const char *client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS), *own = eglQueryString(mDisplay, EGL_EXTENSIONS);
  ASSERT_TRUE(client && own);
  EXPECT_STREQ(eglQueryString(EGL_NO_DISPLAY, EGL_VERSION), eglQueryString(mDisplay, EGL_VERSION));
  for (const char *name : {"EGL_EXT_client_extensions", "EGL_EXT_platform_base", "EGL_EXT_platform_x11",
                           "EGL_KHR_platform_x11", "EGL_MESA_platform_surfaceless"}) {
    EXPECT_TRUE(contains(client, name)) << name;
    EXPECT_FALSE(contains(own, name)) << name;
  }
  for (const char *name : {"EGL_KHR_surfaceless_context", "EGL_KHR_create_context", "EGL_KHR_fence_sync",
                           "EGL_KHR_wait_sync", "EGL_EXT_buffer_age", "EGL_KHR_swap_buffers_with_damage"}) {
    EXPECT_TRUE(contains(own, name)) << name;
    EXPECT_FALSE(contains(client, name)) << name;
  }
  for (const char *name : {"eglGetPlatformDisplayEXT", "eglCreatePlatformWindowSurfaceEXT", "eglCreateSyncKHR",
                           "eglDestroySyncKHR", "eglClientWaitSyncKHR", "eglGetSyncAttribKHR", "eglWaitSyncKHR",
                           "eglCreateImageKHR", "eglDestroyImageKHR", "eglSwapBuffersWithDamageKHR"}) {
    EXPECT_TRUE(eglGetProcAddress(name)) << name;
  }
  EXPECT_FALSE(eglGetProcAddress("eglCreateStreamKHR"));
}

// Each call of EGL is the last one that eglGetError tells about.
TEST_F(Surfaces, QuestionsAreCallsToo) {
  const auto failFirst = [] { eglBindAPI(EGL_OPENVG_API); };
  failFirst();
  EXPECT_FALSE(eglGetCurrentContext());
  expectError(EGL_SUCCESS);
  failFirst();
  EXPECT_FALSE(eglGetCurrentDisplay());
  expectError(EGL_SUCCESS);
  failFirst();
  EXPECT_FALSE(eglGetCurrentSurface(EGL_DRAW));
  expectError(EGL_SUCCESS);
  failFirst();
  EXPECT_EQ(eglQueryAPI(), EGLenum(EGL_OPENGL_ES_API));
  expectError(EGL_SUCCESS);
  failFirst();
  EXPECT_FALSE(eglGetProcAddress("nothing"));
  expectError(EGL_SUCCESS);
}

TEST_F(Surfaces, TheExtensionsTwins) {
  const auto platformDisplay =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  EXPECT_EQ(platformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr),
            eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr));
  const auto swap =
      reinterpret_cast<PFNEGLSWAPBUFFERSWITHDAMAGEKHRPROC>(eglGetProcAddress("eglSwapBuffersWithDamageKHR"));
  const EGLSurface surface = pbuffer();
  ASSERT_TRUE(eglMakeCurrent(mDisplay, surface, surface, context()));
  const EGLint rectangle[] = {0, 0, 4, 4};
  EXPECT_TRUE(swap(mDisplay, surface, rectangle, 1));
  EXPECT_TRUE(swap(mDisplay, surface, nullptr, 0));
  EXPECT_FALSE(swap(mDisplay, surface, rectangle, -1));
  expectError(EGL_BAD_PARAMETER);
}

TEST_F(Surfaces, ContextAttributesOfOneFiveAndTheExtension) {
  const std::vector<std::vector<EGLint>> good = {{EGL_CONTEXT_MAJOR_VERSION, 1, EGL_CONTEXT_MINOR_VERSION, 1, EGL_NONE},
                                                 {EGL_CONTEXT_MINOR_VERSION, 0, EGL_NONE},
                                                 {EGL_CONTEXT_FLAGS_KHR, EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR, EGL_NONE},
                                                 {EGL_CONTEXT_OPENGL_DEBUG, EGL_TRUE, EGL_NONE},
                                                 {EGL_CONTEXT_OPENGL_ROBUST_ACCESS, EGL_FALSE, EGL_NONE},
                                                 {EGL_NONE}};
  for (const std::vector<EGLint> &list : good) {
    EXPECT_TRUE(eglCreateContext(mDisplay, mConfig, EGL_NO_CONTEXT, list.data())) << testing::PrintToString(list);
    expectError(EGL_SUCCESS);
  }
}

}  // namespace
}  // namespace rc::test
