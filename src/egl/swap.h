// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// swap.h: what happens at eglSwapBuffers: trace, capture, show, count. [spec 3.7, 6]
#pragma once

#include "egl/thread.h"

namespace rc::egl {

// False if the window is gone, as far as it is known: the picture may be traced and shown while the program goes on.
// May end the process: at the count of RAYCORE_FRAMES, or when the user closes a
// window that the library made.
bool swapBuffers(RenderContext &context, const std::shared_ptr<Surface> &surface);

}  // namespace rc::egl
