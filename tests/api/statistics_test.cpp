// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// What frames cost and what single rays meet. [RC_RCX_frame_statistics, RC_RCX_ray_queries, RC_RCX_structure_hint]
#include "api/context_fixture.h"
#include "rcddk/accel/shape.h"

namespace rc::test {
namespace {

constexpr RCenum kKinds[] = {RC_FRAME_RAYS_PRIMARY, RC_FRAME_RAYS_SHADOW, RC_FRAME_RAYS_REFLECTED,
                             RC_FRAME_RAYS_REFRACTED, RC_FRAME_RAYS_STRAIGHT};
constexpr RCenum kStructures[] = {RC_STRUCTURE_KD_TREE, RC_STRUCTURE_BVH, RC_STRUCTURE_NONE};

class StatisticsTest : public ContextTest {
 protected:
  // A row of unit quads from x = 0, one behind the other's left end, at growing depth.
  void drawSteps(int count) {
    for (int i = 0; i < count; ++i) {
      const auto at = static_cast<float>(i % kWidth);
      drawQuad({at, 0, at + 1, 8}, -0.01f * static_cast<float>(i / kWidth));
    }
  }
  std::vector<RCfloat> ask(RCenum pname, int x = 0, int y = 0, int width = kWidth, int height = kHeight) {
    std::vector<RCfloat> values(size_t(width) * size_t(height), -77);
    rcReadRaysRCX(x, y, width, height, pname, values.data());
    EXPECT_CLEAN();
    return values;
  }
  RCfloat askOne(RCenum pname, int x, int y) { return ask(pname, x, y, 1, 1)[0]; }
  RCuint makeMaterial(float red) {
    RCuint name = 0;
    rcGenMaterials(1, &name);
    rcBindMaterial(name);
    paint(red, 0, 0);
    return name;
  }
};

TEST_F(StatisticsTest, KindsOfRaysSumUp) {
  pixelCamera();
  paintDiffuse(1, 1, 1);
  lightFrom(5, 5, 10, 1, 1);
  const float half[] = {0.5f, 0.5f, 0.5f};
  rcMaterialfv(RC_FRONT_AND_BACK, RC_REFLECTION, half);
  drawQuad({0, 0, 10, 10});
  rcFinish();
  int sum = 0;
  for (const RCenum kind : kKinds) sum += integer(kind);
  EXPECT_EQ(sum, integer(RC_FRAME_RAYS));
  EXPECT_EQ(integer(RC_FRAME_RAYS_PRIMARY), kWidth * kHeight);
  EXPECT_NEAR(integer(RC_FRAME_RAYS_REFLECTED), 100, 21);
  EXPECT_NEAR(integer(RC_FRAME_RAYS_SHADOW), 100, 21) << "one light";
  EXPECT_EQ(integer(RC_FRAME_RAYS_REFRACTED), 0);
  EXPECT_GE(floats(RC_FRAME_TRACE_TIME, 1)[0], 0);
  EXPECT_GE(floats(RC_FRAME_BUILD_TIME, 1)[0], 0);
}

TEST_F(StatisticsTest, UnitsAreMeasuredOnceSomebodyHasAsked) {
  constexpr RCenum kUnits[] = {RC_FRAME_PRIMARY_TIME, RC_FRAME_SECONDARY_TIME, RC_FRAME_SHADOW_TIME,
                               RC_FRAME_SHADE_TIME, RC_FRAME_STORE_TIME};
  pixelCamera();
  lightFrom(5, 5, 10, 1, 1);
  drawQuad({0, 0, 10, 10});
  EXPECT_EQ(floats(RC_FRAME_TRANSFORM_TIME, 1)[0], 0) << "there was no frame";
  rcFinish();
  EXPECT_GT(floats(RC_FRAME_TRANSFORM_TIME, 1)[0], 0);
  for (const RCenum unit : kUnits) EXPECT_EQ(floats(unit, 1)[0], 0) << "nobody had asked";
  rcClearColor(0, 0, 1, 1);
  rcFinish();
  EXPECT_GT(floats(RC_FRAME_PRIMARY_TIME, 1)[0], 0);
  EXPECT_EQ(floats(RC_FRAME_SECONDARY_TIME, 1)[0], 0) << "no mirror";
  EXPECT_GT(floats(RC_FRAME_SHADOW_TIME, 1)[0], 0);
  EXPECT_GT(floats(RC_FRAME_SHADE_TIME, 1)[0], 0);
  EXPECT_GT(floats(RC_FRAME_STORE_TIME, 1)[0], 0);
}

TEST_F(StatisticsTest, StructuresAreDescribed) {
  pixelCamera();
  for (const RCenum name : {RC_STRUCTURE_NODES, RC_STRUCTURE_LEAVES, RC_STRUCTURE_DEPTH, RC_STRUCTURE_COST,
                            RC_MEMORY_STRUCTURE, RC_MEMORY_TRIANGLES}) {
    EXPECT_EQ(integer(RCenum(name)), 0) << "nothing is there";
  }
  for (const RCenum kind : kStructures) {
    rcHint(RC_STRUCTURE_HINT, kind);
    EXPECT_EQ(RCenum(integer(RC_STRUCTURE_HINT)), kind);
    rcStaticSceneBegin();
    drawSteps(300);
    rcStaticSceneEnd();
    const bool tree = kind != RC_STRUCTURE_NONE;
    EXPECT_EQ(integer(RC_STRUCTURE_NODES) > 20, tree);
    EXPECT_EQ(integer(RC_STRUCTURE_LEAVES) > integer(RC_STRUCTURE_NODES), tree);
    EXPECT_EQ(integer(RC_STRUCTURE_DEPTH) >= 4, tree);
    EXPECT_LE(integer(RC_STRUCTURE_DEPTH), 64);
    EXPECT_EQ(floats(RC_STRUCTURE_COST, 1)[0] > 2, tree);
    EXPECT_EQ(integer(RC_MEMORY_STRUCTURE) > 2000, tree);
    EXPECT_GE(integer(RC_MEMORY_TRIANGLES), 600 * 144);
    EXPECT_GE(floats(RC_STATIC_BUILD_TIME, 1)[0], 0);
  }
  rcHint(RC_STRUCTURE_HINT, RC_DONT_CARE);
}

TEST_F(StatisticsTest, TheHintCountsForWhatMovesToo) {
  pixelCamera();
  drawSteps(100);
  rcFinish();
  EXPECT_EQ(context->scene.dynamicAccel().kind, AccelKind::Bvh) << "the default";
  rcHint(RC_STRUCTURE_HINT, RC_STRUCTURE_KD_TREE);
  drawSteps(100);  // as many: a BVH would be fitted to them
  rcFinish();
  EXPECT_EQ(context->scene.dynamicAccel().kind, AccelKind::KdTree);
  EXPECT_RAISES(RC_INVALID_ENUM, rcHint(RC_STRUCTURE_HINT, RC_NICEST));
  EXPECT_RAISES(RC_INVALID_ENUM, rcHint(RC_STRUCTURE_HINT, RC_STRUCTURE_NONE + 1));
  EXPECT_RAISES(RC_INVALID_ENUM, rcHint(RC_MIPMAP_HINT, RC_STRUCTURE_BVH));
}

TEST_F(StatisticsTest, TexturesHaveMemory) {
  const int before = integer(RC_MEMORY_TEXTURES);
  const std::vector<RCubyte> texels(32 * 16 * 4, 9);
  rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGBA, 32, 16, 0, RC_RGBA, RC_UNSIGNED_BYTE, texels.data());
  const int bytes = integer(RC_MEMORY_TEXTURES) - before;
  EXPECT_GE(bytes, 32 * 16 * 4);
  EXPECT_LE(bytes, 32 * 16 * 4 * 3 / 2) << "with mip levels";
}

TEST_F(StatisticsTest, RaysTellDistanceAndMaterial) {
  pixelCamera();
  const RCuint near = makeMaterial(1), far = makeMaterial(0.5f);
  drawQuad({10, 0, 40, 20}, -1);
  const RCfloat distance = askOne(RC_RAY_DISTANCE, 12, 10);
  EXPECT_GT(distance, 0);
  drawQuad({10, 0, 40, 20}, -1);  // a frame was traced: everything is drawn anew
  rcBindMaterial(near);
  drawQuad({0, 0, 20, 20});
  rcBindMaterial(0);
  drawQuad({50, 0, 60, 20});
  EXPECT_EQ(askOne(RC_RAY_MATERIAL, 12, 10), RCfloat(near)) << "it hides the other one";
  EXPECT_EQ(askOne(RC_RAY_MATERIAL, 30, 10), RCfloat(far));
  EXPECT_EQ(askOne(RC_RAY_MATERIAL, 55, 10), 0) << "drawn without a material object";
  EXPECT_EQ(askOne(RC_RAY_MATERIAL, 45, 10), -1);
  EXPECT_EQ(askOne(RC_RAY_DISTANCE, 45, 10), -1);
  EXPECT_LT(askOne(RC_RAY_DISTANCE, 12, 10), distance);
}

TEST_F(StatisticsTest, WhatIsNotThereIsPassed) {
  pixelCamera();
  const RCuint behind = makeMaterial(1);
  drawQuad({0, 0, 20, 20}, -1);
  makeMaterial(0.5f);
  rcEnable(RC_CULL_FACE);
  drawClockwiseQuad({0, 0, 20, 20});
  EXPECT_EQ(askOne(RC_RAY_MATERIAL, 5, 5), RCfloat(behind));
}

// However much of it: each search goes on where the last one ended.
TEST_F(StatisticsTest, ManyLayersThatAreNotThereArePassed) {
  pixelCamera();
  constexpr int kLayers = 400;
  const RCuint behind = makeMaterial(1);
  drawQuad({0, 0, 20, 20}, -1);
  makeMaterial(0.5f);
  rcEnable(RC_CULL_FACE);
  for (int i = 0; i < kLayers; ++i) drawClockwiseQuad({0, 0, 20, 20}, 0.1f * float(i));
  EXPECT_EQ(askOne(RC_RAY_MATERIAL, 5, 6), RCfloat(behind));
  EXPECT_LT(askOne(RC_RAY_TRIANGLES, 5, 6), 60 * kLayers);
}

TEST_F(StatisticsTest, EveryStructureGivesTheSameAnswersAtItsOwnCost) {
  pixelCamera();
  std::vector<std::vector<RCfloat>> distances;
  std::vector<RCfloat> most;
  for (const RCenum kind : kStructures) {
    rcHint(RC_STRUCTURE_HINT, kind);
    rcStaticSceneBegin();
    drawSteps(300);
    rcStaticSceneEnd();
    distances.push_back(ask(RC_RAY_DISTANCE));
    const std::vector<RCfloat> boxes = ask(RC_RAY_BOXES), triangles = ask(RC_RAY_TRIANGLES);
    most.push_back(*std::max_element(triangles.begin(), triangles.end()));
    const bool tree = kind != RC_STRUCTURE_NONE;
    EXPECT_EQ(*std::max_element(boxes.begin(), boxes.end()) > 0, tree);
    EXPECT_EQ(triangles[size_t(kWidth * kHeight - 1)] == 0, tree) << "the corner of the picture is empty";
  }
  EXPECT_EQ(distances[0], distances[1]);
  EXPECT_EQ(distances[0], distances[2]);
  EXPECT_EQ(most[2], 600) << "all triangles";
  EXPECT_LT(most[0], 200);
  EXPECT_LT(most[1], 200);
}

TEST_F(StatisticsTest, ReadRaysObeysTheViewportsSizeAlone) {
  pixelCamera();
  rcViewport(8, 4, 16, 8);
  const std::vector<RCfloat> values = ask(RC_RAY_BOXES, -3, -2, kWidth + 9, kHeight + 5);
  for (int row = 0; row < kHeight + 5; ++row) {
    for (int column = 0; column < kWidth + 9; ++column) {
      const int x = column - 3, y = row - 2;
      const bool inside = x >= 0 && x < 16 && y >= 0 && y < 8;
      EXPECT_EQ(values[size_t(row * (kWidth + 9) + column)] == -77, !inside) << x << ' ' << y;
    }
  }
}

TEST_F(StatisticsTest, ReadRaysErrors) {
  RCfloat value = 9;
  EXPECT_RAISES(RC_INVALID_ENUM, rcReadRaysRCX(0, 0, 1, 1, kNoToken, &value));
  EXPECT_RAISES(RC_INVALID_VALUE, rcReadRaysRCX(0, 0, -1, 1, RC_RAY_BOXES, &value));
  EXPECT_RAISES(RC_INVALID_VALUE, rcReadRaysRCX(0, 0, 1, -1, RC_RAY_BOXES, &value));
  rcReadRaysRCX(0, 0, 1, 1, RC_RAY_BOXES, nullptr);
  EXPECT_CLEAN();
  context->attach(nullptr);
  EXPECT_RAISES(RC_INVALID_OPERATION, rcReadRaysRCX(0, 0, 1, 1, RC_RAY_BOXES, &value));
  EXPECT_EQ(value, 9);
}

}  // namespace
}  // namespace rc::test
