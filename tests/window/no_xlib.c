/* SPDX-License-Identifier: Apache-2.0
 * SPDX-FileCopyrightText: The raycore authors
 *
 * Preloaded into programs that must not come near an X server: the call with which every use of one begins ends them.
 */
#include <stdio.h>
#include <stdlib.h>

__attribute__((visibility("default"))) void *XOpenDisplay(const char *name);
void *XOpenDisplay(const char *name) {
  fprintf(stderr, "XOpenDisplay(%s) was called\n", name ? name : "NULL");
  abort();
}
