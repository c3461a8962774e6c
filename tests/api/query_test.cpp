// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// rcGetBooleanv, rcGetFixedv, rcGetFloatv, rcGetIntegerv: names and conversions. [reference 4.11]
#include "api/context_fixture.h"

namespace rc::test {
namespace {

using QueryTest = ContextTest;

// Of each documented name: how many values it writes.
constexpr struct {
  RCenum name;
  int count;
} kNames[] = {{RC_ARRAY_BUFFER_BINDING, 1},
              {RC_COLOR_CLEAR_VALUE, 4},
              {RC_CURRENT_COLOR, 4},
              {RC_ELEMENT_ARRAY_BUFFER_BINDING, 1},
              {RC_LIGHT0, 1},
              {RC_LIGHT7, 1},
              {RC_LIGHTING, 1},
              {RC_MAX_LIGHTS, 1},
              {RC_MAX_MODELVIEW_STACK_DEPTH, 1},
              {RC_MAX_PROJECTION_STACK_DEPTH, 1},
              {RC_MAX_TEXTURE_STACK_DEPTH, 1},
              {RC_MAX_TEXTURE_SIZE, 1},
              {RC_MAX_TEXTURE_UNITS, 1},
              {RC_MAX_THRESHOLD_LEVELS, 1},
              {RC_MAX_VIEWPORT_DIMS, 2},
              {RC_MATRIX_MODE, 1},
              {RC_MODELVIEW_MATRIX, 16},
              {RC_PROJECTION_MATRIX, 16},
              {RC_TEXTURE_MATRIX, 16},
              {RC_MODELVIEW_STACK_DEPTH, 1},
              {RC_PROJECTION_STACK_DEPTH, 1},
              {RC_TEXTURE_STACK_DEPTH, 1},
              {RC_NORMAL_ARRAY, 1},
              {RC_NORMAL_ARRAY_BUFFER_BINDING, 1},
              {RC_NORMAL_ARRAY_STRIDE, 1},
              {RC_NORMAL_ARRAY_TYPE, 1},
              {RC_TEXTURE_2D, 1},
              {RC_TEXTURE_2D_NORMAL, 1},
              {RC_TEXTURE_BINDING_2D, 1},
              {RC_TEXTURE_COORD_ARRAY, 1},
              {RC_TEXTURE_COORD_ARRAY_BUFFER_BINDING, 1},
              {RC_TEXTURE_COORD_ARRAY_SIZE, 1},
              {RC_TEXTURE_COORD_ARRAY_STRIDE, 1},
              {RC_TEXTURE_COORD_ARRAY_TYPE, 1},
              {RC_USE_SHADOW, 1},
              {RC_USE_COLOR_SHADOW, 1},
              {RC_USE_TEXTURE_ALPHA_SHADOW, 1},
              {RC_USE_TEXTURE_ONLY, 1},
              {RC_USE_TRANSMITTANCE_SHADOW, 1},
              {RC_VIEWPORT, 4},
              {RC_VERTEX_ARRAY, 1},
              {RC_VERTEX_ARRAY_BUFFER_BINDING, 1},
              {RC_VERTEX_ARRAY_SIZE, 1},
              {RC_VERTEX_ARRAY_STRIDE, 1},
              {RC_VERTEX_ARRAY_TYPE, 1},
              {RC_CURRENT_AMBIENT, 4},
              {RC_CURRENT_DIFFUSE, 4},
              {RC_CURRENT_SPECULAR, 4},
              {RC_MATERIAL_BINDING, 1},
              {RC_MAX_MATERIALS, 1},
              {RC_DEPTH_BOUNCE, 1},
              {RC_FRAME_TRIANGLES, 1},
              {RC_FRAME_TRIANGLES_SKIPPED, 1},
              {RC_FRAME_RAYS, 1},
              {RC_FRAME_RAYS_PRIMARY, 1},
              {RC_FRAME_RAYS_SHADOW, 1},
              {RC_FRAME_RAYS_REFLECTED, 1},
              {RC_FRAME_RAYS_REFRACTED, 1},
              {RC_FRAME_RAYS_STRAIGHT, 1},
              {RC_FRAME_BUILD_TIME, 1},
              {RC_FRAME_TRACE_TIME, 1},
              {RC_FRAME_TRANSFORM_TIME, 1},
              {RC_FRAME_PRESENT_TIME, 1},
              {RC_FRAME_PRIMARY_TIME, 1},
              {RC_FRAME_SECONDARY_TIME, 1},
              {RC_FRAME_SHADOW_TIME, 1},
              {RC_FRAME_SHADE_TIME, 1},
              {RC_FRAME_STORE_TIME, 1},
              {RC_STATIC_BUILD_TIME, 1},
              {RC_MEMORY_TRIANGLES, 1},
              {RC_MEMORY_STRUCTURE, 1},
              {RC_MEMORY_TEXTURES, 1},
              {RC_STRUCTURE_NODES, 1},
              {RC_STRUCTURE_LEAVES, 1},
              {RC_STRUCTURE_DEPTH, 1},
              {RC_STRUCTURE_COST, 1},
              {RC_STRUCTURE_HINT, 1},
              {RC_LARGE_TEXTURES, 1}};

template <class Value>
int written(void (*get)(RCenum, Value *), RCenum name) {
  Value one[17], two[17];  // what both leave alone was not written
  std::fill_n(one, 17, Value(77));
  std::fill_n(two, 17, Value(78));
  get(name, one);
  get(name, two);
  int count = 0;
  while (count < 17 && one[count] == two[count]) ++count;
  for (int i = count; i < 17; ++i) EXPECT_NE(one[i], two[i]) << name;
  return count;
}

TEST_F(QueryTest, EveryNameWritesItsNumberOfValues) {
  for (const auto &[name, count] : kNames) {
    EXPECT_EQ(written(rcGetBooleanv, name), count) << std::hex << name;
    EXPECT_EQ(written(rcGetFixedv, name), count) << std::hex << name;
    EXPECT_EQ(written(rcGetFloatv, name), count) << std::hex << name;
    EXPECT_EQ(written(rcGetIntegerv, name), count) << std::hex << name;
    EXPECT_EQ(rcGetError(), RCenum(RC_NO_ERROR)) << std::hex << name;
  }
}

TEST_F(QueryTest, NameErrors) {
  RCboolean boolean = 9;
  RCfixed fixed = 9;
  RCfloat real = 9;
  RCint whole = 9;
  for (RCenum name : {kNoToken, RCenum(0), RCenum(RC_TEXTURE_ALPHA), RCenum(RC_CURRENT_PALETTE_MATRIX_OES)}) {
    EXPECT_RAISES(RC_INVALID_ENUM, rcGetBooleanv(name, &boolean));
    EXPECT_RAISES(RC_INVALID_ENUM, rcGetFixedv(name, &fixed));
    EXPECT_RAISES(RC_INVALID_ENUM, rcGetFloatv(name, &real));
    EXPECT_RAISES(RC_INVALID_ENUM, rcGetIntegerv(name, &whole));
  }
  EXPECT_TRUE(boolean == 9 && fixed == 9 && real == 9 && whole == 9);
}

TEST_F(QueryTest, NullPointersAreHarmless) {
  rcGetBooleanv(RC_VIEWPORT, nullptr);
  rcGetFixedv(RC_VIEWPORT, nullptr);
  rcGetFloatv(RC_VIEWPORT, nullptr);
  rcGetIntegerv(RC_VIEWPORT, nullptr);
  EXPECT_CLEAN();
}

TEST_F(QueryTest, ColoursBecome255InIntegers) {
  rcClearColor(1, 0.5f, 0.2f, 0);
  RCint whole[4];
  rcGetIntegerv(RC_COLOR_CLEAR_VALUE, whole);
  EXPECT_EQ(whole[0], 255);
  EXPECT_EQ(whole[1], 128);  // 127.5 to the nearest
  EXPECT_EQ(whole[2], 51);
  EXPECT_EQ(whole[3], 0);
  RCfixed fixed[4];
  rcGetFixedv(RC_COLOR_CLEAR_VALUE, fixed);
  EXPECT_EQ(fixed[0], kFixedOne);
  EXPECT_EQ(fixed[1], kFixedOne / 2);
  RCboolean boolean[4];
  rcGetBooleanv(RC_COLOR_CLEAR_VALUE, boolean);
  EXPECT_EQ(boolean[1], RC_TRUE);
  EXPECT_EQ(boolean[3], RC_FALSE);
}

TEST_F(QueryTest, NumbersAreRoundedAndScaled) {
  rcTranslatef(1.75f, -1.75f, 0.25f);
  RCint whole[16];
  rcGetIntegerv(RC_MODELVIEW_MATRIX, whole);
  EXPECT_EQ(whole[12], 2);
  EXPECT_EQ(whole[13], -2);
  EXPECT_EQ(whole[14], 0);
  RCfixed fixed[16];
  rcGetFixedv(RC_MODELVIEW_MATRIX, fixed);
  EXPECT_EQ(fixed[12], kFixedOne * 7 / 4);
  EXPECT_EQ(fixed[13], -kFixedOne * 7 / 4);
  RCfixed depth = 0;
  rcGetFixedv(RC_MODELVIEW_STACK_DEPTH, &depth);
  EXPECT_EQ(depth, kFixedOne);
  rcTranslatef(1e30f, 0, 0);  // saturates
  rcGetIntegerv(RC_MODELVIEW_MATRIX, whole);
  EXPECT_EQ(whole[12], std::numeric_limits<RCint>::max());
}

TEST_F(QueryTest, TokensAreNeverScaled) {
  RCfixed mode = 0;
  rcGetFixedv(RC_MATRIX_MODE, &mode);
  EXPECT_EQ(mode, RC_MODELVIEW);
  RCfloat type = 0;
  rcGetFloatv(RC_VERTEX_ARRAY_TYPE, &type);
  EXPECT_EQ(type, float(RC_FLOAT));
}

TEST_F(QueryTest, SwitchesAreZeroOrOne) {
  rcEnable(RC_LIGHT3);
  rcEnableClientState(RC_NORMAL_ARRAY);
  for (RCenum name : {RC_LIGHT3, RC_USE_SHADOW, RC_NORMAL_ARRAY}) EXPECT_EQ(integer(RCenum(name)), 1) << name;
  for (RCenum name : {RC_LIGHT4, RC_LIGHTING, RC_VERTEX_ARRAY}) EXPECT_EQ(integer(RCenum(name)), 0) << name;
}

TEST_F(QueryTest, Limits) {
  EXPECT_EQ(floats(RC_MAX_VIEWPORT_DIMS, 2), (std::vector<float>{2048, 2048}));
  EXPECT_EQ(integer(RC_MAX_THRESHOLD_LEVELS), 10);
}

TEST_F(QueryTest, CurrentColoursAreThoseOfTheBoundMaterial) {
  rcBindMaterial(2);
  const float colour[] = {0.5f, 0.25f, 1};
  rcMaterialfv(RC_FRONT_AND_BACK, RC_SPECULAR, colour);
  EXPECT_EQ(floats(RC_CURRENT_SPECULAR, 4), (std::vector<float>{0.5f, 0.25f, 1, 1}));
  EXPECT_EQ(floats(RC_CURRENT_AMBIENT, 4), (std::vector<float>{0.2f, 0.2f, 0.2f, 1}));
  EXPECT_EQ(floats(RC_CURRENT_DIFFUSE, 4), (std::vector<float>{0.8f, 0.8f, 0.8f, 1}));
  EXPECT_EQ(integer(RC_MATERIAL_BINDING), 2);
}

// Programs ask for the limits and switches of the matrix palette before they use it.
TEST_F(QueryTest, NamesOfTheMatrixPalette) {
  EXPECT_EQ(integer(RC_MAX_PALETTE_MATRICES_OES), 128);
  EXPECT_EQ(integer(RC_MAX_VERTEX_UNITS_OES), 128);
  for (RCenum name : {RC_MATRIX_PALETTE_OES, RC_MATRIX_INDEX_ARRAY_OES, RC_WEIGHT_ARRAY_OES}) {
    EXPECT_EQ(integer(RCenum(name)), 0) << name;
  }
  EXPECT_CLEAN();
}

// Names that only rasters have answer without error, most of them 0.
TEST_F(QueryTest, NamesOfRasters) {
  for (RCenum name : {RC_BLEND, RC_DEPTH_TEST, RC_FOG, RC_STENCIL_TEST, RC_SCISSOR_TEST, RC_ALPHA_TEST, RC_CULL_FACE}) {
    EXPECT_EQ(integer(RCenum(name)), 0) << name;
  }
  EXPECT_EQ(integer(RC_CULL_FACE_MODE), RC_BACK);
  EXPECT_EQ(integer(RC_ACTIVE_TEXTURE), 0x84C0);
  EXPECT_EQ(integer(RC_CLIENT_ACTIVE_TEXTURE), 0x84C0);
  EXPECT_EQ(integer(RC_MULTISAMPLE), 1);
  EXPECT_EQ(floats(RC_CURRENT_NORMAL, 3), (std::vector<float>{0, 0, 1}));
  EXPECT_CLEAN();
}

}  // namespace
}  // namespace rc::test
