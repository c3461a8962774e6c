// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// tracer.h: what a tracer has to offer to be measured beside the others: build, rebuild, trace.
#pragma once

#include <algorithm>
#include <memory>
#include <string>

#include "peers/rays.h"

namespace rc::bench {

class Tracer {
 public:
  virtual ~Tracer() = default;

  virtual std::string name() const = 0;
  // Rays [begin, end), at most 1024, multiples of 16, on the calling thread. Shadow rays: primitive is 0 where
  // something is in the way and kMiss where not.
  virtual void trace(Kind kind, const RayBatch &rays, size_t begin, size_t end, FirstHit *hits) const = 0;
};

// A way to build, measured with its buffers in place: what a frame with moving geometry pays.
class Builder {
 public:
  virtual ~Builder() = default;

  virtual std::string name() const = 0;
  // Of "build", as good as it gets; "rebuild", for one frame; "refit", the same tree for moved triangles.
  virtual std::string task() const = 0;
  // Builds from the vertices, which lie where the builder was told at first and may have moved.
  virtual void build() = 0;
};

using Tracers = std::vector<std::unique_ptr<Tracer>>;
using Builders = std::vector<std::unique_ptr<Builder>>;

// Whether a name contains one of the parts, or is one behind a "=", or there are none.
inline bool isWanted(const std::string &name, const std::vector<std::string> &parts) {
  return parts.empty() || std::any_of(parts.begin(), parts.end(), [&](const std::string &part) {
           return name.find(part) != std::string::npos || "=" + name == part;
         });
}

// All that a peer offers for a scene, of which are wanted; the soup must outlive them.
void addRaycore(const Soup &soup, int threads, const std::vector<std::string> &who, Tracers &tracers);
void addRaycoreBuilders(const Soup &soup, int threads, Builders &builders);
#ifdef RAYCORE_EMBREE
void addEmbree(const Soup &soup, int threads, const std::vector<std::string> &who, Tracers &tracers);
void addEmbreeBuilders(const Soup &soup, int threads, Builders &builders);
#endif

}  // namespace rc::bench
