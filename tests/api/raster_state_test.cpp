// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// State of rasterisation: checked, kept and returned; no picture depends on it. [OpenGL ES 1.1, 4.1, 4.2, 3.3, 3.4]
#include <functional>

#include "api/context_fixture.h"

namespace rc::test {
namespace {

using Values = std::vector<float>;
using RasterStateTest = ContextTest;

constexpr RCint kLargestInt = std::numeric_limits<RCint>::max();

TEST_F(RasterStateTest, InitialState) {
  const std::pair<RCenum, Values> initial[] = {{RC_BLEND_SRC, {RC_ONE}},
                                               {RC_BLEND_DST, {RC_ZERO}},
                                               {RC_LOGIC_OP_MODE, {RC_COPY}},
                                               {RC_DEPTH_FUNC, {RC_LESS}},
                                               {RC_DEPTH_WRITEMASK, {1}},
                                               {RC_DEPTH_CLEAR_VALUE, {1}},
                                               {RC_DEPTH_RANGE, {0, 1}},
                                               {RC_STENCIL_FUNC, {RC_ALWAYS}},
                                               {RC_STENCIL_REF, {0}},
                                               {RC_STENCIL_VALUE_MASK, {-1}},
                                               {RC_STENCIL_WRITEMASK, {-1}},
                                               {RC_STENCIL_FAIL, {RC_KEEP}},
                                               {RC_STENCIL_PASS_DEPTH_FAIL, {RC_KEEP}},
                                               {RC_STENCIL_PASS_DEPTH_PASS, {RC_KEEP}},
                                               {RC_STENCIL_CLEAR_VALUE, {0}},
                                               {RC_POINT_SIZE, {1}},
                                               {RC_POINT_SIZE_MIN, {0}},
                                               {RC_POINT_FADE_THRESHOLD_SIZE, {1}},
                                               {RC_POINT_DISTANCE_ATTENUATION, {1, 0, 0}},
                                               {RC_LINE_WIDTH, {1}},
                                               {RC_POLYGON_OFFSET_FACTOR, {0}},
                                               {RC_POLYGON_OFFSET_UNITS, {0}},
                                               {RC_SAMPLE_COVERAGE_VALUE, {1}},
                                               {RC_SAMPLE_COVERAGE_INVERT, {0}}};
  for (const auto &[name, values] : initial) EXPECT_EQ(floats(name, values.size()), values) << name;
  RCint range[2] = {7, 7};
  rcGetIntegerv(RC_DEPTH_RANGE, range);  // 0 ... 1 spans the integers
  EXPECT_EQ(range[0], 0);
  EXPECT_EQ(range[1], kLargestInt);
}

TEST_F(RasterStateTest, BlendFactors) {
  const RCenum common[] = {RC_ZERO, RC_ONE, RC_SRC_ALPHA, RC_ONE_MINUS_SRC_ALPHA, RC_DST_ALPHA, RC_ONE_MINUS_DST_ALPHA};
  const auto accepts = [&](RCenum source, RCenum destination) {
    rcBlendFunc(source, destination);
    EXPECT_CLEAN();
    EXPECT_EQ(integer(RC_BLEND_SRC), RCint(source));
    EXPECT_EQ(integer(RC_BLEND_DST), RCint(destination));
  };
  for (RCenum factor : common) accepts(factor, factor);
  for (RCenum source : {RC_DST_COLOR, RC_ONE_MINUS_DST_COLOR, RC_SRC_ALPHA_SATURATE}) accepts(RCenum(source), RC_ONE);
  for (RCenum destination : {RC_SRC_COLOR, RC_ONE_MINUS_SRC_COLOR}) accepts(RC_ONE, RCenum(destination));
  EXPECT_RAISES(RC_INVALID_ENUM, rcBlendFunc(kNoToken, RC_ONE));
  EXPECT_RAISES(RC_INVALID_ENUM, rcBlendFunc(RC_ONE, kNoToken));
  for (RCenum wrong : {RC_SRC_COLOR, RC_ONE_MINUS_SRC_COLOR}) {
    EXPECT_RAISES(RC_INVALID_ENUM, rcBlendFunc(RCenum(wrong), RC_ONE));
  }
  for (RCenum wrong : {RC_DST_COLOR, RC_ONE_MINUS_DST_COLOR, RC_SRC_ALPHA_SATURATE}) {
    EXPECT_RAISES(RC_INVALID_ENUM, rcBlendFunc(RC_ONE, RCenum(wrong)));
  }
}

TEST_F(RasterStateTest, Comparisons) {
  for (RCenum func = RC_NEVER; func <= RC_ALWAYS; ++func) {
    rcDepthFunc(func);
    rcStencilFunc(func, -5, 0x80000001u);
    EXPECT_EQ(integer(RC_DEPTH_FUNC), RCint(func));
    EXPECT_EQ(integer(RC_STENCIL_FUNC), RCint(func));
  }
  EXPECT_EQ(integer(RC_STENCIL_REF), -5);
  EXPECT_EQ(integer(RC_STENCIL_VALUE_MASK), RCint(0x80000001u));
  EXPECT_CLEAN();
  for (RCenum func : {kNoToken, RCenum(RC_NEVER - 1), RCenum(RC_ALWAYS + 1)}) {
    EXPECT_RAISES(RC_INVALID_ENUM, rcDepthFunc(func));
    EXPECT_RAISES(RC_INVALID_ENUM, rcStencilFunc(func, 0, 0));
  }
}

TEST_F(RasterStateTest, LogicOperations) {
  for (RCenum op = RC_CLEAR; op <= RC_SET; ++op) {
    rcLogicOp(op);
    EXPECT_EQ(integer(RC_LOGIC_OP_MODE), RCint(op));
  }
  EXPECT_CLEAN();
  for (RCenum op : {kNoToken, RCenum(RC_CLEAR - 1), RCenum(RC_SET + 1)}) {
    EXPECT_RAISES(RC_INVALID_ENUM, rcLogicOp(op));
  }
}

TEST_F(RasterStateTest, StencilOperations) {
  const RCenum all[] = {RC_KEEP, RC_ZERO, RC_REPLACE, RC_INCR, RC_DECR, RC_INVERT};
  for (size_t i = 0; i < 6; ++i) {
    rcStencilOp(all[i], all[(i + 1) % 6], all[(i + 2) % 6]);
    EXPECT_EQ(integer(RC_STENCIL_FAIL), RCint(all[i]));
    EXPECT_EQ(integer(RC_STENCIL_PASS_DEPTH_FAIL), RCint(all[(i + 1) % 6]));
    EXPECT_EQ(integer(RC_STENCIL_PASS_DEPTH_PASS), RCint(all[(i + 2) % 6]));
  }
  rcStencilMask(0xF0);
  EXPECT_EQ(integer(RC_STENCIL_WRITEMASK), 0xF0);
  rcClearStencil(-9);
  EXPECT_EQ(integer(RC_STENCIL_CLEAR_VALUE), -9);
  EXPECT_CLEAN();
  EXPECT_RAISES(RC_INVALID_ENUM, rcStencilOp(kNoToken, RC_KEEP, RC_KEEP));
  EXPECT_RAISES(RC_INVALID_ENUM, rcStencilOp(RC_KEEP, RC_ONE, RC_KEEP));
  EXPECT_RAISES(RC_INVALID_ENUM, rcStencilOp(RC_KEEP, RC_KEEP, RC_DECR + 1));
}

TEST_F(RasterStateTest, ClampedNumbers) {
  RCfixed fixed[2] = {};
  rcDepthRangef(0.25f, 3);
  EXPECT_EQ(floats(RC_DEPTH_RANGE, 2), (Values{0.25f, 1}));
  rcDepthRangex(-kFixedOne, kFixedOne / 2);
  rcGetFixedv(RC_DEPTH_RANGE, fixed);
  EXPECT_EQ(fixed[0], 0);
  EXPECT_EQ(fixed[1], kFixedOne / 2);
  rcClearDepthf(-2);
  EXPECT_EQ(floats(RC_DEPTH_CLEAR_VALUE, 1), Values{0});
  EXPECT_EQ(integer(RC_DEPTH_CLEAR_VALUE), 0);
  rcClearDepthx(kFixedOne / 4);
  EXPECT_EQ(floats(RC_DEPTH_CLEAR_VALUE, 1), Values{0.25f});
  rcDepthMask(RC_FALSE);
  EXPECT_EQ(integer(RC_DEPTH_WRITEMASK), 0);
  rcDepthMask(9);
  EXPECT_EQ(integer(RC_DEPTH_WRITEMASK), 1);
  rcSampleCoverage(0.5f, RC_TRUE);
  EXPECT_EQ(floats(RC_SAMPLE_COVERAGE_VALUE, 1), Values{0.5f});
  EXPECT_EQ(integer(RC_SAMPLE_COVERAGE_INVERT), 1);
  rcSampleCoveragex(2 * kFixedOne, RC_FALSE);
  EXPECT_EQ(integer(RC_SAMPLE_COVERAGE_VALUE), kLargestInt);
  EXPECT_EQ(integer(RC_SAMPLE_COVERAGE_INVERT), 0);
  EXPECT_CLEAN();
}

TEST_F(RasterStateTest, SizesAndOffsets) {
  rcLineWidth(2.5f);
  EXPECT_EQ(floats(RC_LINE_WIDTH, 1), Values{2.5f});
  EXPECT_EQ(integer(RC_LINE_WIDTH), 3);
  rcLineWidthx(kFixedOne / 2);
  EXPECT_EQ(floats(RC_LINE_WIDTH, 1), Values{0.5f});
  rcPointSize(7);
  EXPECT_EQ(floats(RC_POINT_SIZE, 1), Values{7});
  rcPointSizex(3 * kFixedOne);
  EXPECT_EQ(floats(RC_POINT_SIZE, 1), Values{3});
  rcPolygonOffset(-1.5f, 4);
  EXPECT_EQ(floats(RC_POLYGON_OFFSET_FACTOR, 1), Values{-1.5f});
  EXPECT_EQ(floats(RC_POLYGON_OFFSET_UNITS, 1), Values{4});
  rcPolygonOffsetx(kFixedOne, -kFixedOne);
  EXPECT_EQ(floats(RC_POLYGON_OFFSET_FACTOR, 1), Values{1});
  EXPECT_EQ(floats(RC_POLYGON_OFFSET_UNITS, 1), Values{-1});
  EXPECT_CLEAN();
  for (float size : {0.0f, -1.0f, kNan}) {
    EXPECT_RAISES(RC_INVALID_VALUE, rcLineWidth(size));
    EXPECT_RAISES(RC_INVALID_VALUE, rcPointSize(size));
  }
  for (RCfixed size : {0, -kFixedOne}) {
    EXPECT_RAISES(RC_INVALID_VALUE, rcLineWidthx(size));
    EXPECT_RAISES(RC_INVALID_VALUE, rcPointSizex(size));
  }
}

TEST_F(RasterStateTest, PointParameters) {
  for (RCenum name : {RC_POINT_SIZE_MIN, RC_POINT_SIZE_MAX, RC_POINT_FADE_THRESHOLD_SIZE}) {
    rcPointParameterf(RCenum(name), 2.5f);
    EXPECT_EQ(floats(RCenum(name), 1), Values{2.5f});
    rcPointParameterx(RCenum(name), kFixedOne / 2);
    EXPECT_EQ(floats(RCenum(name), 1), Values{0.5f});
    const float real[] = {4};
    rcPointParameterfv(RCenum(name), real);
    EXPECT_EQ(floats(RCenum(name), 1), Values{4});
    const RCfixed fixed[] = {6 * kFixedOne};
    rcPointParameterxv(RCenum(name), fixed);
    RCfixed back = 0;
    rcGetFixedv(RCenum(name), &back);
    EXPECT_EQ(back, fixed[0]);
  }
  const float attenuation[] = {0.5f, 0.25f, 0};
  rcPointParameterfv(RC_POINT_DISTANCE_ATTENUATION, attenuation);
  EXPECT_EQ(floats(RC_POINT_DISTANCE_ATTENUATION, 3), (Values{0.5f, 0.25f, 0}));
  const RCfixed fixed[] = {0, kFixedOne, 2 * kFixedOne};
  rcPointParameterxv(RC_POINT_DISTANCE_ATTENUATION, fixed);
  EXPECT_EQ(floats(RC_POINT_DISTANCE_ATTENUATION, 3), (Values{0, 1, 2}));
  EXPECT_CLEAN();
}

TEST_F(RasterStateTest, PointParameterErrors) {
  const float real[] = {1, 1, 1}, minus[] = {1, -1, 1}, minusOne[] = {-1};
  const RCfixed fixed[] = {1, 1, 1}, fixedMinus[] = {1, 1, -1};
  for (RCenum name : {kNoToken, RCenum(RC_POINT_SIZE)}) {
    EXPECT_RAISES(RC_INVALID_ENUM, rcPointParameterf(name, 1));
    EXPECT_RAISES(RC_INVALID_ENUM, rcPointParameterx(name, 1));
    EXPECT_RAISES(RC_INVALID_ENUM, rcPointParameterfv(name, real));
    EXPECT_RAISES(RC_INVALID_ENUM, rcPointParameterxv(name, fixed));
  }
  EXPECT_RAISES(RC_INVALID_ENUM, rcPointParameterf(RC_POINT_DISTANCE_ATTENUATION, 1));  // three values
  EXPECT_RAISES(RC_INVALID_ENUM, rcPointParameterx(RC_POINT_DISTANCE_ATTENUATION, 1));
  EXPECT_RAISES(RC_INVALID_VALUE, rcPointParameterf(RC_POINT_SIZE_MIN, -1));
  EXPECT_RAISES(RC_INVALID_VALUE, rcPointParameterf(RC_POINT_SIZE_MAX, kNan));
  EXPECT_RAISES(RC_INVALID_VALUE, rcPointParameterx(RC_POINT_FADE_THRESHOLD_SIZE, -1));
  EXPECT_RAISES(RC_INVALID_VALUE, rcPointParameterfv(RC_POINT_SIZE_MIN, minusOne));
  EXPECT_RAISES(RC_INVALID_VALUE, rcPointParameterfv(RC_POINT_DISTANCE_ATTENUATION, minus));
  EXPECT_RAISES(RC_INVALID_VALUE, rcPointParameterxv(RC_POINT_DISTANCE_ATTENUATION, fixedMinus));
}

// Neither this state nor any of its switches is seen in a picture.
TEST_F(RasterStateTest, NoPictureDependsOnIt) {
  pixelCamera();
  paint(0.5f, 0.25f, 1);
  const auto picture = [&] {
    drawQuad({10, 10, 40, 30}, -20);
    drawQuad({20, 5, 30, 40});
    trace();
    return surface.pixels;
  };
  const std::vector<uint32_t> plain = picture();
  const std::pair<const char *, std::function<void()>> calls[] = {
      {"rcBlendFunc", [] { rcBlendFunc(RC_ZERO, RC_ONE); }},
      {"rcLogicOp", [] { rcLogicOp(RC_INVERT); }},
      {"rcDepthFunc", [] { rcDepthFunc(RC_NEVER); }},
      {"rcDepthMask", [] { rcDepthMask(RC_FALSE); }},
      {"rcDepthRangef", [] { rcDepthRangef(1, 0); }},
      {"rcStencilFunc", [] { rcStencilFunc(RC_NEVER, 1, 1); }},
      {"rcPolygonOffset", [] { rcPolygonOffset(1000, 1000); }},
      {"rcSampleCoverage", [] { rcSampleCoverage(0, RC_FALSE); }},
      {"rcNormal3f", [] { rcNormal3f(0, 0, -1); }}};
  for (const auto &[name, call] : calls) call();
  for (RCenum cap : {RC_BLEND, RC_COLOR_LOGIC_OP, RC_COLOR_MATERIAL, RC_DEPTH_TEST, RC_DITHER, RC_LINE_SMOOTH,
                     RC_NORMALIZE, RC_POINT_SMOOTH, RC_POINT_SPRITE_OES, RC_POLYGON_OFFSET_FILL, RC_RESCALE_NORMAL,
                     RC_SAMPLE_ALPHA_TO_COVERAGE, RC_SAMPLE_ALPHA_TO_ONE, RC_SAMPLE_COVERAGE, RC_STENCIL_TEST}) {
    rcEnable(RCenum(cap));
  }
  EXPECT_CLEAN();
  EXPECT_EQ(picture(), plain);
}

}  // namespace
}  // namespace rc::test
