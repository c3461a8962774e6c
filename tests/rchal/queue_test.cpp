// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Queues: columns of one block that grow, are emptied and change hands together.
#include <gtest/gtest.h>

#include "rchal/queues.h"

namespace rc::test {
namespace {

using namespace rc::hal;

RayItem item(size_t i) {
  const auto number = static_cast<float>(i);
  RayItem ray;
  ray.ray = {{number, number + 0.25f, number + 0.5f}, {1, number, -1}};
  ray.after = {number / 2, static_cast<uint32_t>(7 * i)};
  ray.afterSeen = i % 2;
  ray.layers = static_cast<uint32_t>(i % 3);
  ray.weight = {0.5f, number, 1};
  ray.coneWidth = number + 1;
  ray.coneSpread = -number;
  ray.travelled = 3 * number;
  ray.tolerance = number / 4;
  ray.pixel = static_cast<uint32_t>(i);
  return ray;
}

void expectItem(const RayQueue &queue, size_t place, size_t i) {
  const RayItem found = queue[place], truth = item(i);
  EXPECT_EQ(found.ray.origin, truth.ray.origin);
  EXPECT_EQ(found.ray.direction, truth.ray.direction);
  EXPECT_EQ(found.after.t, truth.after.t);
  EXPECT_EQ(found.after.primitive, truth.after.primitive);
  EXPECT_EQ(found.afterSeen, truth.afterSeen);
  EXPECT_EQ(found.layers, truth.layers);
  EXPECT_EQ(found.weight, truth.weight);
  EXPECT_EQ(found.coneWidth, truth.coneWidth);
  EXPECT_EQ(found.coneSpread, truth.coneSpread);
  EXPECT_EQ(found.travelled, truth.travelled);
  EXPECT_EQ(found.tolerance, truth.tolerance);
  EXPECT_EQ(found.pixel, truth.pixel);
}

RayQueue queueOf(size_t count) {
  RayQueue queue;
  for (size_t i = 0; i < count; ++i) queue.push(item(i));
  return queue;
}

TEST(Queue, KeepsItsItemsWhenItGrows) {
  const RayQueue queue = queueOf(1000);
  ASSERT_EQ(queue.size(), 1000u);
  for (size_t i = 0; i < queue.size(); ++i) expectItem(queue, i, i);
}

TEST(Queue, ColumnsHaveRoomForAVectorBehindTheirEnd) {
  ShadowQueue queue;
  queue.resize(16);
  const float *columns[] = {queue.origin.x.data(), queue.origin.y.data(), queue.direction.z.data(),
                            queue.colour.y.data()};
  for (const float *column : columns) {
    EXPECT_EQ(reinterpret_cast<uintptr_t>(column) % 64, 0u);
    for (const float *other : columns) EXPECT_TRUE(column == other || std::abs(column - other) >= 32);
    for (size_t i = 16; i < 32; ++i) EXPECT_EQ(column[i], 0) << "computed with: denormal numbers would be slow";
  }
}

TEST(Queue, GivesItsLastItemsAway) {
  RayQueue queue = queueOf(300), taken = queueOf(5);
  queue.takeLast(256, taken);
  ASSERT_EQ(taken.size(), 256u);
  ASSERT_EQ(queue.size(), 44u);
  for (size_t i = 0; i < taken.size(); ++i) expectItem(taken, i, i + 44);
  queue.takeLast(44, taken);
  EXPECT_EQ(queue.size(), 0u);
  ASSERT_EQ(taken.size(), 44u);
  for (size_t i = 0; i < taken.size(); ++i) expectItem(taken, i, i);
  queue.push(item(9));
  expectItem(queue, 0, 9);
  expectItem(taken, 0, 0);
}

TEST(Queue, WhatWasMovedFromIsEmptyAndCanBeFilledAgain) {
  RayQueue first = queueOf(20);
  RayQueue second = std::move(first);
  ASSERT_EQ(second.size(), 20u);
  EXPECT_EQ(first.size(), 0u);  // NOLINT(bugprone-use-after-move): that is what is asked
  first.push(item(3));
  expectItem(first, 0, 3);
  for (size_t i = 0; i < second.size(); ++i) expectItem(second, i, i);
}

}  // namespace
}  // namespace rc::test
