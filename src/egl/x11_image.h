// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// x11_image.h: a picture on its way to an X server: through shared memory, or through the connection.
#pragma once

#include <memory>

#include "egl/pixel_format.h"
#include "egl/x11_connection.h"

namespace rc::egl {

class X11Image {
 public:
  X11Image(const X11Connection &connection, const ColourMasks &masks, int depth);
  ~X11Image();
  X11Image(const X11Image &) = delete;
  X11Image &operator=(const X11Image &) = delete;

  // Shows the picture in the upper left corner of the drawable; false if that is gone.
  bool put(::Drawable drawable, const hal::Target &picture);

 private:
  struct Shared;

  static bool serverShares(const X11Connection &connection);
  bool resize(int width, int height);
  bool makeShared(int width, int height);
  void release();

  const X11Connection &mConnection;  // of the owner
  ::Display *mDisplay;
  int mDepth;
  ::GC mGc = nullptr;
  XImage *mImage = nullptr;
  std::unique_ptr<Shared> mShared;  // null where pixels go through the connection
  bool mSharedWorks;                // until an attempt fails: remote servers cannot
  PixelFormat mFormat;
};

}  // namespace rc::egl
