// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// parallel.h: work on several threads. The only code that knows oneTBB is parallel.cpp.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace rc {

// A set of threads of our own. Other users of oneTBB in the process share its limit on threads.
class Workers {
 public:
  // threads: 1 or more; 0 = as many as the machine has.
  explicit Workers(int threads);
  ~Workers();
  Workers(const Workers &) = delete;
  Workers &operator=(const Workers &) = delete;

  int threads() const;
  // Calls body(i, worker) for each i in [0, count), worker in [0, threads()): no two calls that run at the
  // same time have the same worker. Returns when all are done; an exception of a body is thrown here.
  void forEach(size_t count, const std::function<void(size_t i, int worker)> &body) const;
  // Runs body inside this set of threads; both() inside it is then spread over them.
  void run(const std::function<void()> &body) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> mImpl;
};

// Calls both, possibly at the same time, and returns when both are done.
void both(const std::function<void()> &first, const std::function<void()> &second);

}  // namespace rc
