/* SPDX-License-Identifier: Apache-2.0
 * SPDX-FileCopyrightText: The raycore authors
 *
 * before.c after its port to RayCore: crates and a ball on a floor, two lights, textures. Writes its last frame as a
 * PPM file.
 *
 *   after picture.ppm
 */
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <RC/rcu.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { kWidth = 800, kHeight = 480, kFrames = 3, kAround = 48, kUpwards = 24, kFloorCells = 40 };

static const float kPi = 3.14159265f;

/* ---- pictures ---- */

static RCuint gCrate, gFloor;

static void load(RCuint texture, int side, const unsigned char *rgb) {
  rcBindTexture(RC_TEXTURE_2D, texture);
  rcTexEnvi(RC_TEXTURE_ENV, RC_TEXTURE_ENV_MODE, RC_MODULATE); /* RayCore begins with RC_REPLACE */
  rcTexParameteri(RC_TEXTURE_2D, RC_TEXTURE_MIN_FILTER, RC_LINEAR_MIPMAP_NEAREST);
  rcTexParameteri(RC_TEXTURE_2D, RC_GENERATE_MIPMAP, RC_TRUE);
  rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGB, side, side, 0, RC_RGB, RC_UNSIGNED_BYTE, rgb);
}

static void makeTextures(void) {
  static unsigned char rgb[64 * 64 * 3];
  RCuint names[2];
  int x, y, i = 0;
  rcPixelStorei(RC_UNPACK_ALIGNMENT, 1);
  rcGenTextures(2, names);
  gCrate = names[0], gFloor = names[1];
  for (y = 0; y < 64; ++y) {
    for (x = 0; x < 64; ++x) {
      const int frame = x < 6 || y < 6 || x > 57 || y > 57 || abs(x - y) < 4;
      const int tone = frame ? 210 : 150 + 25 * ((y / 8) % 2);
      rgb[i++] = (unsigned char)tone, rgb[i++] = (unsigned char)(tone * 7 / 10),
      rgb[i++] = (unsigned char)(tone * 4 / 10);
    }
  }
  load(gCrate, 64, rgb);
  for (i = 0, y = 0; y < 64; ++y) {
    for (x = 0; x < 64; ++x) {
      const int light = (x < 32) != (y < 32);
      rgb[i++] = light ? 220 : 70, rgb[i++] = light ? 220 : 80, rgb[i++] = light ? 210 : 95;
    }
  }
  load(gFloor, 64, rgb);
}

/* ---- shapes ---- */

static float gBall[2 * kAround * kUpwards * 3 * 3];

static void makeBall(void) {
  float *out = gBall;
  int i, j, k;
  for (j = 0; j < kUpwards; ++j) {
    for (i = 0; i < kAround; ++i) {
      static const int corners[6][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
      for (k = 0; k < 6; ++k) {
        const float a = 2 * kPi * (float)(i + corners[k][0]) / kAround;
        const float b = kPi * ((float)(j + corners[k][1]) / kUpwards - 0.5f);
        *out++ = sinf(a) * cosf(b), *out++ = sinf(b), *out++ = cosf(a) * cosf(b);
      }
    }
  }
}

static void drawBall(void) {
  rcDisable(RC_TEXTURE_2D);
  rcEnableClientState(RC_NORMAL_ARRAY);
  rcVertexPointer(3, RC_FLOAT, 0, gBall);
  rcNormalPointer(RC_FLOAT, 0, gBall);
  rcDrawArrays(RC_TRIANGLES, 0, 2 * kAround * kUpwards * 3);
  rcDisableClientState(RC_NORMAL_ARRAY);
}

static void drawCrate(void) {
  static const float sides[6][3] = {{0, 0, 1}, {90, 0, 1}, {180, 0, 1}, {270, 0, 1}, {90, 1, 0}, {-90, 1, 0}};
  static const float square[] = {-1, -1, 1, 1, -1, 1, -1, 1, 1, 1, 1, 1};
  static const float once[] = {0, 0, 1, 0, 0, 1, 1, 1};
  int i;
  rcEnable(RC_TEXTURE_2D);
  rcBindTexture(RC_TEXTURE_2D, gCrate);
  rcEnableClientState(RC_TEXTURE_COORD_ARRAY);
  rcVertexPointer(3, RC_FLOAT, 0, square);
  rcTexCoordPointer(2, RC_FLOAT, 0, once);
  rcNormal3f(0, 0, 1);
  for (i = 0; i < 6; ++i) {
    rcPushMatrix();
    rcRotatef(sides[i][0], sides[i][1], sides[i][2], 0);
    rcDrawArrays(RC_TRIANGLE_STRIP, 0, 4);
    rcPopMatrix();
  }
  rcDisableClientState(RC_TEXTURE_COORD_ARRAY);
}

/* Many cells, because OpenGL lights vertices and not points between them. */
static void drawFloor(void) {
  static float corners[kFloorCells * kFloorCells * 6 * 3], texCoords[kFloorCells * kFloorCells * 6 * 2];
  float *corner = corners, *texCoord = texCoords;
  int i, j, k;
  for (j = 0; j < kFloorCells; ++j) {
    for (i = 0; i < kFloorCells; ++i) {
      static const int at[6][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
      for (k = 0; k < 6; ++k) {
        const float u = (float)(i + at[k][0]) / kFloorCells, v = (float)(j + at[k][1]) / kFloorCells;
        *corner++ = 20 * u - 10, *corner++ = 0, *corner++ = 10 - 20 * v;
        *texCoord++ = 10 * u, *texCoord++ = 10 * v;
      }
    }
  }
  rcEnable(RC_TEXTURE_2D);
  rcBindTexture(RC_TEXTURE_2D, gFloor);
  rcEnableClientState(RC_TEXTURE_COORD_ARRAY);
  rcVertexPointer(3, RC_FLOAT, 0, corners);
  rcTexCoordPointer(2, RC_FLOAT, 0, texCoords);
  rcNormal3f(0, 1, 0);
  rcDrawArrays(RC_TRIANGLES, 0, kFloorCells * kFloorCells * 6);
  rcDisableClientState(RC_TEXTURE_COORD_ARRAY);
}

/* ---- camera and lights ---- */

/* The window at distance near, as gluPerspective has it. */
static void perspective(float fovy, float aspect, float near, float far) {
  const float top = near * tanf(fovy * kPi / 360), right = top * aspect;
  rcMatrixMode(RC_PROJECTION);
  rcLoadIdentity();
  rcFrustumf(-right, right, -top, top, near, far);
  rcMatrixMode(RC_MODELVIEW);
}

/* The world seen from an eye that looks down a little. The camera is no matrix: modelview begins in the world. */
static void lookDown(float angle, float x, float y, float z) {
  rcLoadIdentity();
  rcuLookAt(x, y, z, x, y - tanf(angle * kPi / 180), z - 1, 0, 1, 0);
}

static void setLights(void) {
  static const float lamp[] = {-3, 5, 4, 1}, warm[] = {0.8f, 0.75f, 0.65f, 1};
  static const float spot[] = {3, 6, 1, 1}, down[] = {-0.3f, -1, -0.2f}, blue[] = {0.5f, 0.6f, 0.9f, 1};
  static const float dim[] = {0.15f, 0.15f, 0.15f, 1}, none[] = {0, 0, 0, 1};
  static const float everywhere[] = {0.2f, 0.2f, 0.2f, 1}; /* where OpenGL begins, and RayCore does not */
  rcLightModelfv(RC_LIGHT_MODEL_AMBIENT, everywhere);
  rcEnable(RC_LIGHTING);
  rcEnable(RC_LIGHT0);
  rcLightfv(RC_LIGHT0, RC_POSITION, lamp);
  rcLightfv(RC_LIGHT0, RC_AMBIENT, dim);
  rcLightfv(RC_LIGHT0, RC_DIFFUSE, warm);
  rcLightfv(RC_LIGHT0, RC_SPECULAR, warm);
  rcEnable(RC_LIGHT1);
  rcLightfv(RC_LIGHT1, RC_POSITION, spot);
  rcLightfv(RC_LIGHT1, RC_SPOT_DIRECTION, down);
  rcLightf(RC_LIGHT1, RC_SPOT_CUTOFF, 25);
  rcLightf(RC_LIGHT1, RC_SPOT_EXPONENT, 4);
  rcLightfv(RC_LIGHT1, RC_AMBIENT, none);
  rcLightfv(RC_LIGHT1, RC_DIFFUSE, blue);
  rcLightfv(RC_LIGHT1, RC_SPECULAR, none);
}

static void setMaterial(float red, float green, float blue, float shine) {
  const float colour[] = {red, green, blue, 1}, light[] = {shine, shine, shine, 1};
  rcMaterialfv(RC_FRONT_AND_BACK, RC_AMBIENT_AND_DIFFUSE, colour);
  rcMaterialfv(RC_FRONT_AND_BACK, RC_SPECULAR, light);
  rcMaterialf(RC_FRONT_AND_BACK, RC_SHININESS, 30);
}

/* ---- the program ---- */

static void initialize(void) {
  rcViewport(0, 0, kWidth, kHeight);
  rcClearColor(0.45f, 0.6f, 0.8f, 1);
  rcEnable(RC_DEPTH_TEST);
  rcEnable(RC_NORMALIZE);
  makeTextures();
  makeBall();
  perspective(45, (float)kWidth / kHeight, 0.5f, 100);
}

static void draw(int frame) {
  static const float crates[3][4] = {{-2.6f, 0.8f, 0, 20}, {2.4f, 1, -1, -30}, {2.2f, 2.6f, -1, 15}};
  int i;
  rcClear(RC_COLOR_BUFFER_BIT | RC_DEPTH_BUFFER_BIT);
  lookDown(16, 0, 3.6f, 9);
  setLights();
  rcEnableClientState(RC_VERTEX_ARRAY);
  setMaterial(1, 1, 1, 0);
  drawFloor();
  for (i = 0; i < 3; ++i) {
    const float size = i == 2 ? 0.6f : i == 1 ? 1 : 0.8f;
    rcPushMatrix();
    rcTranslatef(crates[i][0], crates[i][1], crates[i][2]);
    rcRotatef(crates[i][3] + (float)frame, 0, 1, 0);
    rcScalef(size, size, size);
    drawCrate();
    rcPopMatrix();
  }
  setMaterial(0.7f, 0.1f, 0.1f, 0.8f);
  rcMaterialf(RC_FRONT_AND_BACK, RC_REFLECTION, 0.35f); /* new: OpenGL has nothing like it */
  rcPushMatrix();
  rcTranslatef(0, 1.2f, 0.6f);
  rcScalef(1.2f, 1.2f, 1.2f);
  drawBall();
  rcPopMatrix();
  rcMaterialf(RC_FRONT_AND_BACK, RC_REFLECTION, 0);
  rcDisableClientState(RC_VERTEX_ARRAY);
}

static int writePicture(const char *name) {
  static unsigned char pixels[kWidth * kHeight * 4];
  FILE *file = fopen(name, "wb");
  int x, y;
  if (!file) return 0;
  rcReadPixels(0, 0, kWidth, kHeight, RC_RGBA, RC_UNSIGNED_BYTE, pixels);
  fprintf(file, "P6 %d %d 255\n", kWidth, kHeight);
  for (y = kHeight - 1; y >= 0; --y) {
    for (x = 0; x < kWidth; ++x) fwrite(&pixels[(y * kWidth + x) * 4], 1, 3, file);
  }
  return fclose(file) == 0;
}

static EGLDisplay gDisplay;
static EGLSurface gSurface;

static int openSurface(void) {
  static const EGLint wanted[] = {EGL_SURFACE_TYPE,    EGL_PBUFFER_BIT,   EGL_RED_SIZE, 8, EGL_DEPTH_SIZE, 16,
                                  EGL_RENDERABLE_TYPE, EGL_OPENGL_ES_BIT, EGL_NONE};
  static const EGLint size[] = {EGL_WIDTH, kWidth, EGL_HEIGHT, kHeight, EGL_NONE};
  EGLConfig config;
  EGLint count = 0;
  gDisplay = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
  if (!eglInitialize(gDisplay, NULL, NULL)) return 0;
  if (!eglChooseConfig(gDisplay, wanted, &config, 1, &count) || count == 0) return 0;
  gSurface = eglCreatePbufferSurface(gDisplay, config, size);
  return eglMakeCurrent(gDisplay, gSurface, gSurface, eglCreateContext(gDisplay, config, EGL_NO_CONTEXT, NULL)) ==
         EGL_TRUE;
}

int main(int argc, char **argv) {
  int frame, written;
  if (argc != 2 || !openSurface()) {
    fprintf(stderr, argc != 2 ? "usage: %s PICTURE.ppm\n" : "%s: EGL has no surface without a display\n", argv[0]);
    return 1;
  }
  initialize();
  for (frame = 0; frame < kFrames - 1; ++frame) {
    draw(frame);
    eglSwapBuffers(gDisplay, gSurface);
  }
  draw(frame);
  written = writePicture(argv[1]);
  if (rcGetError() != RC_NO_ERROR) fprintf(stderr, "%s: RayCore found an error\n", argv[0]);
  eglTerminate(gDisplay);
  return written ? 0 : 1;
}
