// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// What materials look like: which draw has which, emission, reflection, transmittance, highlights. [spec 3.5, 5]
#include "api/context_fixture.h"

namespace rc::test {
namespace {

using MaterialLookTest = ContextTest;

TEST_F(MaterialLookTest, TheValuesOfMaterial0AreCapturedByEachDraw) {
  pixelCamera();
  paint(1, 0, 0);
  drawQuad({0, 0, 20, 48});
  paint(0, 1, 0);
  drawQuad({20, 0, 40, 48});
  paint(1, 0, 0);
  drawQuad({40, 0, 64, 48});
  paint(0, 0, 1);
  rcFinish();
  EXPECT_EQ(pixel(10, 24), (Colour{255, 0, 0}));
  EXPECT_EQ(pixel(30, 24), (Colour{0, 255, 0}));
  EXPECT_EQ(pixel(50, 24), (Colour{255, 0, 0}));
}

TEST_F(MaterialLookTest, NamedMaterialsAreByReference) {
  pixelCamera();
  rcBindMaterial(1);
  paint(1, 0, 0);
  drawQuad({0, 0, 20, 48});
  paint(0, 1, 0);
  drawQuad({20, 0, 40, 48});
  rcFinish();
  EXPECT_EQ(pixel(10, 24), (Colour{0, 255, 0}));
  EXPECT_EQ(pixel(30, 24), (Colour{0, 255, 0}));
}

TEST_F(MaterialLookTest, StaticGeometryFollowsItsMaterial) {
  pixelCamera();
  rcBindMaterial(1);
  paint(1, 0, 0);
  rcStaticSceneBegin();
  drawQuad({0, 0, 64, 48});
  rcStaticSceneEnd();
  rcFinish();
  EXPECT_EQ(pixel(32, 24), (Colour{255, 0, 0}));
  paint(0, 0.5f, 0);
  rcFinish();
  EXPECT_EQ(pixel(32, 24), (Colour{0, 128, 0}));
}

TEST_F(MaterialLookTest, EmissionIsAdded) {
  pixelCamera();
  paint(0.25f, 0, 0);
  const float glow[] = {0.25f, 0.5f, 0};
  rcMaterialfv(RC_FRONT_AND_BACK, RC_EMISSION, glow);
  drawQuad({0, 0, 64, 48});
  rcFinish();
  EXPECT_EQ(pixel(32, 24), (Colour{128, 128, 0}));
}

TEST_F(MaterialLookTest, ReflectionIsPerChannel) {
  pixelCamera();
  rcClearColor(1, 1, 1, 0);
  paint(0, 0, 0);
  const float mirror[] = {0.5f, 0.25f, 1};
  rcMaterialfv(RC_FRONT_AND_BACK, RC_REFLECTION, mirror);
  drawQuad({0, 0, 64, 48});
  rcFinish();
  EXPECT_EQ(pixel(32, 24), (Colour{128, 64, 255}));  // a mirror shows the clear colour
}

TEST_F(MaterialLookTest, TransmittanceMixesWithWhatIsBehind) {
  pixelCamera();
  rcClearColor(0, 0, 1, 0);
  paint(1, 0, 0);
  rcMaterialf(RC_FRONT_AND_BACK, RC_TRANSMITTANCE, 0.25f);
  drawQuad({0, 0, 64, 48});
  rcFinish();
  EXPECT_EQ(pixel(32, 24), (Colour{192, 0, 64}));
}

TEST_F(MaterialLookTest, ARefractionIndexOf0BendsNothing) {
  rcMaterialf(RC_FRONT_AND_BACK, RC_REFRACTION_INDEX, 0);
  EXPECT_CLEAN();
  pixelCamera();
  paint(0, 1, 0);
  drawQuad({10, 10, 20, 20}, -200);
  paint(0, 0, 0);
  rcMaterialf(RC_FRONT_AND_BACK, RC_TRANSMITTANCE, 1);
  drawQuad({-10, -10, 80, 60});
  rcFinish();
  const auto through = surface.pixels;
  rcSceneAllInit();
  rcMaterialf(RC_FRONT_AND_BACK, RC_TRANSMITTANCE, 0);
  paint(0, 1, 0);
  drawQuad({10, 10, 20, 20}, -200);
  rcFinish();
  EXPECT_EQ(through, surface.pixels);
  EXPECT_NE(through, std::vector<uint32_t>(through.size(), through[0]));
}

TEST_F(MaterialLookTest, SharesAbove1AreScaledDownWithoutError) {
  pixelCamera();
  rcClearColor(0.5f, 0.5f, 0.5f, 0);
  paint(1, 1, 1);
  rcMaterialf(RC_FRONT_AND_BACK, RC_REFLECTION, 1);
  rcMaterialf(RC_FRONT_AND_BACK, RC_TRANSMITTANCE, 1);
  EXPECT_CLEAN();
  EXPECT_EQ(materialScalar(RC_REFLECTION), 1);
  drawQuad({0, 0, 64, 48});
  rcFinish();
  EXPECT_EQ(pixel(32, 24), (Colour{128, 128, 128}));
}

TEST_F(MaterialLookTest, AtTheLastBounceASurfaceShowsItsOwnColour) {
  pixelCamera();
  paint(0.5f, 0, 0);
  rcMaterialf(RC_FRONT_AND_BACK, RC_REFLECTION, 1);
  rcDepthBounce(0);
  drawQuad({0, 0, 64, 48});
  rcFinish();
  EXPECT_EQ(pixel(32, 24), (Colour{128, 0, 0}));
}

TEST_F(MaterialLookTest, TheHighlightIsScaledByTheLevel) {
  pixelCamera();
  paint(0, 0, 0);
  const float white[] = {1, 1, 1}, black[] = {0, 0, 0};
  rcMaterialfv(RC_FRONT_AND_BACK, RC_SPECULAR, white);
  rcEnable(RC_LIGHTING);
  rcEnable(RC_LIGHT0);
  rcLightfv(RC_LIGHT0, RC_DIFFUSE, black);
  rcLightfv(RC_LIGHT0, RC_SPECULAR, white);
  rcMaterialf(RC_FRONT_AND_BACK, RC_SHININESS, 10);
  for (float level : {0.0f, 0.5f, 0.25f}) {
    rcMaterialf(RC_FRONT_AND_BACK, RC_SPECULAR_LEVEL, level);
    drawQuad({0, 0, 64, 48});
    rcFinish();
    EXPECT_NEAR(pixel(32, 24)[0], 256 * level, 1);  // seen along the mirror direction
  }
}

}  // namespace
}  // namespace rc::test
