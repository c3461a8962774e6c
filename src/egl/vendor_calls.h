// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// vendor_calls.h: the functions that the vendor's library exports beside EGL's. No public header has them; programs
// that want them declare them. [reference 1.5]
#pragma once

#include <EGL/egl.h>

#pragma GCC visibility push(default)
extern "C" {

// Writes what the display, and the context that is current, consist of to a file, as text. EGL_BAD_DISPLAY,
// EGL_NOT_INITIALIZED; EGL_BAD_PARAMETER: no name, or the file cannot be written.
void eglDumpSystemRC(EGLDisplay dpy, const char *fileName);

// The number of devices, with report NULL. The hardware's counters have no published layout: EGL_BAD_PARAMETER.
EGLBoolean eglGetReportRegister(EGLDisplay dpy, int *count, void *report);
}
#pragma GCC visibility pop
