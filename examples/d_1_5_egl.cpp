// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Appendix D 1.5: the mirror of chapter 6.5 b in plain EGL, without the framework. The window is null: EGL makes
// one, or an off-screen surface where there is no display. RAYCORE_FRAMES=n ends the program.
#include <EGL/egl.h>
#include <RC/rc.h>
#include <RC/rcu.h>
#include <stdio.h>

static const int kWidth = 800, kHeight = 480;

static EGLDisplay gDisplay;
static EGLSurface gSurface;
static EGLContext gContext;

// False after a message if the last EGL call failed.
static bool done(const char *call) {
  const EGLint error = eglGetError();
  if (error != EGL_SUCCESS) fprintf(stderr, "%s failed with EGL error 0x%04X\n", call, (unsigned)error);
  return error == EGL_SUCCESS;
}

static bool openWindow() {
  const EGLint wanted[] = {
      EGL_RED_SIZE,      8,       EGL_GREEN_SIZE, 8, EGL_BLUE_SIZE, 8, EGL_DEPTH_SIZE, 16, EGL_RENDERABLE_TYPE,
      EGL_OPENGL_ES_BIT, EGL_NONE};
  const EGLint version[] = {EGL_CONTEXT_CLIENT_VERSION, 1, EGL_NONE};
  EGLConfig config;
  EGLint count = 0;
  gDisplay = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  if (!done("eglGetDisplay")) return false;
  eglInitialize(gDisplay, nullptr, nullptr);
  if (!done("eglInitialize")) return false;
  eglChooseConfig(gDisplay, wanted, &config, 1, &count);
  if (!done("eglChooseConfig") || count == 0) return false;
  gSurface = eglCreateWindowSurface(gDisplay, config, EGLNativeWindowType(), nullptr);
  if (!done("eglCreateWindowSurface")) return false;
  gContext = eglCreateContext(gDisplay, config, EGL_NO_CONTEXT, version);
  if (!done("eglCreateContext")) return false;
  return eglMakeCurrent(gDisplay, gSurface, gSurface, gContext) == EGL_TRUE;
}

static void setCamera() {
  rcClearColor(0.73f, 0.2f, 0.23f, 1.0f);
  rcViewport(0, 0, kWidth, kHeight);
  rcuPerspective(60.0f, (float)kWidth / kHeight, 1.0f, 500.0f);
  rcuLookAt(-3, 0, 0, 0, 0, -8, 0, 1, 0);
}

// The values are set, but as in the guide no light is enabled: the default light shines.
static void setLight() {
  static const float ambient[] = {0.2f, 0.2f, 0.2f, 1}, diffuse[] = {0.7f, 0.7f, 0.7f, 1}, specular[] = {1, 1, 1, 1};
  static const float position[] = {0.0f, -0.5f, 1.0f, 1.0f};
  rcLightfv(RC_LIGHT0, RC_POSITION, position);
  rcLightfv(RC_LIGHT0, RC_AMBIENT, ambient);
  rcLightfv(RC_LIGHT0, RC_DIFFUSE, diffuse);
  rcLightfv(RC_LIGHT0, RC_SPECULAR, specular);
}

enum { kFrame, kMirror, kTriangle };
static RCuint gMaterials[3];

static void makeMaterials() {
  static const float colours[3][3] = {{0.2f, 0.4f, 0.8f}, {0.0f, 0.8f, 0.4f}, {0.0f, 1.0f, 0.0f}};
  static const float whole[] = {1, 1, 1}, ambient[] = {0.8f, 0.8f, 0.8f}, diffuse[] = {0.2f, 0.2f, 0.0f};
  rcGenMaterials(3, gMaterials);
  for (int i = 0; i < 3; ++i) {
    rcBindMaterial(gMaterials[i]);
    rcMaterialfv(RC_FRONT_AND_BACK, RC_AMBIENT_AND_DIFFUSE, colours[i]);
  }
  rcMaterialfv(RC_FRONT_AND_BACK, RC_AMBIENT, ambient);
  rcMaterialfv(RC_FRONT_AND_BACK, RC_DIFFUSE, diffuse);
  rcBindMaterial(gMaterials[kMirror]);
  rcMaterialfv(RC_FRONT_AND_BACK, RC_REFLECTION, whole);
}

static void drawSquare(RCuint material, float z, float size) {
  static const float square[] = {2, -2, 0, 2, 2, 0, -2, 2, 0, -2, -2, 0};
  rcVertexPointer(3, RC_FLOAT, 0, square);
  rcBindMaterial(material);
  rcPushMatrix();
  rcTranslatef(0, 0, z);
  rcScalef(size, size, size);
  rcDrawArrays(RC_QUADS, 0, 4);
  rcPopMatrix();
}

static void drawTriangle(float angle) {
  static const float vertices[] = {0, 0.707f, 0, -1, -0.707f, 0, 1, -0.707f, 0};
  rcVertexPointer(3, RC_FLOAT, 0, vertices);
  rcBindMaterial(gMaterials[kTriangle]);
  rcPushMatrix();
  rcTranslatef(0, 0, -5);
  rcRotatef(angle, 0, 1, 0);
  rcDrawArrays(RC_TRIANGLES, 0, 3);
  rcPopMatrix();
}

int main() {
  if (!openWindow()) return 1;
  setCamera();
  setLight();
  makeMaterials();
  rcSceneAllInit();
  rcMatrixMode(RC_MODELVIEW);
  rcLoadIdentity();
  rcEnableClientState(RC_VERTEX_ARRAY);
  rcStaticSceneBegin();
  drawSquare(gMaterials[kFrame], -10.0f, 2.0f);
  drawSquare(gMaterials[kMirror], -9.999f, 1.7f);
  rcStaticSceneEnd();

  for (float angle = 0; rcGetError() == RC_NO_ERROR; angle += 10) {
    rcLoadIdentity();
    drawTriangle(angle);
    if (!eglSwapBuffers(gDisplay, gSurface)) break;
  }

  eglMakeCurrent(gDisplay, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroySurface(gDisplay, gSurface);
  eglDestroyContext(gDisplay, gContext);
  eglTerminate(gDisplay);
  return 0;
}
