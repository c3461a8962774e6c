// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "base/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>

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
  void take() { acquire(&mThere); }
  void finish() { release(&mBack); }
  void await() { acquire(&mBack); }

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

}  // namespace

struct Workers::Impl {
  explicit Impl(int threads)
      : allowance(tbb::global_control::max_allowed_parallelism, size_t(threads)), arena(threads) {}

  // Lets the arena have more threads than the machine has cores. It holds for the whole process.
  tbb::global_control allowance;
  tbb::task_arena arena;
};

Workers::Workers(int threads)
    : mImpl(std::make_unique<Impl>(threads > 0 ? threads : tbb::info::default_concurrency())) {}

Workers::~Workers() = default;

int Workers::threads() const { return mImpl->arena.max_concurrency(); }

void Workers::forEach(size_t count, const std::function<void(size_t i, int worker)> &body) const {
  Handover handover;
  handover.give();
  // One index a task: tiles differ in cost, and stealing single ones keeps all threads busy to the end.
  mImpl->arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<size_t>(0, count, 1),
        [&](const tbb::blocked_range<size_t> &range) {
          handover.take();
          const int worker = tbb::this_task_arena::current_thread_index();
          for (size_t i = range.begin(); i != range.end(); ++i) body(i, worker);
          handover.finish();
        },
        tbb::simple_partitioner());
  });
  handover.await();
}

void Workers::run(const std::function<void()> &body) const {
  Handover handover;
  handover.give();
  mImpl->arena.execute([&] {
    handover.take();
    body();
    handover.finish();
  });
  handover.await();
}

void both(const std::function<void()> &first, const std::function<void()> &second) {
  Handover handover;
  handover.give();
  const auto handedOver = [&](const std::function<void()> &task) {
    handover.take();
    task();
    handover.finish();
  };
  tbb::parallel_invoke([&] { handedOver(first); }, [&] { handedOver(second); });
  handover.await();
}

}  // namespace rc
