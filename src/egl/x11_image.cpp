// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "egl/x11_image.h"

#include <X11/Xutil.h>
#include <X11/extensions/XShm.h>
#include <sys/ipc.h>
#include <sys/shm.h>

#include <cstdlib>

namespace rc::egl {
struct X11Image::Shared {
  XShmSegmentInfo info{};
};

bool X11Image::serverShares(const X11Connection &connection) {
  const ErrorTrap trap(connection);
  return connection.alive() && XShmQueryExtension(connection.display());
}

X11Image::X11Image(const X11Connection &connection, const ColourMasks &masks, int depth)
    : mConnection(connection),
      mDisplay(connection.display()),
      mDepth(depth),
      mSharedWorks(serverShares(connection)),
      mFormat(masks, depth) {}

X11Image::~X11Image() {
  release();
  if (!mGc) return;
  const ErrorTrap trap(mConnection);
  if (mConnection.alive()) {
    XFreeGC(mDisplay, mGc);
  } else {
    XFree(mGc);  // our side of it
  }
}

bool X11Image::put(::Drawable drawable, const hal::Target &picture) {
  if (picture.width == 0 || picture.height == 0) return true;
  if (!mConnection.alive() || !resize(picture.width, picture.height)) return false;
  mFormat.store(picture, *mImage);
  const ErrorTrap trap(mConnection);
  if (!mConnection.alive()) return false;
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
  // Without a visual: of the masks in it nothing here makes use.
  mImage =
      XCreateImage(mDisplay, nullptr, unsigned(mDepth), ZPixmap, 0, nullptr, unsigned(width), unsigned(height), 32, 0);
  if (!mImage) return false;
  mImage->data = static_cast<char *>(std::malloc(size_t(mImage->bytes_per_line) * size_t(height)));
  if (!mImage->data) release();
  return mImage != nullptr;
}

bool X11Image::makeShared(int width, int height) {
  auto shared = std::make_unique<Shared>();
  mImage = XShmCreateImage(mDisplay, nullptr, unsigned(mDepth), ZPixmap, nullptr, &shared->info, unsigned(width),
                           unsigned(height));
  if (!mImage) return false;
  const size_t bytes = size_t(mImage->bytes_per_line) * size_t(height);
  shared->info.shmid = shmget(IPC_PRIVATE, bytes, IPC_CREAT | 0600);
  void *memory = shared->info.shmid < 0 ? reinterpret_cast<void *>(-1) : shmat(shared->info.shmid, nullptr, 0);
  bool attached = false;
  if (memory != reinterpret_cast<void *>(-1)) {
    shared->info.shmaddr = mImage->data = static_cast<char *>(memory);
    const ErrorTrap trap(mConnection);
    attached = mConnection.alive() && XShmAttach(mDisplay, &shared->info) && !trap.failed();
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
    {
      const ErrorTrap trap(mConnection);
      if (mConnection.alive()) XShmDetach(mDisplay, &mShared->info);
    }
    shmdt(mShared->info.shmaddr);
    mImage->data = nullptr;
    mShared = nullptr;
  }
  XDestroyImage(mImage);  // frees the pixels that are not shared
  mImage = nullptr;
}

}  // namespace rc::egl
