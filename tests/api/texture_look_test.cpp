// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Textures: how they look. [spec 3.4]
#include "api/texture_fixture.h"

namespace rc::test {
namespace {

TEST_F(TextureTest, EveryFormatAndType) {
  textureOnly();
  using Bytes3 = std::array<RCubyte, 3>;
  using Bytes4 = std::array<RCubyte, 4>;
  for (RCenum type : {RC_BYTE, RC_UNSIGNED_BYTE}) {
    loadTexels(RC_RGB, RCenum(type), Bytes3{10, 128, 250});
    EXPECT_EQ(shown(), (Colour{10, 128, 250}));
    loadTexels(RC_RGBA, RCenum(type), Bytes4{20, 129, 240, 255});
    EXPECT_EQ(shown(), (Colour{20, 129, 240}));
  }
  for (RCenum type : {RC_SHORT, RC_UNSIGNED_SHORT, RC_UNSIGNED_SHORT_5_6_5}) {
    loadTexels<RCushort>(RC_RGB, RCenum(type), 31 << 11 | 0 << 5 | 31);
    EXPECT_EQ(shown(), (Colour{255, 0, 255}));
    loadTexels<RCushort>(RC_RGB, RCenum(type), 63 << 5);
    EXPECT_EQ(shown(), (Colour{0, 255, 0}));
  }
  loadTexels<RCushort>(RC_RGBA, RC_UNSIGNED_SHORT_4_4_4_4, 0xF08F);
  EXPECT_EQ(shown(), (Colour{255, 0, 136}));
  loadTexels<RCushort>(RC_RGBA, RC_UNSIGNED_SHORT_5_5_5_1, 31 << 6 | 1);
  EXPECT_EQ(shown(), (Colour{0, 255, 0}));
  EXPECT_CLEAN();
}

TEST_F(TextureTest, TheFirstRowIsAtTheBottom) {
  textureOnly();
  std::vector<RCubyte> texels(16 * 16 * 3, 0);
  for (size_t i = 0; i < 8 * 16; ++i) texels[3 * i] = 200;  // rows 0 ... 7 are red
  for (size_t i = 8 * 16; i < 16 * 16; ++i) texels[3 * i + 2] = 200;
  rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGB, 16, 16, 0, RC_RGB, RC_UNSIGNED_BYTE, texels.data());
  drawTexturedQuad({8, 8, 40, 40});
  rcFinish();
  EXPECT_EQ(pixel(24, 14), kRed);
  EXPECT_EQ(pixel(24, 34), kBlue);
}

TEST_F(TextureTest, RowsAreTightAndColumnsGoRight) {
  textureOnly();
  loadColumns(kRed, kBlue);
  drawTexturedQuad({8, 8, 40, 40});
  rcFinish();
  EXPECT_EQ(pixel(14, 24), kRed);
  EXPECT_EQ(pixel(34, 24), kBlue);
}

TEST_F(TextureTest, FilteringIsBilinear) {
  textureOnly();
  loadColumns({0, 0, 0}, {200, 200, 200});
  drawTexturedQuad({8, 8, 40, 40});
  rcFinish();
  EXPECT_NEAR(pixel(24, 24)[0], 100, 1);  // between the columns 7 and 8
}

TEST_F(TextureTest, ATexelReplacesAmbientAndDiffuse) {
  pixelCamera();
  rcBindTexture(RC_TEXTURE_2D, 1);
  rcEnable(RC_TEXTURE_2D);
  loadSolid({100, 50, 200});
  for (float level : {0.0f, 1.0f}) {
    const float colour[] = {level, level, level};
    rcMaterialfv(RC_FRONT_AND_BACK, RC_AMBIENT_AND_DIFFUSE, colour);
    EXPECT_EQ(shown(), (Colour{110, 55, 220}));  // 1.1 * 256 / 255 of the texel
  }
  rcDisable(RC_TEXTURE_2D);
  paint(0.5f, 0.5f, 0.5f);
  EXPECT_EQ(shown(), (Colour{128, 128, 128}));
}

// As in GL, texture 0 is a texture like others and is the current one from the start.
TEST_F(TextureTest, Texture0NeedsNoBinding) {
  pixelCamera();
  rcEnable(RC_TEXTURE_2D);
  rcEnable(RC_USE_TEXTURE_ONLY);
  loadSolid(kRed);
  EXPECT_EQ(shown(), kRed);
}

TEST_F(TextureTest, WithoutAnImageTheMaterialShows) {
  pixelCamera();
  rcEnable(RC_TEXTURE_2D);
  rcBindTexture(RC_TEXTURE_2D, 5);
  paint(0.5f, 0.25f, 0);
  EXPECT_EQ(shown(), (Colour{128, 64, 0}));
}

// opacity = min(alpha / 16, 1)
TEST_F(TextureTest, OpacityOfRgbTexelsIsTheTextureAlphaAtLoad) {
  textureOnly();
  rcClearColor(0, 0, 0.5f, 0);
  const struct {
    int alpha;
    Colour expected;
  } cases[] = {{0, {0, 0, 128}}, {4, {50, 0, 96}}, {8, {100, 0, 64}}, {16, kRed}, {17, kRed}, {255, kRed}};
  EXPECT_EQ((loadSolid(kRed), shown()), kRed);  // 16 initially
  for (const auto &[alpha, expected] : cases) {
    rcTextureAlpha(static_cast<RCubyte>(alpha));
    loadSolid(kRed);
    rcTextureAlpha(3);  // no longer matters
    const Colour colour = shown();
    for (size_t i = 0; i < 3; ++i) EXPECT_NEAR(colour[i], expected[i], 1) << "alpha " << alpha;
  }
}

TEST_F(TextureTest, RgbaTexelsKeepTheirAlpha) {
  textureOnly();
  rcTextureAlpha(0);
  loadTexels(RC_RGBA, RC_UNSIGNED_BYTE, std::array<RCubyte, 4>{200, 0, 0, 16});
  EXPECT_EQ(shown(), kRed);
  loadTexels(RC_RGBA, RC_UNSIGNED_BYTE, std::array<RCubyte, 4>{200, 0, 0, 0});
  EXPECT_EQ(shown(), kBlack);
  rcTexParameteri(RC_TEXTURE_2D, RC_TEXTURE_OPAQUE_ALPHA, 255);
  loadTexels(RC_RGBA, RC_UNSIGNED_BYTE, std::array<RCubyte, 4>{200, 0, 0, 51});
  EXPECT_NEAR(shown()[0], 40, 1);
}

TEST_F(TextureTest, ThroughATransparentTexelOneSeesWhatIsBehind) {
  textureOnly();
  rcBindMaterial(1);
  rcDisable(RC_TEXTURE_2D);
  paint(0, 1, 0);
  drawQuad({0, 0, 64, 48}, -10);
  rcBindMaterial(0);
  rcTextureAlpha(0);
  loadSolid(kRed);
  EXPECT_EQ(shown(), (Colour{0, 255, 0}));
}

TEST_F(TextureTest, WrapModes) {
  textureOnly();
  loadColumns(kRed, kBlue);
  const struct {
    RCint wrap;
    Colour at125, at175;
  } cases[] = {{RC_REPEAT, kRed, kBlue}, {RC_CLAMP_TO_EDGE, kBlue, kBlue}, {RC_MIRRORED_REPEAT, kBlue, kRed}};
  for (const auto &[wrap, at125, at175] : cases) {
    rcTexParameteri(RC_TEXTURE_2D, RC_TEXTURE_WRAP_S, wrap);
    drawTexturedQuad({8, 8, 48, 40}, 2, 1);  // 20 pixels a unit
    rcFinish();
    EXPECT_EQ(pixel(33, 24), at125) << wrap;
    EXPECT_EQ(pixel(43, 24), at175) << wrap;
  }
}

TEST_F(TextureTest, WrapIsTheMaterialsIfSetWhileItWasBound) {
  textureOnly();
  rcBindTexture(RC_TEXTURE_2D, 1);
  loadColumns(kRed, kBlue);
  rcBindMaterial(1);  // a copy: the same texture
  rcTexParameteri(RC_TEXTURE_2D, RC_TEXTURE_WRAP_S, RC_CLAMP_TO_EDGE);
  rcBindMaterial(0);
  rcTexParameteri(RC_TEXTURE_2D, RC_TEXTURE_WRAP_S, RC_MIRRORED_REPEAT);
  EXPECT_EQ(texParameter(RC_TEXTURE_WRAP_S), RC_MIRRORED_REPEAT);
  drawTexturedQuad({8, 4, 48, 20}, 2, 1);
  rcBindMaterial(1);
  EXPECT_EQ(texParameter(RC_TEXTURE_WRAP_S), RC_CLAMP_TO_EDGE);
  drawTexturedQuad({8, 24, 48, 40}, 2, 1);
  rcFinish();
  EXPECT_EQ(pixel(43, 10), kRed);   // the texture's
  EXPECT_EQ(pixel(43, 30), kBlue);  // the material's
}

TEST_F(TextureTest, AMaterialKeepsADeletedTexture) {
  textureOnly();
  rcBindMaterial(1);
  const RCuint name = 3;
  rcBindTexture(RC_TEXTURE_2D, name);
  loadSolid(kRed);
  rcDeleteTextures(1, &name);
  EXPECT_EQ(integer(RC_TEXTURE_BINDING_2D), 0);
  loadSolid(kBlue);  // goes to texture 0
  EXPECT_EQ(shown(), kRed);
}

TEST_F(TextureTest, WithoutAMaterialADeletedTextureGivesWayToTexture0) {
  textureOnly();
  const RCuint names[] = {3, 4};
  rcBindTexture(RC_TEXTURE_2D, 0);
  loadSolid(kBlue);
  rcBindTexture(RC_TEXTURE_2D, names[0]);
  loadSolid(kRed);
  rcDeleteTextures(1, &names[1]);
  EXPECT_EQ(shown(), kRed);
  rcDeleteTextures(1, &names[0]);
  EXPECT_EQ(shown(), kBlue);
}

// Pixels are sampled at their corners, where whole numbers make triangles meet.
TEST_F(TextureTest, WhereManyTrianglesMeetASurfaceCountsOnce) {
  std::vector<float> fan;
  const int around[][2] = {{8, 0}, {8, 8}, {0, 8}, {-8, 8}, {-8, 0}, {-8, -8}, {0, -8}, {8, -8}, {8, 0}};
  for (size_t i = 0; i < 8; ++i) {
    for (const auto &[x, y] : {std::pair{0, 0}, {around[i][0], around[i][1]}, {around[i + 1][0], around[i + 1][1]}}) {
      fan.insert(fan.end(), {32.0f + float(x), 24.0f + float(y), 0});
    }
  }
  for (const char *device : {"cpu", "ref"}) {
    for (AccelKind accel : {AccelKind::Bvh, AccelKind::KdTree, AccelKind::Exhaustive}) {
      Settings settings;
      settings.device = device;
      settings.accel = accel;
      useSettings(settings);
      textureOnly();
      rcTexParameteri(RC_TEXTURE_2D, RC_TEXTURE_OPAQUE_ALPHA, 200);
      loadRgba(200, 200, 200, 100);
      drawTriangles(fan);
      trace();
      for (const auto &[x, y] : {std::pair{32, 24}, {35, 24}, {32, 20}, {29, 27}, {34, 25}}) {
        EXPECT_EQ(pixel(x, y), (Colour{100, 100, 100})) << device << ' ' << int(accel) << ' ' << x << ' ' << y;
      }
    }
  }
}

TEST_F(TextureTest, ReloadingIsSeenByWhatWasDrawnInTheStaticScene) {
  textureOnly();
  rcBindMaterial(1);
  loadSolid(kRed);
  rcStaticSceneBegin();
  drawTexturedQuad({8, 8, 40, 40});
  rcStaticSceneEnd();
  rcFinish();
  EXPECT_EQ(pixel(24, 24), kRed);
  loadSolid(kBlue);
  rcFinish();
  EXPECT_EQ(pixel(24, 24), kBlue);
}

}  // namespace
}  // namespace rc::test
