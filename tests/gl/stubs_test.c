/* SPDX-License-Identifier: Apache-2.0
 * SPDX-FileCopyrightText: The raycore authors
 *
 * The gl names of the shared library: all there, empty, and out of the way of a library behind it. [reference 1.7]
 */
#include <RC/rc.h>
#include <dlfcn.h>
#include <stdio.h>

typedef unsigned int (*GetError)(void);
typedef const unsigned char *(*GetString)(unsigned int);
typedef unsigned char (*IsObject)(unsigned int);
typedef void (*ClipPlane)(unsigned int, const float *);

static int failures;

static void expect(int condition, const char *what) {
  if (condition) return;
  printf("failed: %s\n", what);
  ++failures;
}

int main(int argc, char **argv) {
  const float plane[4] = {0, 0, 1, 0};
  int names = 0;
  (void)rcGetError(); /* links the library */
#define GL_FUNCTION(result, name, parameters, arguments) \
  ++names;                                               \
  expect(dlsym(RTLD_DEFAULT, #name) != NULL, #name);
#include "gl/functions.inc"
#undef GL_FUNCTION
  expect(names == 145, "145 names");
  expect(((GetError)dlsym(RTLD_DEFAULT, "glGetError"))() == 0, "glGetError is GL_NO_ERROR");
  expect(((GetString)dlsym(RTLD_DEFAULT, "glGetString"))(0x1F00) == NULL, "glGetString is NULL");
  expect(((IsObject)dlsym(RTLD_DEFAULT, "glIsBuffer"))(7) == 0, "glIsBuffer is false");
  ((ClipPlane)dlsym(RTLD_DEFAULT, "glClipPlanef"))(0x3000, plane);
  expect(((IsObject)dlsym(RTLD_DEFAULT, "glIsTexture"))(7) == 1, "glIsTexture is that of the library behind");
  expect(((IsObject)dlsym(RTLD_DEFAULT, "glIsTexture"))(8) == 0, "glIsTexture passes its argument");
  expect(argc == 2 && dlopen(argv[1], RTLD_NOW | RTLD_GLOBAL) != NULL, "usage: stubs_test LIBRARY");
  expect(((IsObject)dlsym(RTLD_DEFAULT, "glIsBuffer"))(7) == 1, "glIsBuffer is that of a library loaded later");
  expect(rcGetError() == RC_NO_ERROR, "no gl call reaches the rc state");
  return failures != 0;
}
