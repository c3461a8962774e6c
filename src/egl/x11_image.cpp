// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "egl/x11_image.h"

#include <X11/Xutil.h>
#include <X11/extensions/XShm.h>
#include <sys/ipc.h>
#include <sys/shm.h>

#include <bit>
#include <cstdlib>
#include <mutex>

namespace rc::egl {
namespace {

// The state of the one trap that lives: Xlib has a single error handler for the process.
std::mutex sTrapMutex;
::Display *sTrapped = nullptr;
bool sFailed = false;
XErrorHandler sOuter = nullptr;

int noteError(::Display *display, XErrorEvent *event) {
  if (display != sTrapped) return sOuter ? sOuter(display, event) : 0;
  sFailed = true;
  return 0;
}

// The table that puts an 8-bit channel where the visual's mask wants it.
std::array<uint32_t, 256> channelTable(unsigned long mask) {
  const auto bits = static_cast<uint32_t>(mask);
  const int shift = std::countr_zero(bits), width = std::popcount(bits);
  std::array<uint32_t, 256> table{};
  for (uint32_t i = 0; i < 256; ++i) table[i] = bits ? (width <= 8 ? i >> (8 - width) : i << (width - 8)) << shift : 0;
  return table;
}

}  // namespace

ErrorTrap::ErrorTrap(::Display *display) : mDisplay(display) {
  sTrapMutex.lock();
  XSync(display, False);
  sTrapped = display;
  sFailed = false;
  sOuter = XSetErrorHandler(noteError);
}

ErrorTrap::~ErrorTrap() {
  XSync(mDisplay, False);
  XSetErrorHandler(sOuter);
  sTrapped = nullptr;
  sTrapMutex.unlock();
}

bool ErrorTrap::failed() const {
  XSync(mDisplay, False);
  return sFailed;
}

struct X11Image::Shared {
  XShmSegmentInfo info{};
};

X11Image::X11Image(::Display *display, const XWindowAttributes &attributes)
    : mDisplay(display), mVisual(attributes.visual), mDepth(attributes.depth) {
  mChannel = {channelTable(mVisual->red_mask), channelTable(mVisual->green_mask), channelTable(mVisual->blue_mask)};
  mSharedWorks = XShmQueryExtension(display) != 0;
}

X11Image::~X11Image() {
  release();
  if (mGc) XFreeGC(mDisplay, mGc);
}

bool X11Image::put(::Drawable drawable, const hal::Target &picture) {
  if (!resize(picture.width, picture.height)) return false;
  convert(picture);
  const ErrorTrap trap(mDisplay);
  if (!mGc) mGc = XCreateGC(mDisplay, drawable, 0, nullptr);
  const auto width = unsigned(picture.width), height = unsigned(picture.height);
  if (mShared) {
    XShmPutImage(mDisplay, drawable, mGc, mImage, 0, 0, 0, 0, width, height, False);
  } else {
    XPutImage(mDisplay, drawable, mGc, mImage, 0, 0, 0, 0, width, height);
  }
  return !trap.failed();  // which also waits until the server has read the shared memory
}

bool X11Image::resize(int width, int height) {
  if (mImage && mImage->width == width && mImage->height == height) return true;
  release();
  if (mSharedWorks && makeShared(width, height)) return true;
  mSharedWorks = false;
  mImage =
      XCreateImage(mDisplay, mVisual, unsigned(mDepth), ZPixmap, 0, nullptr, unsigned(width), unsigned(height), 32, 0);
  if (!mImage) return false;
  mImage->data = static_cast<char *>(std::malloc(size_t(mImage->bytes_per_line) * size_t(height)));
  if (!mImage->data) release();
  return mImage != nullptr;
}

bool X11Image::makeShared(int width, int height) {
  auto shared = std::make_unique<Shared>();
  mImage = XShmCreateImage(mDisplay, mVisual, unsigned(mDepth), ZPixmap, nullptr, &shared->info, unsigned(width),
                           unsigned(height));
  if (!mImage) return false;
  const size_t bytes = size_t(mImage->bytes_per_line) * size_t(height);
  shared->info.shmid = shmget(IPC_PRIVATE, bytes, IPC_CREAT | 0600);
  void *memory = shared->info.shmid < 0 ? reinterpret_cast<void *>(-1) : shmat(shared->info.shmid, nullptr, 0);
  bool attached = false;
  if (memory != reinterpret_cast<void *>(-1)) {
    shared->info.shmaddr = mImage->data = static_cast<char *>(memory);
    const ErrorTrap trap(mDisplay);
    attached = XShmAttach(mDisplay, &shared->info) && !trap.failed();
  }
  // Marked for removal at once: it lives until both sides have let go, even if the program crashes.
  if (shared->info.shmid >= 0) shmctl(shared->info.shmid, IPC_RMID, nullptr);
  if (attached) {
    mShared = std::move(shared);
    return true;
  }
  if (memory != reinterpret_cast<void *>(-1)) shmdt(memory);
  mImage->data = nullptr;
  XDestroyImage(mImage);
  mImage = nullptr;
  return false;
}

void X11Image::release() {
  if (!mImage) return;
  if (mShared) {
    const ErrorTrap trap(mDisplay);
    XShmDetach(mDisplay, &mShared->info);
    XSync(mDisplay, False);
    shmdt(mShared->info.shmaddr);
    mImage->data = nullptr;
    mShared = nullptr;
  }
  XDestroyImage(mImage);  // frees the pixels that are not shared
  mImage = nullptr;
}

void X11Image::convert(const hal::Target &picture) {
  const bool wide = mImage->bits_per_pixel == 32;
  for (int y = 0; y < picture.height; ++y) {
    const uint32_t *source = picture.pixels + size_t(y) * size_t(picture.width);
    char *row = mImage->data + size_t(y) * size_t(mImage->bytes_per_line);
    for (int x = 0; x < picture.width; ++x) {
      const uint32_t rgba = source[x];
      const uint32_t pixel = mChannel[0][rgba & 255] | mChannel[1][rgba >> 8 & 255] | mChannel[2][rgba >> 16 & 255];
      if (wide) {
        reinterpret_cast<uint32_t *>(row)[x] = pixel;
      } else {
        XPutPixel(mImage, x, y, pixel);
      }
    }
  }
}

}  // namespace rc::egl
