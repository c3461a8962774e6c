// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "base/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>

namespace rc {

struct Workers::Impl {
  explicit Impl(int threads)
      : allowance(tbb::global_control::max_allowed_parallelism, size_t(threads)), arena(threads) {}

  tbb::global_control allowance;  // lets an arena have more threads than the machine has cores
  tbb::task_arena arena;
};

Workers::Workers(int threads)
    : mImpl(std::make_unique<Impl>(threads > 0 ? threads : tbb::info::default_concurrency())) {}

Workers::~Workers() = default;

int Workers::threads() const { return mImpl->arena.max_concurrency(); }

void Workers::forEach(size_t count, const std::function<void(size_t i, int worker)> &body) const {
  // One index a task: tiles differ in cost, and stealing single ones keeps all threads busy to the end.
  mImpl->arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<size_t>(0, count, 1),
        [&](const tbb::blocked_range<size_t> &range) {
          const int worker = tbb::this_task_arena::current_thread_index();
          for (size_t i = range.begin(); i != range.end(); ++i) body(i, worker);
        },
        tbb::simple_partitioner());
  });
}

void Workers::run(const std::function<void()> &body) const { mImpl->arena.execute(body); }

void both(const std::function<void()> &first, const std::function<void()> &second) {
  tbb::parallel_invoke(first, second);
}

}  // namespace rc
