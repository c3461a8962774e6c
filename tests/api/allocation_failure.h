// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// allocation_failure.h: operator new that fails when a test says so, to see what RC_OUT_OF_MEMORY leaves behind; and
// that counts, to see what is never given back.
#pragma once

namespace rc::test {

// After `good` more allocations of this thread one throws std::bad_alloc.
void failAllocationAfter(int good);

// How long memory is short: for one allocation, or until the test asks allocationFailed().
enum class Shortage { Once, Lasting };
// The same for all threads together.
void failAnyAllocationAfter(int good, Shortage shortage);

// Whether the failure came; it no longer will.
bool allocationFailed();

// Allocations that were not freed yet, of all threads.
long liveAllocations();

// For the arguments of a call: the first allocation after them fails.
template <class Value>
Value starved(Value value) {
  failAllocationAfter(0);
  return value;
}

}  // namespace rc::test
