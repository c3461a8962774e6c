// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Normal maps: light falls as on a surface that is tilted by the computed angle. [reference 4.5]
#include "api/context_fixture.h"

namespace rc::test {
namespace {

class NormalMapTest : public ContextTest {
 protected:
  static constexpr Rect kAll{-100, -100, 164, 148};

  // Parallel rays onto a white wall whose map tilts its normal by `degrees` towards where s grows.
  void tilted(double degrees) {
    rcuLookAt(0, 0, 100, 0, 0, 0, 0, 1, 0);
    rcOrthof(0, kWidth, 0, kHeight, 0, 200);
    paintDiffuse(1, 1, 1);
    rcEnable(RC_TEXTURE_2D_NORMAL);
    rcBindTexture(RC_TEXTURE_2D_NORMAL, 3);
    loadNormal(std::sin(degrees * kRadians), 0, std::cos(degrees * kRadians));
  }
  void loadNormal(double x, double y, double z) {
    std::vector<RCubyte> texels;
    for (int i = 0; i < 16 * 16; ++i) {
      for (double value : {x, y, z}) texels.push_back(RCubyte(std::lround((value + 1) * 127.5)));
    }
    rcTexImage2D(RC_TEXTURE_2D_NORMAL, 0, RC_RGB, 16, 16, 0, RC_RGB, RC_UNSIGNED_BYTE, texels.data());
  }
  // Light from `degrees` off the wall's normal towards x; 90 degrees turned: towards y.
  void lightAt(double degrees, bool towardsY = false) {
    const auto across = float(std::sin(degrees * kRadians)), away = float(std::cos(degrees * kRadians));
    lightFrom(towardsY ? 0 : across, towardsY ? across : 0, away, 0, 1);
  }
  // A quad with these texture coordinates, counter-clockwise from the lower left corner.
  void draw(const std::vector<float> &coordinates, bool clockwise = false) {
    rcEnableClientState(RC_TEXTURE_COORD_ARRAY);
    rcTexCoordPointer(2, RC_FLOAT, 0, coordinates.data());
    clockwise ? drawClockwiseQuad(kAll) : drawQuad(kAll);
    rcDisableClientState(RC_TEXTURE_COORD_ARRAY);
    trace();
  }
  void expectShown(double brightness) {
    for (const auto &[x, y] : {std::pair{30, 20}, {5, 40}}) {  // either triangle
      EXPECT_NEAR(pixel(x, y)[0], std::min(255.0, 256 * brightness), 3) << x << ' ' << y;
    }
  }
  static double cosine(double degrees) { return std::max(std::cos(degrees * kRadians), 0.0); }

  static constexpr double kRadians = 0.017453292519943295;
  const std::vector<float> kUpright{0, 0, 1, 0, 1, 1, 0, 1};
};

TEST_F(NormalMapTest, TheFlatNormalIsNoChange) {
  tilted(0);
  lightAt(45);
  draw(kUpright);
  expectShown(cosine(45));
}

TEST_F(NormalMapTest, TiltsTowardsWhereTheCoordinateGrows) {
  for (double tilt : {45, 20, -30}) {
    tilted(tilt);
    lightAt(45);
    draw(kUpright);
    expectShown(cosine(45 - tilt));
  }
}

TEST_F(NormalMapTest, TheSecondCoordinateTiltsUpwards) {
  tilted(0);
  loadNormal(0, std::sqrt(0.5), std::sqrt(0.5));
  lightAt(30, true);
  draw(kUpright);
  expectShown(cosine(15));
}

TEST_F(NormalMapTest, TurnsWithTheCoordinates) {
  tilted(45);
  const std::vector<float> turned{0, 0, 0, -1, 1, -1, 1, 0};  // s grows upwards
  lightAt(45, true);
  draw(turned);
  expectShown(1);
  lightAt(45);
  draw(turned);
  expectShown(0.5);
}

TEST_F(NormalMapTest, TurnsWithMirroredCoordinates) {
  tilted(30);
  lightAt(45);
  draw({1, 0, 0, 0, 0, 1, 1, 1});  // s grows to the left
  expectShown(cosine(75));
}

TEST_F(NormalMapTest, IsTheSameAtAnyScale) {
  tilted(30);
  lightAt(45);
  draw({0, 0, 50, 0, 50, 0.1f, 0, 0.1f});
  expectShown(cosine(15));
}

TEST_F(NormalMapTest, TurnsWithTheTextureMatrix) {
  tilted(30);
  lightAt(45);
  rcMatrixMode(RC_TEXTURE);
  rcScalef(-1, 1, 1);
  draw(kUpright);
  expectShown(cosine(75));
}

TEST_F(NormalMapTest, TurnsWithTheModel) {
  tilted(30);
  lightAt(45, true);
  rcRotatef(90, 0, 0, 1);  // what grew to the right grows upwards
  draw(kUpright);
  expectShown(cosine(15));
}

// The back shows what the front would: the bump sinks where it stood.
TEST_F(NormalMapTest, BothSidesAreTilted) {
  tilted(30);
  lightAt(45);
  draw(kUpright, true);  // s grows to the left, and the eye sees the back
  expectShown(cosine(15));
}

// A model that is drawn mirrored, with the front on the other side as its triangles are, shows the mirrored picture.
TEST_F(NormalMapTest, MirroredModelsAreMirrored) {
  tilted(30);
  lightAt(-45);
  rcScalef(-1, 1, 1);
  rcFrontFace(RC_CW);
  draw(kUpright);  // s grows to the left
  expectShown(cosine(15));
}

TEST_F(NormalMapTest, CoordinatesThatSpanNothingLeaveTheFlatNormal) {
  tilted(30);
  lightAt(45);
  for (const std::vector<float> &coordinates : {std::vector<float>(8, 0.5f), {0, 0, 1, 0, 1, 0, 0, 0}}) {
    draw(coordinates);
    expectShown(cosine(45));
  }
  drawQuad(kAll);  // none at all
  trace();
  expectShown(cosine(45));
}

TEST_F(NormalMapTest, TiltsTheHighlight) {
  tilted(22.5);
  paintDiffuse(0, 0, 0);
  lightAt(45);
  const float white[] = {1, 1, 1, 0};
  rcLightfv(RC_LIGHT0, RC_SPECULAR, white);
  rcMaterialfv(RC_FRONT_AND_BACK, RC_SPECULAR, white);
  rcMaterialf(RC_FRONT_AND_BACK, RC_SHININESS, 200);
  draw(kUpright);
  EXPECT_NEAR(pixel(30, 20)[0], 256 * cosine(22.5), 4) << "the light is mirrored into the eye";
  rcDisable(RC_TEXTURE_2D_NORMAL);
  draw(kUpright);
  EXPECT_EQ(pixel(30, 20), kBlack);
}

TEST_F(NormalMapTest, TiltsTheMirror) {
  tilted(10);
  rcMaterialf(RC_FRONT_AND_BACK, RC_REFLECTION, 1);
  rcBindMaterial(1);
  rcDisable(RC_TEXTURE_2D_NORMAL);
  rcMaterialf(RC_FRONT_AND_BACK, RC_REFLECTION, 0);
  paint(0, 1, 0);
  lightFrom(0, 0, 1, 0, 0);
  const float white[] = {1, 1, 1, 1};
  rcLightModelfv(RC_LIGHT_MODEL_AMBIENT, white);
  // A ray at x comes back at x + 300 tan 20 degrees = x + 109.2.
  drawQuad({134.2f, -500, 144.2f, 500}, 300);
  rcBindMaterial(0);
  draw(kUpright);
  EXPECT_EQ(pixel(30, 20), (Colour{0, 255, 0}));
  EXPECT_EQ(pixel(21, 20), kBlack);
  EXPECT_EQ(pixel(39, 20), kBlack);
}

TEST_F(NormalMapTest, ColourMapAndNormalMapActTogether) {
  tilted(45);
  lightAt(45);
  rcEnable(RC_TEXTURE_2D);
  rcBindTexture(RC_TEXTURE_2D, 4);
  loadColumns({200, 0, 0}, {0, 100, 0});
  draw({0, 0, 2, 0, 2, 2, 0, 2});  // 132 units a repetition from x = -100
  EXPECT_NEAR(pixel(5, 20)[1], 256 * 100 / 255.0, 3);
  EXPECT_NEAR(pixel(50, 20)[0], 256 * 200 / 255.0, 3);
}

}  // namespace
}  // namespace rc::test
