// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Random walks over displays, contexts, surfaces and threads, in whatever order they are made, made current, destroyed
// and terminated: each call is compared with a model of a few lines. [EGL 1.5, 3.2, 3.5, 3.7]
#include <random>
#include <set>

#include "RC/rc.h"
#include "common/worker.h"
#include "egl/egl_fixture.h"

namespace rc::test {
namespace {

constexpr int kNowhere = -1;

struct Object {
  void *handle = nullptr;
  size_t display = 0, config = 0;
  bool isContext = false;
  bool known = true;  // its handle may still be used
  bool destroyed = false;
  int thread = kNowhere;  // where it is current
};

struct ModelThread {
  int display = kNowhere;
  Object *context = nullptr, *draw = nullptr, *read = nullptr;
};

using Errors = std::set<EGLint>;

// What the specification says of objects, and nothing else.
class Model {
 public:
  static constexpr size_t kDisplays = 2, kThreads = 3;

  bool initialized[kDisplays] = {};
  ModelThread threads[kThreads];
  std::vector<std::unique_ptr<Object>> objects;

  bool valid(const Object *object, size_t display, bool isContext) const {
    return object && object->known && object->display == display && object->isContext == isContext;
  }
  void add(void *handle, size_t display, size_t config, bool isContext) {
    objects.push_back(std::make_unique<Object>(Object{handle, display, config, isContext}));
  }
  void terminate(size_t display) {
    initialized[display] = false;
    for (const auto &object : objects) object->known &= object->display != display;
  }
  void destroy(Object &object) {
    object.destroyed = true;
    forget(object);
  }

  // All that is wrong with a call; a call with nothing wrong succeeds.
  Errors errorsOfUse(size_t display, const Object *object, bool isContext) const {
    if (!initialized[display]) return {EGL_NOT_INITIALIZED};
    if (!valid(object, display, isContext)) return {isContext ? EGL_BAD_CONTEXT : EGL_BAD_SURFACE};
    return {};
  }
  Errors errorsOfMakeCurrent(int thread, size_t display, const Object *draw, const Object *read,
                             const Object *context) const {
    if (!draw && !read && !context) return {};
    if (!initialized[display]) return {EGL_NOT_INITIALIZED};
    Errors errors;
    if (!context || !draw != !read) errors.insert(EGL_BAD_MATCH);
    if (context && !valid(context, display, true)) errors.insert(EGL_BAD_CONTEXT);
    for (const Object *surface : {draw, read}) {
      if (surface && !valid(surface, display, false)) errors.insert(EGL_BAD_SURFACE);
      if (surface && context && surface->config != context->config) errors.insert(EGL_BAD_MATCH);
    }
    for (const Object *object : {draw, read, context}) {
      if (object && object->thread != kNowhere && object->thread != thread) errors.insert(EGL_BAD_ACCESS);
    }
    return errors;
  }
  void makeCurrent(int thread, size_t display, Object *draw, Object *read, Object *context) {
    const ModelThread old = threads[thread];
    threads[thread] = {context ? int(display) : kNowhere, context, draw, read};
    for (Object *object : {old.context, old.draw, old.read}) {
      if (object) object->thread = kNowhere;
    }
    for (Object *object : {context, draw, read}) {
      if (object) object->thread = thread;
    }
    for (Object *object : {old.context, old.draw, old.read}) {
      if (object) forget(*object);
    }
  }

 private:
  static void forget(Object &object) { object.known &= !object.destroyed || object.thread != kNowhere; }
};

class Walk : public testing::TestWithParam<unsigned> {
 protected:
  void SetUp() override {
    mDisplays[0] = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    mDisplays[1] = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    ASSERT_TRUE(eglInitialize(mDisplays[0], nullptr, nullptr));
    for (EGLint id : {4, 20}) {
      const EGLint list[] = {EGL_CONFIG_ID, id, EGL_NONE};
      EGLint count = 0;
      ASSERT_TRUE(eglChooseConfig(mDisplays[0], list, &mConfigs[id == 20], 1, &count));
    }
    eglTerminate(mDisplays[0]);
  }
  void TearDown() override {
    for (Worker &worker : mWorkers) worker.run([] { eglReleaseThread(); });
    for (const EGLDisplay display : mDisplays) eglTerminate(display);
    eglGetError();
  }

  size_t below(size_t n) { return std::uniform_int_distribution<size_t>(0, n - 1)(mRandom); }

  // One of the last objects of any kind and display, or none.
  Object *pick(bool isContext) {
    if (mModel.objects.empty() || below(8) == 0) return nullptr;
    for (int attempt = 0; attempt < 8; ++attempt) {
      const size_t last = std::min<size_t>(mModel.objects.size(), 24);
      Object &object = *mModel.objects[mModel.objects.size() - 1 - below(last)];
      if (object.isContext == isContext || below(40) == 0) return &object;
    }
    return nullptr;
  }
  static void *handleOf(const Object *object) { return object ? object->handle : nullptr; }

  // The call's answer and error against what the model allows.
  bool agrees(const char *call, bool succeeded, const Errors &errors) {
    const EGLint error = eglGetError();
    EXPECT_EQ(succeeded, errors.empty()) << call << " " << std::hex << error;
    EXPECT_TRUE(errors.empty() ? error == EGL_SUCCESS : errors.contains(error)) << call << " " << std::hex << error;
    ++mCalls;
    return succeeded;
  }

  void step() {
    const int thread = int(below(Model::kThreads));
    mWorkers[thread].run([&] {
      const size_t action = below(100), display = below(Model::kDisplays);
      if (action < 4) {
        initialize(display);
      } else if (action < 5 && below(3) == 0) {
        terminate(display);
      } else if (action < 15) {
        create(display, true);
      } else if (action < 25) {
        create(display, false);
      } else if (action < 35) {
        destroy(display, pick(action < 30), action < 30);
      } else if (action < 65) {
        makeCurrent(thread, display);
      } else if (action < 68) {
        releaseThread(thread);
      } else if (action < 78) {
        swap(thread, display);
      } else {
        query(display, pick(action < 90), action < 90);
      }
      compareCurrent(mModel.threads[thread]);
    });
  }

  void initialize(size_t display) {
    agrees("eglInitialize", eglInitialize(mDisplays[display], nullptr, nullptr), {});
    mModel.initialized[display] = true;
  }
  void terminate(size_t display) {
    agrees("eglTerminate", eglTerminate(mDisplays[display]), {});
    mModel.terminate(display);
  }
  void create(size_t display, bool isContext) {
    const EGLint size[] = {EGL_WIDTH, 2, EGL_HEIGHT, 2, EGL_NONE};
    const size_t config = below(4) == 0;
    Object *share = isContext && below(3) == 0 ? pick(true) : nullptr;
    Errors errors;
    if (!mModel.initialized[display]) {
      errors = {EGL_NOT_INITIALIZED};
    } else if (share && !mModel.valid(share, display, true)) {
      const bool otherDisplay = mModel.valid(share, share->display, true) && share->display != display;
      errors = {otherDisplay ? EGL_BAD_MATCH : EGL_BAD_CONTEXT};
    }
    void *handle = isContext ? eglCreateContext(mDisplays[display], mConfigs[config], handleOf(share), nullptr)
                             : eglCreatePbufferSurface(mDisplays[display], mConfigs[config], size);
    if (agrees("create", handle != nullptr, errors)) mModel.add(handle, display, config, isContext);
  }
  void destroy(size_t display, Object *object, bool isContext) {
    const Errors errors = mModel.errorsOfUse(display, object, isContext);
    const bool done = isContext ? eglDestroyContext(mDisplays[display], handleOf(object))
                                : eglDestroySurface(mDisplays[display], handleOf(object));
    if (agrees("destroy", done, errors)) mModel.destroy(*object);
  }
  void makeCurrent(int thread, size_t display) {
    Object *draw = pick(false), *read = below(4) ? draw : pick(false), *context = pick(true);
    if (below(10) == 0) draw = read = context = nullptr;
    if (context && below(8)) display = context->display;
    const Errors errors = mModel.errorsOfMakeCurrent(thread, display, draw, read, context);
    const bool done = eglMakeCurrent(mDisplays[display], handleOf(draw), handleOf(read), handleOf(context));
    if (agrees("eglMakeCurrent", done, errors)) mModel.makeCurrent(thread, display, draw, read, context);
    mMadeCurrent += done && context;
  }
  void releaseThread(int thread) {
    agrees("eglReleaseThread", eglReleaseThread(), {});
    mModel.makeCurrent(thread, 0, nullptr, nullptr, nullptr);
  }
  void swap(int thread, size_t display) {
    Object *surface = below(3) ? mModel.threads[thread].draw : pick(false);
    if (surface && below(8)) display = surface->display;
    Errors errors = mModel.errorsOfUse(display, surface, false);
    if (errors.empty() && mModel.threads[thread].draw != surface) errors = {EGL_BAD_SURFACE};
    rcClearColor(1, 1, 1, 1);  // something to trace, if there is a context
    mSwaps += agrees("eglSwapBuffers", eglSwapBuffers(mDisplays[display], handleOf(surface)), errors);
  }
  void query(size_t display, Object *object, bool isContext) {
    EGLint value = 0;
    const Errors errors = mModel.errorsOfUse(display, object, isContext);
    const bool done = isContext
                          ? eglQueryContext(mDisplays[display], handleOf(object), EGL_CONTEXT_CLIENT_VERSION, &value)
                          : eglQuerySurface(mDisplays[display], handleOf(object), EGL_WIDTH, &value);
    const EGLint known = isContext ? 1 : 2;
    EXPECT_EQ(value, agrees("query", done, errors) ? known : 0);
  }
  void compareCurrent(const ModelThread &thread) {
    EXPECT_EQ(eglGetCurrentContext(), handleOf(thread.context));
    EXPECT_EQ(eglGetCurrentSurface(EGL_DRAW), handleOf(thread.draw));
    EXPECT_EQ(eglGetCurrentSurface(EGL_READ), handleOf(thread.read));
    EXPECT_EQ(eglGetCurrentDisplay(), thread.display == kNowhere ? EGL_NO_DISPLAY : mDisplays[thread.display]);
    mCalls += 4;
  }

  EGLDisplay mDisplays[Model::kDisplays];
  EGLConfig mConfigs[2];
  Model mModel;
  Worker mWorkers[Model::kThreads];
  std::mt19937 mRandom{GetParam()};
  int mCalls = 0, mMadeCurrent = 0, mSwaps = 0;
};

TEST_P(Walk, AgreesWithTheModel) {
  constexpr int kSteps = 25000;  // of five calls or more
  for (int i = 0; i < kSteps && !HasFailure(); ++i) {
    step();
    if (HasFailure()) ADD_FAILURE() << "at step " << i;
  }
  EXPECT_GE(mCalls, 100000);
  EXPECT_GT(mMadeCurrent, 200) << "a walk that never gets anywhere shows nothing";
  EXPECT_GT(mSwaps, 200);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Walk, testing::Values(1u, 2u));

}  // namespace
}  // namespace rc::test
