// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// device.h: the only door between the driver and what traces rays. A device is a sibling folder in
// rcddi/ and is found by name through createDevice (rcddi/registry.cpp).
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "base/parallel.h"
#include "rchal/scene_view.h"

namespace rc::hal {

// The picture to write: RGBA8, R in the low byte, the top row first.
struct Target {
  uint32_t *pixels = nullptr;
  int width = 0, height = 0;
  bool rgb565 = false;  // colours are rounded to 5, 6 and 5 bits
};

// Seconds of all workers together, by unit; only where the frame is to be measured.
struct UnitTimes {
  double generate = 0, primary = 0, secondary = 0, shade = 0, shadow = 0, store = 0;

  double all() const { return generate + primary + secondary + shade + shadow + store; }
  UnitTimes &operator+=(const UnitTimes &other) {
    generate += other.generate;
    primary += other.primary;
    secondary += other.secondary;
    shade += other.shade;
    shadow += other.shadow;
    store += other.store;
    return *this;
  }
};

// Rays of one frame, by kind, and where the time went.
struct RayCounts {
  uint64_t primary = 0, shadow = 0, reflected = 0, refracted = 0, straight = 0;
  uint64_t primaryHits = 0;  // primary rays that met something
  UnitTimes times;

  uint64_t all() const { return primary + shadow + reflected + refracted + straight; }
  RayCounts &operator+=(const RayCounts &other) {
    primary += other.primary;
    shadow += other.shadow;
    reflected += other.reflected;
    refracted += other.refracted;
    straight += other.straight;
    primaryHits += other.primaryHits;
    times += other.times;
    return *this;
  }
};

struct Ray {
  Vec3 origin;
  Vec3 direction;  // unit length where distances matter
};

inline constexpr uint32_t kNoPrimitive = 0xffffffff;

// Where a ray meets a triangle; 16 bytes.
struct Hit {
  float t = kInfinity;                // distance in lengths of the direction
  float u = 0, v = 0;                 // weights of the second and third vertex
  uint32_t primitive = kNoPrimitive;  // through both sets: static ones first

  bool found() const { return primitive != kNoPrimitive; }
};
static_assert(sizeof(Hit) == 16);

// A place in the order of hits along a ray.
struct HitOrder {
  float t = 0;
  uint32_t primitive = kNoPrimitive;  // the default lies before every hit at t > 0

  bool operator<(const HitOrder &other) const { return t < other.t || (t == other.t && primitive < other.primitive); }
};

class Device {
 public:
  virtual ~Device() = default;

  virtual std::string_view name() const = 0;
  // Traces the whole frame into the target. Pixels outside the viewport get the clear colour.
  virtual RayCounts trace(const SceneView &scene, const Target &target) = 0;
  // The nearest hit of each ray at a distance above 0; ties go to the lower primitive number.
  virtual void intersect(const SceneView &scene, std::span<const Ray> rays, std::span<Hit> hits) = 0;
};

// "cpu", "ref" or "null"; null pointer for other names. A device that traces on processors uses these threads.
std::unique_ptr<Device> createDevice(std::string_view name, const Workers &workers);
// threads: 0 = as many as the machine has.
inline std::unique_ptr<Device> createDevice(std::string_view name, int threads) {
  return createDevice(name, Workers(threads));
}

}  // namespace rc::hal
