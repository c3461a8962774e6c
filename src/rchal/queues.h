// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// queues.h: every work item that travels between the units, as structures of arrays. [G 1.2]
// A queue keeps its memory when it is emptied: after the first tiles of a frame nothing is allocated.
#pragma once

#include <cstddef>
#include <cstdint>

#include "rchal/column.h"
#include "rchal/device.h"

namespace rc::hal {

// A column of vectors: three columns of floats, so that lanes can be loaded without shuffling.
struct Vec3Column {
  Column<float> x, y, z;

  void push(const Vec3 &value) {
    x.push_back(value.x);
    y.push_back(value.y);
    z.push_back(value.z);
  }
  Vec3 operator[](size_t i) const { return {x[i], y[i], z[i]}; }
};

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
  float tolerance = 0;     // rays from its hit may be left out if they count for less
  uint32_t pixel = 0;      // within the tile
};

// Rays that were reflected and refracted equally often.
struct RayQueue {
  Vec3Column origin, direction, weight;
  Column<float> afterT;
  Column<uint32_t> afterPrimitive, afterSeen, layers;
  Column<float> coneWidth, coneSpread, travelled, tolerance;
  Column<uint32_t> pixel;

  size_t size() const { return pixel.size(); }
  void push(const RayItem &item) {
    origin.push(item.ray.origin);
    direction.push(item.ray.direction);
    weight.push(item.weight);
    afterT.push_back(item.after.t);
    afterPrimitive.push_back(item.after.primitive);
    afterSeen.push_back(item.afterSeen);
    layers.push_back(item.layers);
    coneWidth.push_back(item.coneWidth);
    coneSpread.push_back(item.coneSpread);
    travelled.push_back(item.travelled);
    tolerance.push_back(item.tolerance);
    pixel.push_back(item.pixel);
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

  void reserve(size_t count) {
    forEachColumn([&](auto &column) { column.reserve(count); }, *this);
  }
  void resize(size_t size) {
    forEachColumn([&](auto &column) { column.resize(size); }, *this);
  }
  // Moves the last `count` items to `taken`, in their order; what that held is dropped.
  void takeLast(size_t count, RayQueue &taken) {
    forEachColumn([&](auto &from, auto &to) { to.takeLast(count, from); }, *this, taken);
  }

 private:
  template <class Visit, class... Queues>
  static void forEachColumn(Visit &&visit, Queues &...queues) {
    for (auto column : {&Vec3Column::x, &Vec3Column::y, &Vec3Column::z}) {
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

using HitQueue = Column<Hit>;

// A question to the traversal unit: how much of `colour` gets through from the light to the point?
struct ShadowItem {
  Ray ray;             // from the surface; the direction has unit length
  float distance = 0;  // to the light; infinite for a directional one
  Rgb colour{0};       // what the light adds if nothing is in the way
  uint32_t pixel = 0;
  uint32_t from = kNoPrimitive;  // the triangle it starts on, which cannot be in the way (SurfacePoint::start)
};

// The questions about one light.
struct ShadowQueue {
  Vec3Column origin, direction, colour;
  Column<float> distance;
  Column<uint32_t> pixel, from;

  size_t size() const { return pixel.size(); }
  void push(const ShadowItem &item) {
    origin.push(item.ray.origin);
    direction.push(item.ray.direction);
    colour.push(item.colour);
    distance.push_back(item.distance);
    pixel.push_back(item.pixel);
    from.push_back(item.from);
  }
  ShadowItem operator[](size_t i) const {
    return {{origin[i], direction[i]}, distance[i], colour[i], pixel[i], from[i]};
  }
  void reserve(size_t count) {
    forEachColumn([&](auto &column) { column.reserve(count); });
  }
  void resize(size_t size) {
    forEachColumn([&](auto &column) { column.resize(size); });
  }

 private:
  template <class Visit>
  void forEachColumn(Visit &&visit) {
    for (auto column : {&Vec3Column::x, &Vec3Column::y, &Vec3Column::z}) {
      visit(origin.*column);
      visit(direction.*column);
      visit(colour.*column);
    }
    visit(distance);
    visit(pixel);
    visit(from);
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
