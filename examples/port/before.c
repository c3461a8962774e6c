/* SPDX-License-Identifier: Apache-2.0
 * SPDX-FileCopyrightText: The raycore authors
 *
 * A program in OpenGL ES 1.1: crates and a ball on a floor, two lights, textures. Writes its last frame as a PPM file.
 *
 *   before picture.ppm
 */
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES/gl.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { kWidth = 800, kHeight = 480, kFrames = 3, kAround = 48, kUpwards = 24, kFloorCells = 40 };

static const float kPi = 3.14159265f;

/* ---- pictures ---- */

static GLuint gCrate, gFloor;

static void load(GLuint texture, int side, const unsigned char *rgb) {
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, side, side, 0, GL_RGB, GL_UNSIGNED_BYTE, rgb);
}

static void makeTextures(void) {
  static unsigned char rgb[64 * 64 * 3];
  GLuint names[2];
  int x, y, i = 0;
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glGenTextures(2, names);
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
  glDisable(GL_TEXTURE_2D);
  glEnableClientState(GL_NORMAL_ARRAY);
  glVertexPointer(3, GL_FLOAT, 0, gBall);
  glNormalPointer(GL_FLOAT, 0, gBall);
  glDrawArrays(GL_TRIANGLES, 0, 2 * kAround * kUpwards * 3);
  glDisableClientState(GL_NORMAL_ARRAY);
}

static void drawCrate(void) {
  static const float sides[6][3] = {{0, 0, 1}, {90, 0, 1}, {180, 0, 1}, {270, 0, 1}, {90, 1, 0}, {-90, 1, 0}};
  static const float square[] = {-1, -1, 1, 1, -1, 1, -1, 1, 1, 1, 1, 1};
  static const float once[] = {0, 0, 1, 0, 0, 1, 1, 1};
  int i;
  glEnable(GL_TEXTURE_2D);
  glBindTexture(GL_TEXTURE_2D, gCrate);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glVertexPointer(3, GL_FLOAT, 0, square);
  glTexCoordPointer(2, GL_FLOAT, 0, once);
  glNormal3f(0, 0, 1);
  for (i = 0; i < 6; ++i) {
    glPushMatrix();
    glRotatef(sides[i][0], sides[i][1], sides[i][2], 0);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glPopMatrix();
  }
  glDisableClientState(GL_TEXTURE_COORD_ARRAY);
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
  glEnable(GL_TEXTURE_2D);
  glBindTexture(GL_TEXTURE_2D, gFloor);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glVertexPointer(3, GL_FLOAT, 0, corners);
  glTexCoordPointer(2, GL_FLOAT, 0, texCoords);
  glNormal3f(0, 1, 0);
  glDrawArrays(GL_TRIANGLES, 0, kFloorCells * kFloorCells * 6);
  glDisableClientState(GL_TEXTURE_COORD_ARRAY);
}

/* ---- camera and lights ---- */

/* The window at distance near, as gluPerspective has it. */
static void perspective(float fovy, float aspect, float near, float far) {
  const float top = near * tanf(fovy * kPi / 360), right = top * aspect;
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glFrustumf(-right, right, -top, top, near, far);
  glMatrixMode(GL_MODELVIEW);
}

/* The world seen from an eye that looks down a little. */
static void lookDown(float angle, float x, float y, float z) {
  glLoadIdentity();
  glRotatef(angle, 1, 0, 0);
  glTranslatef(-x, -y, -z);
}

static void setLights(void) {
  static const float lamp[] = {-3, 5, 4, 1}, warm[] = {0.8f, 0.75f, 0.65f, 1};
  static const float spot[] = {3, 6, 1, 1}, down[] = {-0.3f, -1, -0.2f}, blue[] = {0.5f, 0.6f, 0.9f, 1};
  static const float dim[] = {0.15f, 0.15f, 0.15f, 1}, none[] = {0, 0, 0, 1};
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glLightfv(GL_LIGHT0, GL_POSITION, lamp);
  glLightfv(GL_LIGHT0, GL_AMBIENT, dim);
  glLightfv(GL_LIGHT0, GL_DIFFUSE, warm);
  glLightfv(GL_LIGHT0, GL_SPECULAR, warm);
  glEnable(GL_LIGHT1);
  glLightfv(GL_LIGHT1, GL_POSITION, spot);
  glLightfv(GL_LIGHT1, GL_SPOT_DIRECTION, down);
  glLightf(GL_LIGHT1, GL_SPOT_CUTOFF, 25);
  glLightf(GL_LIGHT1, GL_SPOT_EXPONENT, 4);
  glLightfv(GL_LIGHT1, GL_AMBIENT, none);
  glLightfv(GL_LIGHT1, GL_DIFFUSE, blue);
  glLightfv(GL_LIGHT1, GL_SPECULAR, none);
}

static void setMaterial(float red, float green, float blue, float shine) {
  const float colour[] = {red, green, blue, 1}, light[] = {shine, shine, shine, 1};
  glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, colour);
  glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, light);
  glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 30);
}

/* ---- the program ---- */

static void initialize(void) {
  glViewport(0, 0, kWidth, kHeight);
  glClearColor(0.45f, 0.6f, 0.8f, 1);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_NORMALIZE);
  makeTextures();
  makeBall();
  perspective(45, (float)kWidth / kHeight, 0.5f, 100);
}

static void draw(int frame) {
  static const float crates[3][4] = {{-2.6f, 0.8f, 0, 20}, {2.4f, 1, -1, -30}, {2.2f, 2.6f, -1, 15}};
  int i;
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  lookDown(16, 0, 3.6f, 9);
  setLights();
  glEnableClientState(GL_VERTEX_ARRAY);
  setMaterial(1, 1, 1, 0);
  drawFloor();
  for (i = 0; i < 3; ++i) {
    const float size = i == 2 ? 0.6f : i == 1 ? 1 : 0.8f;
    glPushMatrix();
    glTranslatef(crates[i][0], crates[i][1], crates[i][2]);
    glRotatef(crates[i][3] + (float)frame, 0, 1, 0);
    glScalef(size, size, size);
    drawCrate();
    glPopMatrix();
  }
  setMaterial(0.7f, 0.1f, 0.1f, 0.8f);
  glPushMatrix();
  glTranslatef(0, 1.2f, 0.6f);
  glScalef(1.2f, 1.2f, 1.2f);
  drawBall();
  glPopMatrix();
  glDisableClientState(GL_VERTEX_ARRAY);
}

static int writePicture(const char *name) {
  static unsigned char pixels[kWidth * kHeight * 4];
  FILE *file = fopen(name, "wb");
  int x, y;
  if (!file) return 0;
  glReadPixels(0, 0, kWidth, kHeight, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
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
  if (glGetError() != GL_NO_ERROR) fprintf(stderr, "%s: OpenGL ES found an error\n", argv[0]);
  eglTerminate(gDisplay);
  return written ? 0 : 1;
}
