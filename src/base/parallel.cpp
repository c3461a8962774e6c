// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "base/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "base/float_mode.h"
#include "base/fork.h"

#ifdef RC_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace rc {
namespace {

// Tells the thread sanitizer what it cannot see in a oneTBB that was built without it: what is done before a task
// is handed out is seen by the task, and what the task does is seen once it is awaited.
class Handover {
 public:
  void give() { release(&mThere); }

  // A task, and the wait for all of them, as scopes: exceptions leave them too.
  class Task {
   public:
    explicit Task(Handover &handover) : mHandover(handover) { acquire(&mHandover.mThere); }
    ~Task() { release(&mHandover.mBack); }
    Task(const Task &) = delete;
    Task &operator=(const Task &) = delete;

   private:
    Handover &mHandover;
  };
  class Wait {
   public:
    explicit Wait(Handover &handover) : mHandover(handover) {}
    ~Wait() { acquire(&mHandover.mBack); }
    Wait(const Wait &) = delete;
    Wait &operator=(const Wait &) = delete;

   private:
    Handover &mHandover;
  };

 private:
#ifdef RC_THREAD_SANITIZER
  static void release(char *sync) { __tsan_release(sync); }
  static void acquire(char *sync) { __tsan_acquire(sync); }
#else
  static void release(char *) {}
  static void acquire(char *) {}
#endif
  char mThere = 0, mBack = 0;
};

// Arenas that nobody uses, by their number of threads. oneTBB does not give back all of an arena's memory, so they are
// used again: there are never more than there were Workers at the same time. Never destroyed, as Workers may outlive
// static objects.
class Arenas {
 public:
  std::unique_ptr<tbb::task_arena> take(int threads) {
    const std::lock_guard lock(mMutex);
    const auto found = std::find_if(mFree.begin(), mFree.end(),
                                    [&](const auto &arena) { return arena->max_concurrency() == threads; });
    if (found == mFree.end()) {
      mFree.reserve(++mAll);
      return std::make_unique<tbb::task_arena>(threads);
    }
    std::unique_ptr<tbb::task_arena> arena = std::move(*found);
    mFree.erase(found);
    return arena;
  }
  void giveBack(std::unique_ptr<tbb::task_arena> arena) noexcept {
    const std::lock_guard lock(mMutex);
    mFree.push_back(std::move(arena));  // there is room: take() has made it
  }

 private:
  ForkMutex mMutex;
  std::vector<std::unique_ptr<tbb::task_arena>> mFree;
  size_t mAll = 0;
};

Arenas &arenas() {
  static auto &arenas = *new Arenas;
  return arenas;
}

}  // namespace

struct Workers::Impl {
  explicit Impl(int threads) : count(threads) {
    noteThreads();
    // More threads than the machine has cores must be allowed, for the whole process. Fewer need no such thing: it
    // would bind the program's own use of oneTBB.
    if (threads > tbb::info::default_concurrency()) {
      allowance.emplace(tbb::global_control::max_allowed_parallelism, size_t(threads));
    }
    arena = arenas().take(threads);
  }
  ~Impl() { arenas().giveBack(std::move(arena)); }

  int count;
  std::optional<tbb::global_control> allowance;
  std::unique_ptr<tbb::task_arena> arena;
};

// In the child of a fork nothing is known about the arena.
Workers::Workers(int threads)
    : mImpl(new Impl(threads > 0 ? threads : tbb::info::default_concurrency()), [](Impl *impl) {
        if (!threadsAreGone()) delete impl;
      }) {}

int Workers::threads() const { return mImpl->count; }

void Workers::forEach(size_t count, const std::function<void(size_t i, int worker)> &body, size_t together) const {
  if (threadsAreGone()) {
    for (size_t i = 0; i < count; ++i) body(i, 0);
    return;
  }
  Handover handover;
  handover.give();
  const Handover::Wait wait(handover);
  const auto spread = [&] {
    tbb::parallel_for(
        tbb::blocked_range<size_t>(0, count, together),
        [&](const tbb::blocked_range<size_t> &range) {
          const Handover::Task task(handover);
          const FloatMode mode;
          const int worker = tbb::this_task_arena::current_thread_index();
          for (size_t i = range.begin(); i != range.end(); ++i) body(i, worker);
        },
        tbb::simple_partitioner());
  };
  // Whoever waits for the last index must not begin a background job meanwhile: that may take long.
  mImpl->arena->execute([&] { tbb::this_task_arena::isolate(spread); });
}

void Workers::run(const std::function<void()> &body) const {
  if (threadsAreGone()) return body();
  Handover handover;
  handover.give();
  const Handover::Wait wait(handover);
  mImpl->arena->execute([&] {
    const Handover::Task task(handover);
    const FloatMode mode;
    body();
  });
}

// The job is done under a lock, so that fork() waits for it. In the child of a fork that came before the job began,
// nobody is left to begin it but the thread that waits.
struct Background::Impl {
  explicit Impl(std::shared_ptr<Workers::Impl> threads) : workers(std::move(threads)) {}

  void perform() {
    mutex.lockInside();
    const std::lock_guard lock(mutex, std::adopt_lock);
    const auto mine = std::exchange(job, nullptr);
    if (!mine) return;
    const FloatMode mode;
    mine();
  }

  std::shared_ptr<Workers::Impl> workers;
  ForkMutex mutex;
  std::function<void()> job;
  tbb::task_group group;
  Handover handover;
  bool begun = false;
};

Background::Background(const Workers &workers) : mImpl(std::make_unique<Impl>(workers.mImpl)) {}

Background::~Background() {
  try {
    wait();
  } catch (...) {  // told to nobody: there is nobody left
  }
  if (threadsAreGone()) static_cast<void>(mImpl.release());
}

// The program may have told oneTBB to use no threads.
bool Background::possible() const {
  using Control = tbb::global_control;
  return !threadsAreGone() && mImpl->workers->count > 1 && Control::active_value(Control::max_allowed_parallelism) > 1;
}

void Background::begin(std::function<void()> job) {
  Impl &impl = *mImpl;
  impl.job = std::move(job);
  impl.handover.give();
  impl.workers->arena->execute([&] {
    impl.group.run([&] {
      const Handover::Task task(impl.handover);
      impl.perform();
    });
  });
  impl.begun = true;
}

void Background::wait() {
  Impl &impl = *mImpl;
  if (!std::exchange(impl.begun, false)) return;
  if (threadsAreGone()) return impl.perform();
  const Handover::Wait wait(impl.handover);
  impl.workers->arena->execute([&] { impl.group.wait(); });
}

void both(const std::function<void()> &first, const std::function<void()> &second) {
  if (threadsAreGone()) {
    first();
    return second();
  }
  Handover handover;
  handover.give();
  const Handover::Wait wait(handover);
  const auto handedOver = [&](const std::function<void()> &work) {
    const Handover::Task task(handover);
    const FloatMode mode;
    work();
  };
  tbb::parallel_invoke([&] { handedOver(first); }, [&] { handedOver(second); });
}

}  // namespace rc
