// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// EGL without a window system: displays, configs, off-screen surfaces, contexts, swaps, every error.
#include <thread>

#include "RC/rcu.h"
#include "egl/egl_fixture.h"

namespace rc::test {
namespace {

TEST_F(Egl, TheGuidesCallsSucceedAndLeaveNoError) {
  const EGLint wanted[] = {
      EGL_RED_SIZE,      8,       EGL_GREEN_SIZE, 8, EGL_BLUE_SIZE, 8, EGL_DEPTH_SIZE, 16, EGL_RENDERABLE_TYPE,
      EGL_OPENGL_ES_BIT, EGL_NONE};
  EGLConfig config;
  EGLint count = 0;
  EXPECT_EQ(eglGetDisplay(EGL_DEFAULT_DISPLAY), mDisplay);
  expectError(EGL_SUCCESS);
  EXPECT_TRUE(eglChooseConfig(mDisplay, wanted, &config, 1, &count));
  EXPECT_EQ(count, 1);
  const EGLSurface surface = eglCreateWindowSurface(mDisplay, config, EGLNativeWindowType(), nullptr);
  expectError(EGL_SUCCESS);
  ASSERT_NE(surface, EGL_NO_SURFACE);
  EGLint width = 0, height = 0;
  eglQuerySurface(mDisplay, surface, EGL_WIDTH, &width);
  eglQuerySurface(mDisplay, surface, EGL_HEIGHT, &height);
  EXPECT_EQ(width, 800);
  EXPECT_EQ(height, 480);
  const EGLint version1[] = {EGL_CONTEXT_CLIENT_VERSION, 1, EGL_NONE};
  const EGLContext made = eglCreateContext(mDisplay, config, EGL_NO_CONTEXT, version1);
  EXPECT_EQ(eglMakeCurrent(mDisplay, surface, surface, made), EGLBoolean(EGL_TRUE));
  RCint viewport[4];
  rcGetIntegerv(RC_VIEWPORT, viewport);
  EXPECT_EQ(viewport[2], 800);
  EXPECT_EQ(viewport[3], 480);
  EXPECT_TRUE(eglSwapBuffers(mDisplay, surface));
  expectError(EGL_SUCCESS);
}

TEST_F(Egl, VersionAndStrings) {
  EGLint major = 0, minor = 0;
  EXPECT_TRUE(eglInitialize(mDisplay, &major, &minor));
  EXPECT_EQ(major, 1);
  EXPECT_EQ(minor, 5);
  EXPECT_EQ(std::strncmp(eglQueryString(mDisplay, EGL_VERSION), "1.5 ", 4), 0);
  EXPECT_STREQ(eglQueryString(mDisplay, EGL_CLIENT_APIS), "OpenGL_ES");
  EXPECT_TRUE(eglQueryString(mDisplay, EGL_VENDOR));
  EXPECT_EQ(eglQueryString(mDisplay, EGL_WIDTH), nullptr);
  expectError(EGL_BAD_PARAMETER);
}

TEST_F(Egl, BadDisplaysAndUninitialisedOnes) {
  EXPECT_FALSE(eglInitialize(kNothing, nullptr, nullptr));
  expectError(EGL_BAD_DISPLAY);
  EXPECT_FALSE(eglTerminate(EGL_NO_DISPLAY));
  expectError(EGL_BAD_DISPLAY);
  EXPECT_TRUE(eglTerminate(mDisplay));
  EGLint count;
  EXPECT_FALSE(eglGetConfigs(mDisplay, nullptr, 0, &count));
  expectError(EGL_NOT_INITIALIZED);
  EXPECT_EQ(context(), EGL_NO_CONTEXT);
  expectError(EGL_NOT_INITIALIZED);
  expectError(EGL_SUCCESS);
}

TEST_F(Egl, ConfigErrors) {
  EGLint count, value;
  const EGLint unknown[] = {0x7777, 1, EGL_NONE};
  EXPECT_FALSE(eglChooseConfig(mDisplay, unknown, nullptr, 0, &count));
  expectError(EGL_BAD_ATTRIBUTE);
  EXPECT_FALSE(eglChooseConfig(mDisplay, nullptr, nullptr, 0, nullptr));
  expectError(EGL_BAD_PARAMETER);
  EXPECT_FALSE(eglGetConfigs(mDisplay, nullptr, 0, nullptr));
  expectError(EGL_BAD_PARAMETER);
  EXPECT_FALSE(eglGetConfigAttrib(mDisplay, kNothing, EGL_RED_SIZE, &value));
  expectError(EGL_BAD_CONFIG);
  EXPECT_FALSE(eglGetConfigAttrib(mDisplay, mConfig, 0x7777, &value));
  expectError(EGL_BAD_ATTRIBUTE);
}

TEST_F(Egl, PbufferSizesAndErrors) {
  EGLint value = 0;
  const EGLSurface surface = pbuffer(7, 3);
  EXPECT_TRUE(eglQuerySurface(mDisplay, surface, EGL_WIDTH, &value));
  EXPECT_EQ(value, 7);
  EXPECT_FALSE(eglQuerySurface(mDisplay, surface, 0x7777, &value));
  expectError(EGL_BAD_ATTRIBUTE);
  EXPECT_FALSE(eglQuerySurface(mDisplay, kNothing, EGL_WIDTH, &value));
  expectError(EGL_BAD_SURFACE);
  EXPECT_EQ(pbuffer(-1, 3), EGL_NO_SURFACE);
  expectError(EGL_BAD_PARAMETER);
  EXPECT_EQ(pbuffer(100000, 3), EGL_NO_SURFACE);
  expectError(EGL_BAD_ALLOC);
  const EGLint unknown[] = {0x7777, 1, EGL_NONE};
  EXPECT_EQ(eglCreatePbufferSurface(mDisplay, mConfig, unknown), EGL_NO_SURFACE);
  expectError(EGL_BAD_ATTRIBUTE);
  EXPECT_EQ(eglCreateWindowSurface(mDisplay, mConfig, EGLNativeWindowType(), unknown), EGL_NO_SURFACE);
  expectError(EGL_BAD_ATTRIBUTE);
  EXPECT_EQ(eglCreateWindowSurface(mDisplay, mConfig, EGLNativeWindowType(5), nullptr), EGL_NO_SURFACE);
  expectError(EGL_BAD_NATIVE_WINDOW);  // there is no window system
  EXPECT_TRUE(eglDestroySurface(mDisplay, surface));
  EXPECT_FALSE(eglDestroySurface(mDisplay, surface));
  expectError(EGL_BAD_SURFACE);
}

TEST_F(Egl, EmptySurfacesAreTracedWithoutHarm) {
  const EGLSurface surface = pbuffer(0, 0);
  ASSERT_TRUE(eglMakeCurrent(mDisplay, surface, surface, context()));
  rcFinish();
  EXPECT_EQ(rcGetError(), RCenum(RC_NO_ERROR));
  EXPECT_TRUE(eglSwapBuffers(mDisplay, surface));
}

TEST_F(Egl, ContextAttributesAndErrors) {
  const EGLint version2[] = {EGL_CONTEXT_CLIENT_VERSION, 2, EGL_NONE}, unknown[] = {0x7777, 1, EGL_NONE};
  EXPECT_EQ(eglCreateContext(mDisplay, mConfig, EGL_NO_CONTEXT, version2), EGL_NO_CONTEXT);
  expectError(EGL_BAD_CONFIG);  // which has no bit for it
  EXPECT_EQ(eglCreateContext(mDisplay, mConfig, EGL_NO_CONTEXT, unknown), EGL_NO_CONTEXT);
  expectError(EGL_BAD_ATTRIBUTE);
  EXPECT_EQ(eglCreateContext(mDisplay, mConfig, kNothing, nullptr), EGL_NO_CONTEXT);
  expectError(EGL_BAD_CONTEXT);
  EXPECT_EQ(eglCreateContext(mDisplay, kNothing, EGL_NO_CONTEXT, nullptr), EGL_NO_CONTEXT);
  expectError(EGL_BAD_CONFIG);
  const EGLContext made = context();
  EGLint value = 0;
  EXPECT_TRUE(eglQueryContext(mDisplay, made, EGL_CONTEXT_CLIENT_VERSION, &value));
  EXPECT_EQ(value, 1);
  EXPECT_TRUE(eglQueryContext(mDisplay, made, EGL_RENDER_BUFFER, &value));
  EXPECT_EQ(value, EGL_NONE);
  EXPECT_FALSE(eglQueryContext(mDisplay, made, 0x7777, &value));
  expectError(EGL_BAD_ATTRIBUTE);
  EXPECT_TRUE(eglDestroyContext(mDisplay, made));
  EXPECT_FALSE(eglDestroyContext(mDisplay, made));
  expectError(EGL_BAD_CONTEXT);
}

TEST_F(Egl, MakeCurrentAndWhatIsCurrent) {
  const EGLSurface surface = pbuffer();
  const EGLContext made = context();
  EXPECT_FALSE(eglMakeCurrent(mDisplay, surface, surface, EGL_NO_CONTEXT));
  expectError(EGL_BAD_MATCH);
  EXPECT_FALSE(eglMakeCurrent(mDisplay, kNothing, surface, made));
  expectError(EGL_BAD_SURFACE);
  EXPECT_FALSE(eglMakeCurrent(mDisplay, surface, surface, kNothing));
  expectError(EGL_BAD_CONTEXT);
  EXPECT_TRUE(eglMakeCurrent(mDisplay, surface, surface, made));
  EXPECT_EQ(eglGetCurrentContext(), made);
  EXPECT_EQ(eglGetCurrentDisplay(), mDisplay);
  EXPECT_EQ(eglGetCurrentSurface(EGL_DRAW), surface);
  EXPECT_EQ(eglGetCurrentSurface(EGL_WIDTH), EGL_NO_SURFACE);
  expectError(EGL_BAD_PARAMETER);
  EXPECT_TRUE(eglMakeCurrent(mDisplay, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT));
  EXPECT_EQ(eglGetCurrentContext(), EGL_NO_CONTEXT);
}

TEST_F(Egl, AContextIsCurrentOnOneThread) {
  const EGLSurface surface = pbuffer(), other = pbuffer();
  const EGLContext made = context();
  ASSERT_TRUE(eglMakeCurrent(mDisplay, surface, surface, made));
  std::thread([&] {
    EXPECT_FALSE(eglMakeCurrent(mDisplay, other, other, made));
    expectError(EGL_BAD_ACCESS);
    rcFinish();
    EXPECT_EQ(rcGetError(), RCenum(RC_INVALID_OPERATION)) << "no context here";
  }).join();
  EXPECT_EQ(rcGetError(), RCenum(RC_NO_ERROR));
  EXPECT_TRUE(eglReleaseThread());
  std::thread([&] { EXPECT_TRUE(eglMakeCurrent(mDisplay, other, other, made)); }).join();
}

TEST_F(Egl, ASurfaceIsCurrentOnOneThread) {
  const EGLSurface surface = pbuffer();
  const EGLContext first = context(), second = context();
  ASSERT_TRUE(eglMakeCurrent(mDisplay, surface, surface, first));
  std::thread([&] {
    EXPECT_FALSE(eglMakeCurrent(mDisplay, surface, surface, second));
    expectError(EGL_BAD_ACCESS);
  }).join();
}

TEST_F(Egl, ContextAndSurfaceMustMatch) {
  const EGLint alpha[] = {EGL_ALPHA_SIZE, 8, EGL_NONE};
  EGLConfig other;
  EGLint count = 0;
  ASSERT_TRUE(eglChooseConfig(mDisplay, alpha, &other, 1, &count));
  const EGLSurface surface = pbuffer();
  EXPECT_FALSE(eglMakeCurrent(mDisplay, surface, surface, eglCreateContext(mDisplay, other, EGL_NO_CONTEXT, nullptr)));
  expectError(EGL_BAD_MATCH);
}

TEST_F(Egl, DestroyedWhileCurrentWorksOn) {
  const EGLSurface surface = pbuffer();
  const EGLContext made = context();
  ASSERT_TRUE(eglMakeCurrent(mDisplay, surface, surface, made));
  EXPECT_TRUE(eglDestroyContext(mDisplay, made));
  EXPECT_TRUE(eglDestroySurface(mDisplay, surface));
  rcClearColor(1, 0, 0, 1);
  rcFinish();
  EXPECT_EQ(rcGetError(), RCenum(RC_NO_ERROR));
  EXPECT_TRUE(eglTerminate(mDisplay));
  rcFinish();
  EXPECT_TRUE(eglMakeCurrent(mDisplay, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT));
}

TEST_F(Egl, SharedContextsSeeEachOthersTextures) {
  const EGLSurface surface = pbuffer();
  const EGLContext first = context();
  const EGLContext second = eglCreateContext(mDisplay, mConfig, first, nullptr);
  ASSERT_TRUE(eglMakeCurrent(mDisplay, surface, surface, first));
  RCuint name = 0;
  rcGenTextures(1, &name);
  ASSERT_TRUE(eglMakeCurrent(mDisplay, surface, surface, second));
  EXPECT_TRUE(rcIsTexture(name));
  ASSERT_TRUE(eglMakeCurrent(mDisplay, surface, surface, context()));
  EXPECT_FALSE(rcIsTexture(name));
}

TEST_F(Egl, WhatIsBoundBelongsToTheContext) {
  const EGLSurface surface = pbuffer();
  const EGLContext first = context(), second = eglCreateContext(mDisplay, mConfig, first, nullptr);
  ASSERT_TRUE(eglMakeCurrent(mDisplay, surface, surface, first));
  rcColor4f(0.5f, 0, 0, 1);  // of material 0, which is the context's own
  rcBindMaterial(1);
  ASSERT_TRUE(eglMakeCurrent(mDisplay, surface, surface, second));
  RCint bound = -1, diffuse[4];
  rcGetIntegerv(RC_MATERIAL_BINDING, &bound);
  rcGetIntegerv(RC_CURRENT_DIFFUSE, diffuse);
  EXPECT_EQ(bound, 0);
  EXPECT_EQ(diffuse[1], 204);
  EXPECT_TRUE(rcIsMaterial(1)) << "the object itself is shared";
  rcBindMaterial(1);
  rcGetIntegerv(RC_CURRENT_DIFFUSE, diffuse);
  EXPECT_EQ(diffuse[0], 128);
}

TEST_F(Egl, SharedObjectsSurviveTwoThreads) {
  const EGLContext first = context(), second = eglCreateContext(mDisplay, mConfig, first, nullptr);
  const auto work = [&](EGLContext mine) {
    const EGLSurface surface = pbuffer();
    ASSERT_TRUE(eglMakeCurrent(mDisplay, surface, surface, mine));
    const std::vector<RCubyte> texels(16 * 16 * 3, 100);
    for (int i = 0; i < 300; ++i) {
      RCuint names[2];
      rcGenTextures(2, names);
      rcBindTexture(RC_TEXTURE_2D, names[0]);
      rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGB, 16, 16, 0, RC_RGB, RC_UNSIGNED_BYTE, texels.data());
      rcDeleteTextures(2, names);
      if (i % 50 == 0) rcFinish();
    }
    EXPECT_EQ(rcGetError(), RCenum(RC_NO_ERROR));
    eglReleaseThread();
  };
  std::thread other([&] { work(second); });
  work(first);
  other.join();
}

TEST_F(Egl, SwapNeedsTheCurrentSurface) {
  const EGLSurface surface = pbuffer(), other = pbuffer();
  EXPECT_FALSE(eglSwapBuffers(mDisplay, surface));
  expectError(EGL_BAD_SURFACE);
  EXPECT_FALSE(eglSwapInterval(mDisplay, 1));
  expectError(EGL_BAD_CONTEXT);
  ASSERT_TRUE(eglMakeCurrent(mDisplay, surface, surface, context()));
  EXPECT_TRUE(eglSwapBuffers(mDisplay, surface));
  EXPECT_TRUE(eglSwapInterval(mDisplay, 0));
  EXPECT_FALSE(eglSwapBuffers(mDisplay, other));
  expectError(EGL_BAD_SURFACE);
}

TEST_F(Egl, SwapTracesAndEndsDynamicGeometry) {
  const EGLSurface surface = pbuffer();
  ASSERT_TRUE(eglMakeCurrent(mDisplay, surface, surface, context()));
  static const float vertices[] = {-1, -1, -3, 1, -1, -3, 0, 1, -3};
  rcEnableClientState(RC_VERTEX_ARRAY);
  rcVertexPointer(3, RC_FLOAT, 0, vertices);
  rcDrawArrays(RC_TRIANGLES, 0, 3);
  RCint triangles = -1;
  eglSwapBuffers(mDisplay, surface);
  rcGetIntegerv(RC_FRAME_TRIANGLES, &triangles);
  EXPECT_EQ(triangles, 1);
  eglSwapBuffers(mDisplay, surface);
  rcGetIntegerv(RC_FRAME_TRIANGLES, &triangles);
  EXPECT_EQ(triangles, 0);
}

TEST_F(Egl, ApisAndWaits) {
  EXPECT_EQ(eglQueryAPI(), EGLenum(EGL_OPENGL_ES_API));
  EXPECT_TRUE(eglBindAPI(EGL_OPENGL_ES_API));
  EXPECT_FALSE(eglBindAPI(EGL_OPENVG_API));
  expectError(EGL_BAD_PARAMETER);
  EXPECT_TRUE(eglWaitClient());
  EXPECT_TRUE(eglWaitGL());
  EXPECT_TRUE(eglWaitNative(EGL_CORE_NATIVE_ENGINE));
  EXPECT_FALSE(eglWaitNative(7));
  expectError(EGL_BAD_PARAMETER);
}

TEST_F(Egl, ProcAddresses) {
  EXPECT_EQ(reinterpret_cast<void *>(eglGetProcAddress("rcFinish")), reinterpret_cast<void *>(rcFinish));
  EXPECT_EQ(reinterpret_cast<void *>(eglGetProcAddress("rcuLookAt")), reinterpret_cast<void *>(rcuLookAt));
  EXPECT_EQ(reinterpret_cast<void *>(eglGetProcAddress("eglSwapBuffers")), reinterpret_cast<void *>(eglSwapBuffers));
  EXPECT_FALSE(eglGetProcAddress("eglGetElapsedTime")) << "an answer overflows a buffer in old programs";
  EXPECT_FALSE(eglGetProcAddress("rcNothing"));
  EXPECT_TRUE(eglGetProcAddress("glClear")) << "all functions of the client API, EGL_KHR_get_all_proc_addresses says";
  EXPECT_TRUE(eglGetProcAddress("glTexParameterxv"));
  EXPECT_FALSE(eglGetProcAddress("glCreateShader"));
  EXPECT_FALSE(eglGetProcAddress(nullptr));
}

}  // namespace
}  // namespace rc::test
