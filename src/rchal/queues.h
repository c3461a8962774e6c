// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// queues.h: every work item that travels between the units, as structures of arrays. [G 1.2]
// A queue keeps its memory when it is emptied: after the first tiles of a frame nothing is allocated.
#pragma once

#include <cstdint>
#include <vector>

#include "rchal/device.h"

namespace rc::hal {

// A column of vectors: three columns of floats, so that lanes can be loaded without shuffling.
struct Vec3Column {
  std::vector<float> x, y, z;

  void push(const Vec3 &value) {
    x.push_back(value.x);
    y.push_back(value.y);
    z.push_back(value.z);
  }
  Vec3 operator[](size_t i) const { return {x[i], y[i], z[i]}; }
  void resize(size_t size) {
    x.resize(size);
    y.resize(size);
    z.resize(size);
  }
};

// A ray on its way to the traversal unit, and what its result counts for.
struct RayItem {
  Ray ray;
  HitOrder after;          // hits up to here are done: they were not, or not wholly, there
  bool afterSeen = false;  // something of the last one was
  Rgb weight{1};           // share of the pixel's colour
  float coneWidth = 0;     // diameter of the footprint at the origin, world units
  float coneSpread = 0;    // growth of it for each unit of distance; below 0 it narrows to a focus
  float travelled = 0;     // way from the eye to the origin
  uint32_t pixel = 0;      // within the tile
  uint8_t bounces = 0;     // reflections and refractions so far
};

struct RayQueue {
  Vec3Column origin, direction, weight;
  std::vector<HitOrder> after;
  std::vector<uint8_t> afterSeen;
  std::vector<float> coneWidth, coneSpread, travelled;
  std::vector<uint32_t> pixel;
  std::vector<uint8_t> bounces;

  size_t size() const { return pixel.size(); }
  void push(const RayItem &item) {
    origin.push(item.ray.origin);
    direction.push(item.ray.direction);
    after.push_back(item.after);
    afterSeen.push_back(item.afterSeen);
    weight.push(item.weight);
    coneWidth.push_back(item.coneWidth);
    coneSpread.push_back(item.coneSpread);
    travelled.push_back(item.travelled);
    pixel.push_back(item.pixel);
    bounces.push_back(item.bounces);
  }
  RayItem operator[](size_t i) const {
    return {.ray = {origin[i], direction[i]},
            .after = after[i],
            .afterSeen = afterSeen[i] != 0,
            .weight = weight[i],
            .coneWidth = coneWidth[i],
            .coneSpread = coneSpread[i],
            .travelled = travelled[i],
            .pixel = pixel[i],
            .bounces = bounces[i]};
  }
  Ray ray(size_t i) const { return {origin[i], direction[i]}; }
  // Keeps the first `size` items.
  void truncate(size_t size) {
    origin.resize(size);
    direction.resize(size);
    after.resize(size);
    afterSeen.resize(size);
    weight.resize(size);
    coneWidth.resize(size);
    coneSpread.resize(size);
    travelled.resize(size);
    pixel.resize(size);
    bounces.resize(size);
  }
};

using HitQueue = std::vector<Hit>;

// A question to the traversal unit: how much of `colour` gets through from the light to the point?
struct ShadowItem {
  Ray ray;             // from the surface; the direction has unit length
  float distance = 0;  // to the light; infinite for a directional one
  Rgb colour{0};       // what the light adds if nothing is in the way
  uint32_t pixel = 0;
};

struct ShadowQueue {
  Vec3Column origin, direction, colour;
  std::vector<float> distance;
  std::vector<uint32_t> pixel;

  size_t size() const { return pixel.size(); }
  void push(const ShadowItem &item) {
    origin.push(item.ray.origin);
    direction.push(item.ray.direction);
    colour.push(item.colour);
    distance.push_back(item.distance);
    pixel.push_back(item.pixel);
  }
  ShadowItem operator[](size_t i) const { return {{origin[i], direction[i]}, distance[i], colour[i], pixel[i]}; }
  void clear() {
    origin.resize(0);
    direction.resize(0);
    colour.resize(0);
    distance.clear();
    pixel.clear();
  }
};

}  // namespace rc::hal
