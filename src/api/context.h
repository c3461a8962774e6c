// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// context.h: a rendering context: state, objects, scene, and the driver that traces them. [spec 1, 3.7, 3.8]
// EGL makes contexts, gives them a surface, and asks for the picture at a swap; the entry points change them.
#pragma once

#include <atomic>
#include <functional>
#include <string>

#include "api/material_table.h"
#include "api/name_table.h"
#include "api/profile.h"
#include "api/state.h"
#include "base/fork.h"
#include "rcddk/driver.h"

namespace rc::api {

// Where pictures go; EGL's surfaces are such.
class DrawSurface {
 public:
  virtual ~DrawSurface() = default;
  // The back buffer at the size the surface has now.
  virtual hal::Target backBuffer() = 0;
  // Samples a pixel that its configuration asks for, 1 or more.
  virtual int samples() const { return 1; }
  // A picture of all that was drawn so far is about to be traced into it; it was. The latter on any thread.
  virtual void asked() {}
  virtual void traced() {}
  // There is no picture of it, for want of memory.
  virtual void failed() {}
};

// What contexts of one share group have in common.
struct SharedObjects {
  // Held by every call of every context of the group, so that contexts on several threads can share objects.
  ForkMutex mutex;
  NameTable<ddk::Texture> textures;
  NameTable<Buffer> buffers;
  MaterialTable materials{textures.bind(0)};
  std::atomic<uint64_t> changes = 0;  // counts what any context of the group changed; read without the mutex too
};

// Whom rcDebugMessageCallbackRCX named.
struct DebugCallback {
  RCDEBUGPROCRCX call = nullptr;
  const RCvoid *userParam = nullptr;
};

// The error a call raised, for the tracer.
struct Failure {
  RCenum error = RC_NO_ERROR;
  std::string reason;  // kept while somebody wants to know: the tracer, the log, the callback
};

class Context {
 public:
  explicit Context(const Settings &settings, std::shared_ptr<SharedObjects> shared = nullptr);

  State state;
  ddk::Scene scene;

  const Profile &profile() const { return mProfile; }
  SharedObjects &objects() { return *mObjects; }
  const SharedObjects &objects() const { return *mObjects; }
  std::shared_ptr<SharedObjects> shared() const { return mObjects; }
  ddk::Driver &driver() { return mDriver; }
  // Of the last picture that somebody waited for.
  const ddk::FrameStats &lastFrame() const { return mLastFrame; }

  // What rcMaterial* and rcEnable(RC_TEXTURE_2D) change.
  ddk::Material &boundMaterial() {
    return state.boundMaterial == 0 ? state.material0 : mObjects->materials[state.boundMaterial];
  }
  const ddk::Material &boundMaterial() const {
    return state.boundMaterial == 0 ? state.material0 : mObjects->materials[state.boundMaterial];
  }

  // The next rcFinish has something to do, here and in the contexts that share objects. Every call that changes what
  // a picture shows says so.
  void touch() {
    ++mObjects->changes;
    ++mChanges;
  }

  // Where the picture goes from now on; null for none. The first surface sets the viewport. What is the context's own
  // is changed and nothing else: this waits for no frame of the contexts that share objects.
  void attach(DrawSurface *surface);
  // Samples a pixel of the next frame.
  int samples() const;
  // Traces the frame if something changed since the last picture.
  void finish();
  // The same, and `show` shows the picture: beside what the program goes on with, if that is possible, and the next
  // call that needs the picture, or what it is made of, waits for it. Dynamic geometry ends here. An error of such a
  // picture is noted when somebody waits for it. [eglSwapBuffers]
  void finishAndShow(std::function<void()> show);
  // Waits for the picture that is on its way, and for nobody else.
  void awaitPicture() { mBackground.wait(); }
  // The same, and what became of it is noted: for all that uses what it is made of.
  void await();
  // All that was drawn is in the picture, and waited for. What moved in a picture that was swapped ended with it, which
  // alone asks for no other one: the picture is still that which was swapped.
  void complete();
  // Whether a surface waits for a picture of something that the program did. Waits for nobody either.
  bool pending() const;
  // The picture as it is after all that was drawn, row by row from the top; no pixels where there is no surface.
  hal::Target picture();
  // The primary rays of pixels of that picture. take is called on any thread.
  void probe(const hal::PixelRect &part,
             const std::function<void(int column, int row, const ddk::RayAnswer &answer)> &take);
  // What structures are built from now on.
  AccelKind accelKind() const;
  // A draw call had no vertex array, or an array without memory: it draws nothing.
  void noteEmptyDraw() { ++mEmptyDraws; }
  void noteTransformed(double milliseconds) { mTransformMilliseconds += milliseconds; }
  // From the next frame on it is known where the time goes.
  void measureUnits() const { mMeasuresUnits = true; }
  // The picture was shown: dynamic geometry ends here.
  void endFrame();
  // Modelview and texture matrix begin anew where the profile says so. [spec 8]
  void resetMatrices();

  // Notes the first error and logs every one: "rcFrustum: RC_INVALID_VALUE: zNear is -1, not above 0".
  [[gnu::format(printf, 3, 4)]] void fail(RCenum error, const char *reason, ...);
  RCenum takeError();
  void setDebugCallback(const DebugCallback &callback) { mDebugCallback = callback; }
  // A call begins.
  void enterFunction(const char *name) {
    mFunction = name;
    mFailure.error = RC_NO_ERROR;
  }
  // What the call in hand, or the last one, raised.
  const Failure &failure() const { return mFailure; }
  // The frame that is being made, from 1.
  uint64_t frameNumber() const { return mFrame + 1; }

 private:
  static constexpr uint64_t kNever = UINT64_MAX;

  // A picture that is traced, or about to be.
  struct Picture {
    Picture(const ddk::FrameState &state, ddk::Scene &scene) : frame(state, scene) {}

    ddk::Frame frame;
    bool build = false;  // the structure of what is dynamic
    DrawSurface *surface = nullptr;
    hal::Target target;
    ddk::FrameStats stats;
    uint64_t number = 0;
  };

  ddk::FrameState frameState() const;
  std::unique_ptr<Picture> beginPicture();
  std::unique_ptr<Picture> nextPicture();
  void trace(Picture &picture);
  void show(const std::function<void()> &show);
  void makePicture(const std::function<void()> &show) noexcept;
  void pictureFailed();
  void abandonStaticScene();
  static void report(const Picture &picture);
  void tellCallback();

  const Profile &mProfile;
  int mSamples;
  bool mPipelines;
  std::shared_ptr<SharedObjects> mObjects;
  ddk::Driver mDriver;
  DrawSurface *mSurface = nullptr;
  bool mHadSurface = false;
  uint64_t mTraced = kNever;  // SharedObjects::changes when the last picture of this surface was traced
  uint64_t mChanges = 0;      // that this context made
  uint64_t mEnded = kNever;   // mChanges when the last frame ended: what others change asks for no other picture of it
  uint64_t mFrame = 0;
  int mWidth = 0, mHeight = 0;  // of the last picture
  ddk::FrameStats mLastFrame;
  size_t mEmptyDraws = 0;  // since the last picture
  double mTransformMilliseconds = 0, mPresentMilliseconds = 0;
  mutable bool mMeasuresUnits = false;  // turned on by a question
  RCenum mError = RC_NO_ERROR;
  Failure mFailure;
  DebugCallback mDebugCallback;
  const char *mFunction = "";
  std::unique_ptr<Picture> mOnItsWay;  // while mBackground makes it nothing but that touches it
  bool mLost = false;                  // it is not made, for want of memory
  Background mBackground;              // the last member, so that it ends first
};

// The context of the calling thread, or null.
Context *currentContext();
void setCurrentContext(Context *context);

}  // namespace rc::api
