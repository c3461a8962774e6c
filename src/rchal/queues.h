// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// queues.h: every work item that travels between the units, as structures of arrays. [G 1.2]
// A queue keeps its memory when it is emptied: after the first tiles of a frame nothing is allocated.
#pragma once

#include <cstddef>
#include <cstdint>

#include "rchal/column_block.h"
#include "rchal/device.h"

namespace rc::hal {

// A column of vectors: three columns of floats, so that lanes can be loaded without shuffling.
template <class Floats>
struct Vec3ColumnOf {
  Floats x, y, z;

  void set(size_t i, const Vec3 &value) {
    x[i] = value.x;
    y[i] = value.y;
    z[i] = value.z;
  }
  Vec3 operator[](size_t i) const { return {x[i], y[i], z[i]}; }
};
using Vec3Column = Vec3ColumnOf<Column<float>>;
using FloatsOfQueue = BlockColumn<float>;
using NumbersOfQueue = BlockColumn<uint32_t>;
using VectorsOfQueue = Vec3ColumnOf<FloatsOfQueue>;

// A ray on its way to the traversal unit, and what its result counts for.
struct RayItem {
  Ray ray;
  HitOrder after;          // hits up to here are done: they were not, or not wholly, there
  bool afterSeen = false;  // something of the last one was
  uint32_t layers = 0;     // surfaces on the way that were there in part
  Rgb weight{1};           // share of the pixel's colour
  float coneWidth = 0;     // diameter of the footprint at the origin, world units
  float coneSpread = 0;    // growth of it for each unit of distance; below 0 it narrows to a focus
  float travelled = 0;     // way from the eye to the origin, or from its plane
  float tolerance = 0;     // what all rays that are left out behind its hit may weigh: units/tolerance.h
  uint32_t pixel = 0;      // within the tile
};

// Rays that were reflected and refracted equally often.
class RayQueue : public ColumnBlock<RayQueue> {
 public:
  VectorsOfQueue origin, direction, weight;
  FloatsOfQueue afterT;
  NumbersOfQueue afterPrimitive, afterSeen, layers;
  FloatsOfQueue coneWidth, coneSpread, travelled, tolerance;
  NumbersOfQueue pixel;

  void push(const RayItem &item) {
    const size_t i = add();
    origin.set(i, item.ray.origin);
    direction.set(i, item.ray.direction);
    weight.set(i, item.weight);
    afterT[i] = item.after.t;
    afterPrimitive[i] = item.after.primitive;
    afterSeen[i] = item.afterSeen;
    layers[i] = item.layers;
    coneWidth[i] = item.coneWidth;
    coneSpread[i] = item.coneSpread;
    travelled[i] = item.travelled;
    tolerance[i] = item.tolerance;
    pixel[i] = item.pixel;
  }
  RayItem operator[](size_t i) const {
    return {.ray = ray(i),
            .after = after(i),
            .afterSeen = afterSeen[i] != 0,
            .layers = layers[i],
            .weight = weight[i],
            .coneWidth = coneWidth[i],
            .coneSpread = coneSpread[i],
            .travelled = travelled[i],
            .tolerance = tolerance[i],
            .pixel = pixel[i]};
  }
  Ray ray(size_t i) const { return {origin[i], direction[i]}; }
  HitOrder after(size_t i) const { return {afterT[i], afterPrimitive[i]}; }

  template <class Visit, class... Queues>
  static void forEachColumn(Visit &&visit, Queues &...queues) {
    for (auto column : {&VectorsOfQueue::x, &VectorsOfQueue::y, &VectorsOfQueue::z}) {
      visit(queues.origin.*column...);
      visit(queues.direction.*column...);
      visit(queues.weight.*column...);
    }
    for (auto column :
         {&RayQueue::afterT, &RayQueue::coneWidth, &RayQueue::coneSpread, &RayQueue::travelled, &RayQueue::tolerance}) {
      visit(queues.*column...);
    }
    for (auto column : {&RayQueue::afterPrimitive, &RayQueue::afterSeen, &RayQueue::layers, &RayQueue::pixel}) {
      visit(queues.*column...);
    }
  }
};

// The nearest hit of each ray of a batch.
class HitQueue : public ColumnBlock<HitQueue> {
 public:
  FloatsOfQueue t, u, v;
  NumbersOfQueue primitive;

  void set(size_t i, const Hit &hit) {
    t[i] = hit.t;
    u[i] = hit.u;
    v[i] = hit.v;
    primitive[i] = hit.primitive;
  }
  Hit operator[](size_t i) const { return {t[i], u[i], v[i], primitive[i]}; }

  template <class Visit, class... Queues>
  static void forEachColumn(Visit &&visit, Queues &...queues) {
    visit(queues.t...);
    visit(queues.u...);
    visit(queues.v...);
    visit(queues.primitive...);
  }
};

// A question to the traversal unit: how much of `colour` gets through from the light to the point?
struct ShadowItem {
  Ray ray;        // between them: units/shadow_ray.h
  Rgb colour{0};  // what the light adds if nothing is in the way
  uint32_t pixel = 0;
  uint32_t from = kNoPrimitive;  // the triangle of the point, which cannot be in the way (SurfacePoint::safeOffset)
};

// The questions about one light. origin: not set where devices know that all rays start at the light.
class ShadowQueue : public ColumnBlock<ShadowQueue> {
 public:
  VectorsOfQueue origin, direction, colour;
  NumbersOfQueue pixel, from;

  void push(const ShadowItem &item) {
    const size_t i = add();
    origin.set(i, item.ray.origin);
    direction.set(i, item.ray.direction);
    colour.set(i, item.colour);
    pixel[i] = item.pixel;
    from[i] = item.from;
  }
  ShadowItem operator[](size_t i) const { return {{origin[i], direction[i]}, colour[i], pixel[i], from[i]}; }

  template <class Visit, class... Queues>
  static void forEachColumn(Visit &&visit, Queues &...queues) {
    for (auto column : {&VectorsOfQueue::x, &VectorsOfQueue::y, &VectorsOfQueue::z}) {
      visit(queues.origin.*column...);
      visit(queues.direction.*column...);
      visit(queues.colour.*column...);
    }
    visit(queues.pixel...);
    visit(queues.from...);
  }
};

// What the pixels of a tile have got so far: columns with room for a vector behind their end.
struct PixelSums {
  float *red, *green, *blue;

  void add(size_t pixel, const Rgb &colour) const {
    red[pixel] += colour.x;
    green[pixel] += colour.y;
    blue[pixel] += colour.z;
  }
  Rgb operator[](size_t pixel) const { return {red[pixel], green[pixel], blue[pixel]}; }
};

}  // namespace rc::hal
