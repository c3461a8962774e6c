// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Enables, hints, errors, strings. [spec 3.8; reference 4.3, 4.6]
#include "api/context_fixture.h"

namespace rc::test {
namespace {

using StateTest = ContextTest;

// The caps of OpenGL ES 1.1 that RayCore's own state does not have.
constexpr RCenum kGlCaps[] = {RC_ALPHA_TEST,
                              RC_BLEND,
                              RC_COLOR_LOGIC_OP,
                              RC_CLIP_PLANE0,
                              RC_CLIP_PLANE1,
                              RC_CLIP_PLANE2,
                              RC_CLIP_PLANE3,
                              RC_CLIP_PLANE4,
                              RC_CLIP_PLANE5,
                              RC_COLOR_MATERIAL,
                              RC_CULL_FACE,
                              RC_DEPTH_TEST,
                              RC_DITHER,
                              RC_FOG,
                              RC_LINE_SMOOTH,
                              RC_MULTISAMPLE,
                              RC_NORMALIZE,
                              RC_POINT_SMOOTH,
                              RC_POINT_SPRITE_OES,
                              RC_POLYGON_OFFSET_FILL,
                              RC_RESCALE_NORMAL,
                              RC_SCISSOR_TEST,
                              RC_STENCIL_TEST,
                              RC_SAMPLE_ALPHA_TO_COVERAGE,
                              RC_SAMPLE_ALPHA_TO_ONE,
                              RC_SAMPLE_COVERAGE};

TEST_F(StateTest, InitialSwitches) {
  EXPECT_TRUE(rcIsEnabled(RC_USE_SHADOW));
  EXPECT_TRUE(rcIsEnabled(RC_USE_COLOR_SHADOW));
  for (RCenum cap : {RC_LIGHTING, RC_TEXTURE_2D, RC_TEXTURE_2D_NORMAL, RC_USE_TRANSMITTANCE_SHADOW,
                     RC_USE_TEXTURE_ALPHA_SHADOW, RC_USE_TEXTURE_ONLY, RC_LARGE_TEXTURES}) {
    EXPECT_FALSE(rcIsEnabled(RCenum(cap))) << cap;
  }
}

TEST_F(StateTest, SwitchesAreKeptOneByOne) {
  const RCenum all[] = {RC_LIGHTING,
                        RC_LIGHT0,
                        RC_LIGHT7,
                        RC_TEXTURE_2D,
                        RC_TEXTURE_2D_NORMAL,
                        RC_USE_SHADOW,
                        RC_USE_COLOR_SHADOW,
                        RC_USE_TEXTURE_ONLY,
                        RC_USE_TRANSMITTANCE_SHADOW,
                        RC_LARGE_TEXTURES,
                        RC_USE_TEXTURE_ALPHA_SHADOW};
  for (RCenum cap : all) rcDisable(cap);
  for (RCenum cap : all) {
    rcEnable(cap);
    for (RCenum other : all) EXPECT_EQ(rcIsEnabled(other), cap == other ? RC_TRUE : RC_FALSE) << cap << ' ' << other;
    rcDisable(cap);
  }
  EXPECT_CLEAN();
}

TEST_F(StateTest, CapsOfGlAreKept) {
  for (RCenum cap : kGlCaps) {
    EXPECT_EQ(rcIsEnabled(cap), cap == RC_MULTISAMPLE) << cap << " initially";
    rcEnable(cap);
    EXPECT_TRUE(rcIsEnabled(cap)) << cap;
    EXPECT_EQ(integer(cap), 1) << cap;
    rcDisable(cap);
    EXPECT_FALSE(rcIsEnabled(cap)) << cap;
    EXPECT_EQ(integer(cap), 0) << cap;
  }
  EXPECT_CLEAN();
}

TEST_F(StateTest, SwitchErrors) {
  for (RCenum cap : {kNoToken, RCenum(0), RCenum(RC_LIGHT7 + 1), RCenum(RC_LIGHT0 - 1)}) {
    EXPECT_RAISES(RC_INVALID_ENUM, rcEnable(cap));
    EXPECT_RAISES(RC_INVALID_ENUM, rcDisable(cap));
    EXPECT_RAISES(RC_INVALID_ENUM, EXPECT_FALSE(rcIsEnabled(cap)));
  }
  EXPECT_RAISES(RC_INVALID_ENUM, rcEnable(RC_VERTEX_ARRAY));  // a client state
}

TEST_F(StateTest, HintsAreKept) {
  const api::HintState &hints = context->state.hints;
  EXPECT_EQ(hints.mipmap, RCenum(RC_DONT_CARE));
  EXPECT_EQ(hints.rendering, RCenum(RC_DONT_CARE));
  EXPECT_EQ(hints.rayBounceThreshold, RCenum(RC_DONT_CARE));
  for (RCenum mode : {RC_FASTEST, RC_NICEST, RC_DONT_CARE}) {
    rcHint(RC_MIPMAP_HINT, RCenum(mode));
    EXPECT_EQ(hints.mipmap, RCenum(mode));
  }
  for (RCenum mode : {RC_FASTEST, RC_NICEST, RC_FASTEST_AND_NICEST, RC_DONT_CARE}) {
    rcHint(RC_RENDERING_HINT, RCenum(mode));
    EXPECT_EQ(hints.rendering, RCenum(mode));
  }
  for (RCenum mode = RC_THRESHOLD_LEVEL0; mode <= RC_THRESHOLD_LEVEL9; ++mode) {
    rcHint(RC_RAYBOUNCE_THRESHOLD_HINT, mode);
    EXPECT_EQ(hints.rayBounceThreshold, mode);
  }
  rcHint(RC_RAYBOUNCE_THRESHOLD_HINT, RC_DONT_CARE);
  for (RCenum target : {RC_FOG_HINT, RC_GENERATE_MIPMAP_HINT, RC_LINE_SMOOTH_HINT, RC_PERSPECTIVE_CORRECTION_HINT,
                        RC_POINT_SMOOTH_HINT}) {
    rcHint(RCenum(target), RC_NICEST);
    rcHint(RCenum(target), kNoToken);  // any value
  }
  EXPECT_CLEAN();
}

TEST_F(StateTest, HintErrors) {
  EXPECT_RAISES(RC_INVALID_ENUM, rcHint(kNoToken, RC_NICEST));
  EXPECT_RAISES(RC_INVALID_ENUM, rcHint(RC_MIPMAP_HINT, kNoToken));
  EXPECT_RAISES(RC_INVALID_ENUM, rcHint(RC_MIPMAP_HINT, RC_FASTEST_AND_NICEST));
  EXPECT_RAISES(RC_INVALID_ENUM, rcHint(RC_RENDERING_HINT, RC_THRESHOLD_LEVEL0));
  EXPECT_RAISES(RC_INVALID_ENUM, rcHint(RC_RAYBOUNCE_THRESHOLD_HINT, RC_FASTEST));
  EXPECT_RAISES(RC_INVALID_ENUM, rcHint(RC_RAYBOUNCE_THRESHOLD_HINT, RC_THRESHOLD_LEVEL0 - 1));
  EXPECT_RAISES(RC_INVALID_ENUM, rcHint(RC_RAYBOUNCE_THRESHOLD_HINT, RC_THRESHOLD_LEVEL9 + 1));
}

TEST_F(StateTest, TheRenderingHintAsksForFourSamples) {
  rcHint(RC_RENDERING_HINT, RC_FASTEST);
  rcFinish();
  EXPECT_EQ(integer(RC_FRAME_RAYS), kWidth * kHeight);
  rcHint(RC_RENDERING_HINT, RC_NICEST);
  rcFinish();
  EXPECT_EQ(integer(RC_FRAME_RAYS), 4 * kWidth * kHeight);
  rcHint(RC_RENDERING_HINT, RC_FASTEST_AND_NICEST);
  rcFinish();
  EXPECT_GE(integer(RC_FRAME_RAYS), kWidth * kHeight);
}

// Level i drops rays that count for less than (i + 1) / 100.
TEST_F(StateTest, TheThresholdHintDropsWeakRays) {
  pixelCamera();
  rcClearColor(1, 1, 1, 0);
  paint(0, 0, 0);
  rcMaterialf(RC_FRONT_AND_BACK, RC_REFLECTION, 0.0625f);
  for (RCenum level = RC_THRESHOLD_LEVEL0; level <= RC_THRESHOLD_LEVEL9; ++level) {
    rcHint(RC_RAYBOUNCE_THRESHOLD_HINT, level);
    drawQuad({-10, -10, 80, 60});
    rcFinish();
    const bool traced = level <= RC_THRESHOLD_LEVEL5;  // 0.06 <= 0.0625 < 0.07
    EXPECT_EQ(pixel(32, 24)[0], traced ? 16 : 0) << level - RC_THRESHOLD_LEVEL0;
  }
}

TEST_F(StateTest, TheFirstErrorSticks) {
  EXPECT_CLEAN();
  rcPopMatrix();
  rcEnable(kNoToken);
  rcViewport(0, 0, -1, -1);
  rcTranslatef(1, 0, 0);  // a good call does not clear it
  EXPECT_EQ(rcGetError(), RCenum(RC_STACK_UNDERFLOW));
  EXPECT_CLEAN();
  rcViewport(0, 0, -1, -1);
  EXPECT_EQ(rcGetError(), RCenum(RC_INVALID_VALUE));
  EXPECT_CLEAN();
}

TEST_F(StateTest, ErrorsBelongToTheContext) {
  rcPopMatrix();
  api::Context other{Settings{}};
  api::setCurrentContext(&other);
  EXPECT_CLEAN();
  api::setCurrentContext(context.get());
  EXPECT_EQ(rcGetError(), RCenum(RC_STACK_UNDERFLOW));
}

TEST_F(StateTest, Strings) {
  const auto text = [](RCenum name) { return std::string(reinterpret_cast<const char *>(rcGetString(name))); };
  EXPECT_EQ(text(RC_VENDOR), "Siliconarts Inc.");
  EXPECT_EQ(text(RC_RENDERER), "RayCore");
  EXPECT_EQ(text(RC_VERSION), "RayCore API 1.0");
  const std::string extensions = text(RC_EXTENSIONS);
  for (const char *name : {"RC_RCX_es11_functions", "RC_RCX_large_textures", "RC_RCX_vertex_colors"}) {
    EXPECT_NE(extensions.find(name), std::string::npos) << name;
  }
  EXPECT_CLEAN();
  EXPECT_RAISES(RC_INVALID_ENUM, EXPECT_EQ(rcGetString(kNoToken), nullptr));
}

}  // namespace
}  // namespace rc::test
