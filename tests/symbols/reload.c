/* SPDX-License-Identifier: Apache-2.0
 * SPDX-FileCopyrightText: The raycore authors
 *
 * reload LIBRARY TIMES: loads the library, draws a frame off-screen, lets everything go and unloads it, so many times.
 * After the first tenth no memory mapping, file, thread or key of threads is added, and hardly any memory. */
#include <EGL/egl.h>
#include <dirent.h>
#include <dlfcn.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

static long entriesOf(const char *folder) {
  long count = 0;
  DIR *open = opendir(folder);
  if (!open) return -1;
  while (readdir(open)) ++count;
  closedir(open);
  return count;
}

static long linesOf(const char *path) {
  long count = 0;
  int c;
  FILE *file = fopen(path, "r");
  if (!file) return -1;
  while ((c = getc(file)) != EOF) count += c == '\n';
  fclose(file);
  return count;
}

static long residentPages(void) {
  long size = 0, resident = -1;
  FILE *file = fopen("/proc/self/statm", "r");
  if (!file) return -1;
  if (fscanf(file, "%ld %ld", &size, &resident) != 2) resident = -1;
  fclose(file);
  return resident;
}

/* The next key is the lowest free one. */
static long keysInUse(void) {
  pthread_key_t key;
  if (pthread_key_create(&key, NULL) != 0) return -1;
  pthread_key_delete(key);
  return (long)key;
}

struct Footprint {
  long mappings, files, threads, keys, pages;
};

static struct Footprint footprint(void) {
  struct Footprint now;
  now.mappings = linesOf("/proc/self/maps");
  now.files = entriesOf("/proc/self/fd");
  now.threads = entriesOf("/proc/self/task");
  now.keys = keysInUse();
  now.pages = residentPages();
  return now;
}

#define FIND(type, name, arguments) \
  type(*name) arguments;            \
  *(void **)&name = dlsym(library, #name)

static int drawOnce(const char *path) {
  static const EGLint size[] = {EGL_WIDTH, 32, EGL_HEIGHT, 32, EGL_NONE};
  static const float triangle[] = {-1, -1, -2, 1, -1, -2, 0, 1, -2};
  EGLConfig config = NULL;
  EGLint count = 0;
  void *library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  if (!library) return fprintf(stderr, "%s\n", dlerror()), 0;
  FIND(EGLDisplay, eglGetDisplay, (EGLNativeDisplayType));
  FIND(EGLBoolean, eglInitialize, (EGLDisplay, EGLint *, EGLint *));
  FIND(EGLBoolean, eglChooseConfig, (EGLDisplay, const EGLint *, EGLConfig *, EGLint, EGLint *));
  FIND(EGLSurface, eglCreatePbufferSurface, (EGLDisplay, EGLConfig, const EGLint *));
  FIND(EGLContext, eglCreateContext, (EGLDisplay, EGLConfig, EGLContext, const EGLint *));
  FIND(EGLBoolean, eglMakeCurrent, (EGLDisplay, EGLSurface, EGLSurface, EGLContext));
  FIND(EGLBoolean, eglSwapBuffers, (EGLDisplay, EGLSurface));
  FIND(EGLBoolean, eglTerminate, (EGLDisplay));
  FIND(EGLBoolean, eglReleaseThread, (void));
  FIND(void, rcEnableClientState, (unsigned));
  FIND(void, rcVertexPointer, (int, unsigned, int, const void *));
  FIND(void, rcDrawArrays, (unsigned, int, int));
  FIND(unsigned, rcGetError, (void));

  const EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  if (!eglInitialize(display, NULL, NULL) || !eglChooseConfig(display, NULL, &config, 1, &count)) return 0;
  const EGLSurface surface = eglCreatePbufferSurface(display, config, size);
  if (!eglMakeCurrent(display, surface, surface, eglCreateContext(display, config, EGL_NO_CONTEXT, NULL))) return 0;
  rcEnableClientState(0x8074);             /* RC_VERTEX_ARRAY */
  rcVertexPointer(3, 0x1406, 0, triangle); /* RC_FLOAT */
  rcDrawArrays(4, 0, 3);                   /* RC_TRIANGLES */
  const int drawn = eglSwapBuffers(display, surface) && rcGetError() == 0;
  return eglReleaseThread() && eglTerminate(display) && eglReleaseThread() && drawn && dlclose(library) == 0;
}

static int grew(const char *what, long before, long after, long allowed) {
  printf("%-8s %ld -> %ld\n", what, before, after);
  return after > before + allowed;
}

int main(int argc, char **argv) {
  const long times = argc > 2 ? atol(argv[2]) : 1000;
  struct Footprint before = {0, 0, 0, 0, 0}, after;
  long i;
  if (argc < 2) return fprintf(stderr, "usage: %s LIBRARY [TIMES]\n", argv[0]), 2;
  for (i = 0; i < times; ++i) {
    if (i == times / 10) before = footprint();
    if (!drawOnce(argv[1])) return fprintf(stderr, "it fails at the %ldth time\n", i + 1), 1;
  }
  after = footprint();
  /* A thread more or less may be on its way; allocators keep a few pages. */
  return grew("mappings", before.mappings, after.mappings, 8) | grew("files", before.files, after.files, 0) |
         grew("threads", before.threads, after.threads, 0) | grew("keys", before.keys, after.keys, 0) |
         grew("pages", before.pages, after.pages, 512);
}
