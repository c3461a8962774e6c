// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// swap.h: what happens at eglSwapBuffers: trace, capture, show, count. [spec 3.7, 6]
#pragma once

#include "egl/thread.h"

namespace rc::egl {

// False if the window is gone. May end the process: at the count of RAYCORE_FRAMES, or when the user closes a
// window that the library made.
bool swapBuffers(RenderContext &context, Surface &surface);

}  // namespace rc::egl
