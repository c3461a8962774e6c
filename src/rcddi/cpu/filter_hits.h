// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// filter_hits.h: where shadow rays cross triangles that let some light through: a list for each ray, from near to far.
// The kernels note crossings as they come, once or, where a tree has a triangle in several leaves, several times.
// In: crossings from rcddi/cpu/trace.h.  Out: those of a ray in order.  Next: rcddi/cpu/units.h
#pragma once

#include "rchal/column.h"
#include "rchal/device.h"

namespace rc::ddi::cpu {

class FilterHits {
 public:
  static constexpr uint32_t kNone = 0xffffffff, kTooMany = 0xfffffffe;
  static constexpr int kMost = 24;  // of a ray: bounds time and memory

  // For so many rays without crossings.
  void reset(size_t rays) {
    mFirst.assign(rays, kNone);
    mNodes.resize(0);
  }
  // Returns whether the ray may have more.
  bool note(size_t ray, const hal::Hit &hit);

  bool meetsAny(size_t ray) const { return mFirst[ray] != kNone; }
  // The list is not whole: ask the scalar unit.
  bool hasTooMany(size_t ray) const { return mFirst[ray] == kTooMany; }
  // visit(hit), from near to far, until it returns false.
  template <class Visit>
  void forEach(size_t ray, Visit &&visit) const {
    for (uint32_t at = mFirst[ray]; at != kNone && visit(mNodes[at].hit); at = mNodes[at].next) {
    }
  }

 private:
  struct Node {
    hal::Hit hit;
    uint32_t next;
  };

  hal::Column<uint32_t> mFirst;  // by ray: into mNodes
  hal::Column<Node> mNodes;
};

inline bool FilterHits::note(size_t ray, const hal::Hit &hit) {
  if (hasTooMany(ray)) return false;
  const hal::HitOrder order{hit.t, hit.primitive};
  uint32_t *link = &mFirst[ray];
  int length = 0;
  for (; *link != kNone; link = &mNodes[*link].next, ++length) {
    const hal::Hit &other = mNodes[*link].hit;
    if (order < hal::HitOrder{other.t, other.primitive}) break;
    if (other.primitive == hit.primitive) return true;
  }
  for (uint32_t at = *link; at != kNone; at = mNodes[at].next) ++length;
  if (length == kMost) {
    mFirst[ray] = kTooMany;
    return false;
  }
  const Node node{hit, *link};
  *link = static_cast<uint32_t>(mNodes.size());
  mNodes.push_back(node);  // may move what link points into: last
  return true;
}

}  // namespace rc::ddi::cpu
