// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// parallel.h: work on several threads. The only code that knows oneTBB is parallel.cpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>

namespace rc {

// A set of threads of our own; copies are the same set. Other users of oneTBB in the process share its limit on
// threads.
class Workers {
 public:
  // threads: 1 or more; 0 = as many as the machine has.
  explicit Workers(int threads);

  int threads() const;
  // Calls body(i, worker) for each i in [0, count), worker in [0, threads()): no two calls that run at the
  // same time have the same worker. Returns when all are done; an exception of a body is thrown here.
  // together: so many that follow each other, at most, are handed to a thread at once.
  void forEach(size_t count, const std::function<void(size_t i, int worker)> &body, size_t together = 1) const;
  // Runs body inside this set of threads; both() inside it is then spread over them.
  void run(const std::function<void()> &body) const;

 private:
  friend class Background;
  struct Impl;
  std::shared_ptr<Impl> mImpl;
};

// Calls body(share, begin, end) for each share of [0, count), which has `size` items; the last one may have fewer.
template <class Body>
void forEachShare(const Workers &workers, size_t count, size_t size, Body &&body) {
  workers.forEach((count + size - 1) / size,
                  [&](size_t share, int) { body(share, share * size, std::min(count, (share + 1) * size)); });
}

// A job that is done beside what the caller goes on with, by a set of threads.
class Background {
 public:
  explicit Background(const Workers &workers);
  ~Background();  // waits; what the job threw is lost
  Background(const Background &) = delete;
  Background &operator=(const Background &) = delete;

  // Whether there is a thread for it: otherwise it would not begin before wait().
  bool possible() const;
  // None may be on its way.
  void begin(std::function<void()> job);
  // Helps with it until it is done; an exception of the job is thrown here. Does nothing where there is none.
  void wait();

 private:
  struct Impl;
  std::unique_ptr<Impl> mImpl;
};

// Calls both, possibly at the same time, and returns when both are done.
void both(const std::function<void()> &first, const std::function<void()> &second);

}  // namespace rc
