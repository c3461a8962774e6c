// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Frames, static and dynamic geometry. [spec 3.7]
#include <functional>

#include "api/context_fixture.h"

namespace rc::test {
namespace {

class SceneTest : public ContextTest {
 protected:
  void SetUp() override {
    ContextTest::SetUp();
    pixelCamera();
    paint(1, 1, 1);
  }

  void drawLeft() { drawQuad({0, 0, 20, 48}); }
  void drawRight() { drawQuad({40, 0, 64, 48}); }
  bool left() const { return pixel(10, 24) == kWhite; }
  bool right() const { return pixel(50, 24) == kWhite; }

  void staticLeft() {
    rcStaticSceneBegin();
    drawLeft();
    rcStaticSceneEnd();
  }

  // Whether the call traced a frame.
  template <class Call>
  bool traces(Call &&call) {
    surface.fill(kUntouched);
    call();
    return surface.pixels[0] != kUntouched;
  }
};

TEST_F(SceneTest, FinishTracesOncePerChange) {
  drawLeft();
  EXPECT_TRUE(traces(rcFinish));
  EXPECT_FALSE(traces(rcFinish));
  EXPECT_FALSE(traces(rcFlush));
  rcClearColor(0, 0, 1, 0);
  EXPECT_TRUE(traces(rcFlush));
  EXPECT_FALSE(traces(rcFinish));
  drawRight();
  EXPECT_TRUE(traces(rcFinish));
  EXPECT_CLEAN();
}

TEST_F(SceneTest, WhatChangesThePictureIsTraced) {
  drawLeft();
  rcFinish();
  const float colour[] = {0.5f, 0.5f, 0.5f};
  const std::vector<std::pair<const char *, std::function<void()>>> changes{
      {"rcViewport", [] { rcViewport(0, 0, 30, 30); }},
      {"rcFrustumf", [] { rcFrustumf(-1, 1, -1, 1, 1, 2); }},
      {"rcuLookAt", [] { rcuLookAt(0, 0, 9, 0, 0, 0, 0, 1, 0); }},
      {"rcLightfv", [&] { rcLightfv(RC_LIGHT0, RC_AMBIENT, colour); }},
      {"rcMaterialfv", [&] { rcMaterialfv(RC_FRONT_AND_BACK, RC_AMBIENT, colour); }},
      {"rcEnable", [] { rcEnable(RC_LIGHTING); }},
      {"rcDisable", [] { rcDisable(RC_USE_SHADOW); }},
      {"rcHint", [] { rcHint(RC_RENDERING_HINT, RC_NICEST); }},
      {"rcDepthBounce", [] { rcDepthBounce(3); }},
      {"rcBindTexture", [] { rcBindTexture(RC_TEXTURE_2D, 1); }},
      {"rcTexImage2D",
       [&] {
         loadSolid({1, 2, 3});
       }},
      {"rcTexParameteri", [] { rcTexParameteri(RC_TEXTURE_2D, RC_TEXTURE_WRAP_S, RC_CLAMP_TO_EDGE); }},
      {"rcStaticSceneBegin", [] { rcStaticSceneBegin(), rcStaticSceneEnd(); }},
      {"rcSceneAllInit", [] { rcSceneAllInit(); }}};
  for (const auto &[name, change] : changes) {
    change();
    EXPECT_TRUE(traces(rcFinish)) << name;
    EXPECT_FALSE(traces(rcFinish)) << name;
  }
}

TEST_F(SceneTest, ASurfaceOfAnotherSizeIsTracedAnew) {
  rcFinish();
  surface.resize(32, 32);
  EXPECT_TRUE(traces(rcFinish));
}

TEST_F(SceneTest, FailedCallsTraceNothing) {
  rcFinish();
  rcViewport(0, 0, -1, 0);
  rcEnable(kNoToken);
  rcLightf(RC_LIGHT0, RC_SPOT_EXPONENT, -1);
  rcDrawArrays(RC_POINTS, 0, 3);
  EXPECT_EQ(rcGetError(), RCenum(RC_INVALID_VALUE));
  EXPECT_FALSE(traces(rcFinish));
}

TEST_F(SceneTest, RaysOfTheLastFrameAreCounted) {
  rcFinish();
  EXPECT_EQ(integer(RC_FRAME_RAYS), kWidth * kHeight);
  EXPECT_EQ(integer(RC_FRAME_TRIANGLES), 0);
  drawLeft();
  rcFinish();
  EXPECT_EQ(integer(RC_FRAME_RAYS), kWidth * kHeight);  // the default light asks for no shadow rays
  EXPECT_EQ(integer(RC_FRAME_TRIANGLES), 2);
}

TEST_F(SceneTest, DynamicGeometryLivesForOneFrame) {
  drawLeft();
  rcFinish();
  EXPECT_TRUE(left());
  context->endFrame();
  rcFinish();
  EXPECT_FALSE(left());
  EXPECT_EQ(integer(RC_FRAME_TRIANGLES), 0);
}

TEST_F(SceneTest, WhatIsSubmittedAfterFinishBeginsTheNextFrame) {
  drawLeft();
  rcFinish();
  EXPECT_TRUE(left());
  EXPECT_FALSE(right());
  drawRight();
  context->endFrame();  // the swap of the first frame keeps what belongs to the next
  rcFinish();
  EXPECT_FALSE(left());
  EXPECT_TRUE(right());
}

TEST_F(SceneTest, StaticGeometryLivesUntilItIsReplaced) {
  staticLeft();
  for (int frame = 0; frame < 3; ++frame) {
    drawRight();
    rcFinish();
    EXPECT_TRUE(left() && right()) << frame;
    context->endFrame();
  }
  rcFinish();
  EXPECT_TRUE(left());
  EXPECT_FALSE(right());
  rcStaticSceneBegin();
  drawRight();
  rcStaticSceneEnd();
  rcFinish();
  EXPECT_FALSE(left());
  EXPECT_TRUE(right());
}

TEST_F(SceneTest, AnEmptyStaticSceneReplacesToo) {
  staticLeft();
  rcStaticSceneBegin();
  rcStaticSceneEnd();
  rcFinish();
  EXPECT_FALSE(left());
  EXPECT_CLEAN();
}

TEST_F(SceneTest, DynamicGeometryBeforeTheStaticSceneStays) {
  drawRight();
  staticLeft();
  rcFinish();
  EXPECT_TRUE(left() && right());
}

TEST_F(SceneTest, ABeginWithoutEndIsAnErrorAndThereIsNoStaticScene) {
  for (const auto finish : {rcFinish, rcFlush}) {
    staticLeft();
    rcStaticSceneBegin();
    drawRight();
    EXPECT_CLEAN();
    finish();
    EXPECT_EQ(rcGetError(), RCenum(RC_INVALID_OPERATION));
    EXPECT_FALSE(left() || right());
    drawRight();  // dynamic again
    finish();
    EXPECT_CLEAN();
    EXPECT_TRUE(right());
    context->endFrame();
  }
}

TEST_F(SceneTest, AnEndWithoutBeginIsIgnored) {
  rcStaticSceneEnd();
  staticLeft();
  rcStaticSceneEnd();
  drawRight();
  rcStaticSceneEnd();
  EXPECT_CLEAN();
  rcFinish();
  EXPECT_TRUE(left() && right());
}

TEST_F(SceneTest, ASecondBeginBeginsAnew) {
  rcStaticSceneBegin();
  drawLeft();
  rcStaticSceneBegin();
  drawRight();
  rcStaticSceneEnd();
  rcFinish();
  EXPECT_CLEAN();
  EXPECT_FALSE(left());
  EXPECT_TRUE(right());
}

TEST_F(SceneTest, EveryKindOfCallWorksInsideTheStaticScene) {
  rcStaticSceneBegin();
  rcClear(RC_COLOR_BUFFER_BIT);
  rcMatrixMode(RC_MODELVIEW);
  rcLoadIdentity();
  rcTranslatef(0, 0, -1);
  rcEnable(RC_USE_TEXTURE_ONLY);
  RCuint name = 0;
  rcGenMaterials(1, &name);
  rcBindMaterial(name);
  drawLeft();
  rcDisable(RC_USE_TEXTURE_ONLY);
  rcStaticSceneEnd();
  rcFinish();
  EXPECT_CLEAN();
  EXPECT_TRUE(left());
}

TEST_F(SceneTest, ClearDropsNothingForAnyMask) {
  staticLeft();
  drawRight();
  for (RCbitfield mask : {0u, 0x4500u, 0xFFFFFFFFu}) rcClear(mask);
  EXPECT_CLEAN();
  rcFinish();
  EXPECT_TRUE(left() && right());
  rcClear(RC_COLOR_BUFFER_BIT);
  EXPECT_FALSE(traces(rcFinish));
}

TEST_F(SceneTest, SceneAllInitDropsGeometryAndBindsMaterial0) {
  staticLeft();
  drawRight();
  rcBindMaterial(3);
  rcBindTexture(RC_TEXTURE_2D, 4);
  rcEnable(RC_LIGHT2);
  rcTranslatef(1, 2, 3);
  const auto matrix = modelview();
  rcSceneAllInit();
  EXPECT_CLEAN();
  EXPECT_EQ(integer(RC_MATERIAL_BINDING), 0);
  EXPECT_EQ(integer(RC_TEXTURE_BINDING_2D), 0);
  EXPECT_TRUE(rcIsMaterial(3));
  EXPECT_TRUE(rcIsTexture(4));
  EXPECT_TRUE(rcIsEnabled(RC_LIGHT2));
  EXPECT_EQ(modelview(), matrix);
  rcFinish();
  EXPECT_FALSE(left() || right());
  EXPECT_EQ(integer(RC_FRAME_TRIANGLES), 0);
}

TEST_F(SceneTest, SceneAllInitKeepsValuesAndImages) {
  rcBindMaterial(3);
  rcEnable(RC_TEXTURE_2D);
  rcBindTexture(RC_TEXTURE_2D, 4);
  loadSolid({0, 90, 0});
  rcSceneAllInit();
  rcBindMaterial(3);
  rcEnable(RC_USE_TEXTURE_ONLY);
  drawTexturedQuad({0, 0, 64, 48});
  rcFinish();
  EXPECT_EQ(pixel(32, 24), (Colour{0, 90, 0}));
}

TEST_F(SceneTest, SceneAllInitEndsAnOpenStaticScene) {
  rcStaticSceneBegin();
  rcSceneAllInit();
  drawRight();
  rcFinish();
  EXPECT_CLEAN();
  EXPECT_TRUE(right());
}

TEST_F(SceneTest, TheNearerSurfaceIsSeen) {
  staticLeft();
  paint(1, 0, 0);
  drawQuad({0, 0, 64, 48}, -5);  // dynamic, farther
  rcFinish();
  EXPECT_TRUE(left());
  EXPECT_EQ(pixel(50, 24), (Colour{255, 0, 0}));
}

TEST_F(SceneTest, DepthBounceIsClamped) {
  EXPECT_EQ(integer(RC_DEPTH_BOUNCE), 10);
  for (const auto &[value, kept] : {std::pair{0u, 0}, {14u, 14}, {15u, 14}, {0xFFFFFFFFu, 14}}) {
    rcDepthBounce(value);
    EXPECT_EQ(integer(RC_DEPTH_BOUNCE), kept);
  }
  EXPECT_CLEAN();
  useProfile("1000");
  EXPECT_EQ(integer(RC_DEPTH_BOUNCE), 10);
  useProfile("mc");
  EXPECT_EQ(integer(RC_DEPTH_BOUNCE), 1);
}

TEST_F(SceneTest, SettingsOfTheSecondGenerationAreStored) {
  const auto &settings = context->state.pathTracing;
  EXPECT_EQ(settings.lightRadius, 100);
  EXPECT_EQ(settings.diffuseRate, 10u);
  EXPECT_EQ(settings.sampleCount, 8u);
  rcSetLightRadius(2.5f);
  rcSetDiffuseRate(3);
  rcSetSPPCount(32);
  EXPECT_CLEAN();
  EXPECT_EQ(settings.lightRadius, 2.5f);
  EXPECT_EQ(settings.diffuseRate, 3u);
  EXPECT_EQ(settings.sampleCount, 32u);
}

TEST_F(SceneTest, WithoutASurfaceFinishDoesNothing) {
  context->attach(nullptr);
  drawLeft();
  EXPECT_FALSE(traces(rcFinish));
  EXPECT_CLEAN();
  context->attach(&surface);
  rcFinish();
  EXPECT_TRUE(left());
}

}  // namespace
}  // namespace rc::test
