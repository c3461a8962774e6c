/* SPDX-License-Identifier: Apache-2.0
 * SPDX-FileCopyrightText: The raycore authors
 *
 * A program in C99, without the framework.
 */
#include <EGL/egl.h>
#include <RC/rcu.h>

int main(void) {
  static const RCfloat vertices[] = {-1, -1, -4, 1, -1, -4, 0, 1, -4};
  EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  EGLConfig config;
  EGLint count;
  EGLSurface surface;
  if (!eglInitialize(display, 0, 0) || !eglChooseConfig(display, 0, &config, 1, &count)) return 1;
  surface = eglCreateWindowSurface(display, config, 0, 0);
  if (!eglMakeCurrent(display, surface, surface, eglCreateContext(display, config, 0, 0))) return 1;
  rcEnableClientState(RC_VERTEX_ARRAY);
  rcVertexPointer(3, RC_FLOAT, 0, vertices);
  do {
    rcDrawArrays(RC_TRIANGLES, 0, 3);
  } while (eglSwapBuffers(display, surface) && rcGetError() == RC_NO_ERROR);
  return 1;
}
