// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Textures: names, loading, parameters, and how they look. [spec 3.4]
#include "api/context_fixture.h"

namespace rc::test {
namespace {

class TextureTest : public ContextTest {
 protected:
  // The bound material shows its texture unlit: exactly the texels.
  void textureOnly() {
    pixelCamera();
    rcBindTexture(RC_TEXTURE_2D, 9);
    rcEnable(RC_TEXTURE_2D);
    rcEnable(RC_USE_TEXTURE_ONLY);
  }

  void load(RCsizei width, RCsizei height, RCenum format = RC_RGB, RCenum type = RC_UNSIGNED_BYTE) {
    const std::vector<RCubyte> texels(size_t(width) * size_t(height) * 4, 100);
    rcTexImage2D(RC_TEXTURE_2D, 0, RCint(format), width, height, 0, format, type, texels.data());
  }

  // All texels the same, as they lie in memory.
  template <class Texel>
  void loadTexels(RCenum format, RCenum type, const Texel &texel) {
    const std::vector<Texel> texels(16 * 16, texel);
    rcTexImage2D(RC_TEXTURE_2D, 0, RCint(format), 16, 16, 0, format, type, texels.data());
  }

  Colour shown() {
    drawTexturedQuad({8, 8, 40, 40});
    rcFinish();
    return pixel(26, 20);  // not on the diagonal
  }
};

TEST_F(TextureTest, InitialState) {
  EXPECT_EQ(integer(RC_TEXTURE_BINDING_2D), 0);
  EXPECT_EQ(integer(RC_MAX_TEXTURE_SIZE), 1024);
  EXPECT_EQ(integer(RC_MAX_TEXTURE_UNITS), 1);
  EXPECT_EQ(integer(RC_MAX_TEXTURE_MAX_ANISOTROPY_EXT), 16);
  for (RCenum target : {RC_TEXTURE_2D, RC_TEXTURE_2D_NORMAL}) {
    EXPECT_FALSE(rcIsEnabled(RCenum(target)));
    EXPECT_EQ(texParameter(RC_TEXTURE_WRAP_S, RCenum(target)), RC_REPEAT);
    EXPECT_EQ(texParameter(RC_TEXTURE_WRAP_T, RCenum(target)), RC_REPEAT);
    EXPECT_EQ(texParameter(RC_GENERATE_MIPMAP, RCenum(target)), RC_TRUE);
    EXPECT_EQ(texParameter(RC_TEXTURE_OPAQUE_ALPHA, RCenum(target)), 16);
    EXPECT_EQ(texParameter(RC_TEXTURE_MAX_ANISOTROPY_EXT, RCenum(target)), 1);
  }
  EXPECT_TRUE(rcIsTexture(0));
  EXPECT_FALSE(rcIsTexture(1));
}

TEST_F(TextureTest, NamesAreTheLowestFreeOnes) {
  RCuint names[3] = {};
  rcGenTextures(3, names);
  EXPECT_EQ(names[0], 1u);
  EXPECT_EQ(names[2], 3u);
  EXPECT_TRUE(rcIsTexture(2));
  rcDeleteTextures(1, &names[1]);
  EXPECT_FALSE(rcIsTexture(2));
  rcBindTexture(RC_TEXTURE_2D, 4);  // made by binding
  EXPECT_TRUE(rcIsTexture(4));
  rcGenTextures(2, names);
  EXPECT_EQ(names[0], 2u);
  EXPECT_EQ(names[1], 5u);
  rcGenTextures(0, nullptr);
  EXPECT_CLEAN();
}

TEST_F(TextureTest, DeletingIgnoresZeroAndUnknownNames) {
  const RCuint names[] = {0, 77, 0xFFFFFFFF};
  rcDeleteTextures(3, names);
  EXPECT_TRUE(rcIsTexture(0));
  EXPECT_CLEAN();
  rcBindTexture(RC_TEXTURE_2D, 0xFFFFFFFF);
  EXPECT_EQ(rcIsTexture(0xFFFFFFFF), RC_TRUE);
  rcDeleteTextures(1, &names[2]);
  EXPECT_EQ(integer(RC_TEXTURE_BINDING_2D), 0);  // the current one gives way to 0
}

TEST_F(TextureTest, NameErrors) {
  RCuint names[1] = {9};
  EXPECT_RAISES(RC_INVALID_VALUE, rcGenTextures(-1, names));
  EXPECT_RAISES(RC_INVALID_VALUE, rcDeleteTextures(-1, names));
  EXPECT_RAISES(RC_INVALID_ENUM, rcBindTexture(kNoToken, 1));
  EXPECT_RAISES(RC_INVALID_ENUM, rcBindTexture(RC_TEXTURE, 1));
  EXPECT_EQ(names[0], 9u);
}

TEST_F(TextureTest, SidesArePowersOfTwoFrom16To1024) {
  textureOnly();
  loadSolid(kRed);
  for (RCsizei bad : {-16, 0, 1, 8, 15, 17, 24, 100, 1000, 1023, 2048}) {
    const std::vector<RCubyte> texels(2048 * 16 * 3, 7);
    const auto tryLoad = [&](RCsizei w, RCsizei h) {
      rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGB, w, h, 0, RC_RGB, RC_UNSIGNED_BYTE, texels.data());
    };
    EXPECT_RAISES(RC_INVALID_VALUE, tryLoad(bad, 16));
    EXPECT_RAISES(RC_INVALID_VALUE, tryLoad(16, bad));
  }
  EXPECT_EQ(shown(), kRed);  // the old image stays
  for (RCsizei good : {16, 32, 1024}) {
    load(good, 16);
    load(16, good);
    EXPECT_CLEAN();
  }
  EXPECT_EQ(shown(), (Colour{100, 100, 100}));
}

TEST_F(TextureTest, LargeTexturesAreAskedFor) {
  rcEnable(RC_LARGE_TEXTURES);
  EXPECT_EQ(integer(RC_MAX_TEXTURE_SIZE), 16384);
  load(2048, 16);
  load(16, 16384);
  EXPECT_CLEAN();
  EXPECT_RAISES(RC_INVALID_VALUE, load(17, 16));
  rcDisable(RC_LARGE_TEXTURES);
  EXPECT_RAISES(RC_INVALID_VALUE, load(2048, 16));
}

TEST_F(TextureTest, ImageErrors) {
  textureOnly();
  loadSolid(kRed);
  const std::vector<RCubyte> texels(16 * 16 * 4, 9);
  const auto image = [&](RCenum target, RCint level, RCenum internal, RCint border, RCenum format, RCenum type) {
    rcTexImage2D(target, level, RCint(internal), 16, 16, border, format, type, texels.data());
  };
  EXPECT_RAISES(RC_INVALID_ENUM, image(kNoToken, 0, RC_RGB, 0, RC_RGB, RC_UNSIGNED_BYTE));
  EXPECT_RAISES(RC_INVALID_ENUM, image(RC_TEXTURE_2D, 0, RC_RGB, 0, RC_LUMINANCE, RC_UNSIGNED_BYTE));
  EXPECT_RAISES(RC_INVALID_ENUM, image(RC_TEXTURE_2D, 0, RC_ALPHA, 0, RC_RGB, RC_UNSIGNED_BYTE));
  EXPECT_RAISES(RC_INVALID_ENUM, image(RC_TEXTURE_2D, 0, 3, 0, RC_RGB, RC_UNSIGNED_BYTE));
  EXPECT_RAISES(RC_INVALID_OPERATION, image(RC_TEXTURE_2D, 0, RC_RGBA, 0, RC_RGB, RC_UNSIGNED_BYTE));
  EXPECT_RAISES(RC_INVALID_OPERATION, image(RC_TEXTURE_2D, 0, RC_RGB, 0, RC_RGBA, RC_UNSIGNED_BYTE));
  for (RCint level : {-1, 1, 5}) {
    EXPECT_RAISES(RC_INVALID_VALUE, image(RC_TEXTURE_2D, level, RC_RGB, 0, RC_RGB, RC_UNSIGNED_BYTE));
  }
  EXPECT_RAISES(RC_INVALID_VALUE, image(RC_TEXTURE_2D, 0, RC_RGB, 1, RC_RGB, RC_UNSIGNED_BYTE));
  EXPECT_RAISES(RC_INVALID_ENUM, image(RC_TEXTURE_2D, 0, RC_RGB, 0, RC_RGB, RC_FLOAT));
  EXPECT_RAISES(RC_INVALID_ENUM, image(RC_TEXTURE_2D, 0, RC_RGB, 0, RC_RGB, kNoToken));
  EXPECT_RAISES(RC_INVALID_ENUM, image(RC_TEXTURE_2D, 0, RC_RGBA, 0, RC_RGBA, RC_SHORT));
  EXPECT_RAISES(RC_INVALID_ENUM, image(RC_TEXTURE_2D, 0, RC_RGBA, 0, RC_RGBA, RC_UNSIGNED_SHORT));
  EXPECT_RAISES(RC_INVALID_ENUM, image(RC_TEXTURE_2D, 0, RC_RGBA, 0, RC_RGBA, RC_UNSIGNED_SHORT_5_6_5));
  EXPECT_RAISES(RC_INVALID_ENUM, image(RC_TEXTURE_2D, 0, RC_RGB, 0, RC_RGB, RC_UNSIGNED_SHORT_4_4_4_4));
  EXPECT_EQ(shown(), kRed);
}

TEST_F(TextureTest, NullPixelsLoadNothingWithoutError) {
  textureOnly();
  loadSolid(kRed);
  rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGB, 32, 32, 0, RC_RGB, RC_UNSIGNED_BYTE, nullptr);
  rcTexImage2D(RC_TEXTURE_2D, 3, RC_RGB, 17, 32, 1, RC_RGB, RC_UNSIGNED_BYTE, nullptr);
  EXPECT_CLEAN();
  EXPECT_EQ(shown(), kRed);
}

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

TEST_F(TextureTest, ParametersAreKept) {
  const struct {
    RCenum pname;
    RCint value;
  } cases[] = {{RC_TEXTURE_WRAP_S, RC_CLAMP_TO_EDGE}, {RC_TEXTURE_WRAP_T, RC_MIRRORED_REPEAT},
               {RC_TEXTURE_MIN_FILTER, RC_NEAREST},   {RC_TEXTURE_MAG_FILTER, RC_LINEAR_MIPMAP_NEAREST},
               {RC_TEXTURE_MIN_FILTER, 12345},        {RC_GENERATE_MIPMAP, RC_FALSE},
               {RC_TEXTURE_OPAQUE_ALPHA, 255},        {RC_TEXTURE_OPAQUE_ALPHA, 1},
               {RC_TEXTURE_MAX_ANISOTROPY_EXT, 2},    {RC_TEXTURE_MAX_ANISOTROPY_EXT, 16}};
  for (const auto &[pname, value] : cases) {
    const RCfloat f = static_cast<RCfloat>(value);
    for (int way = 0; way < 6; ++way) {
      useProfile("guide");
      if (way == 0) rcTexParameteri(RC_TEXTURE_2D, pname, value);
      if (way == 1) rcTexParameterf(RC_TEXTURE_2D, pname, f);
      if (way == 2) rcTexParameterx(RC_TEXTURE_2D, pname, value);
      if (way == 3) rcTexParameteriv(RC_TEXTURE_2D, pname, &value);
      if (way == 4) rcTexParameterfv(RC_TEXTURE_2D, pname, &f);
      if (way == 5) rcTexParameterxv(RC_TEXTURE_2D, pname, &value);
      EXPECT_CLEAN();
      EXPECT_EQ(texParameter(pname), value);
      RCfloat floatBack[4] = {};
      rcGetTexParameterfv(RC_TEXTURE_2D, pname, floatBack);
      EXPECT_EQ(floatBack[0], f);
      RCfixed fixedBack[4] = {};
      rcGetTexParameterxv(RC_TEXTURE_2D, pname, fixedBack);
      EXPECT_EQ(fixedBack[0], value);  // the plain integer
    }
  }
}

TEST_F(TextureTest, ParameterErrors) {
  RCint integers[4] = {RC_REPEAT};
  RCfloat reals[4] = {RC_REPEAT};
  const auto all = [&](RCenum target, RCenum pname, RCint value) {
    const RCfloat f = static_cast<RCfloat>(value);
    EXPECT_RAISES(RC_INVALID_ENUM, rcTexParameteri(target, pname, value));
    EXPECT_RAISES(RC_INVALID_ENUM, rcTexParameterf(target, pname, f));
    EXPECT_RAISES(RC_INVALID_ENUM, rcTexParameterx(target, pname, value));
    EXPECT_RAISES(RC_INVALID_ENUM, rcTexParameteriv(target, pname, &value));
    EXPECT_RAISES(RC_INVALID_ENUM, rcTexParameterfv(target, pname, &f));
    EXPECT_RAISES(RC_INVALID_ENUM, rcTexParameterxv(target, pname, &value));
  };
  all(kNoToken, RC_TEXTURE_WRAP_S, RC_REPEAT);
  all(RC_TEXTURE_2D, kNoToken, RC_REPEAT);
  all(RC_TEXTURE_2D, RC_TEXTURE_WRAP_S, RC_LINEAR);
  all(RC_TEXTURE_2D_NORMAL, RC_TEXTURE_WRAP_T, 0);
  for (const auto &[target, pname] :
       {std::pair<RCenum, RCenum>{kNoToken, RC_TEXTURE_WRAP_S}, {RC_TEXTURE_2D, kNoToken}}) {
    EXPECT_RAISES(RC_INVALID_ENUM, rcGetTexParameteriv(target, pname, integers));
    EXPECT_RAISES(RC_INVALID_ENUM, rcGetTexParameterfv(target, pname, reals));
    EXPECT_RAISES(RC_INVALID_ENUM, rcGetTexParameterxv(target, pname, integers));
  }
  EXPECT_EQ(integers[0], RC_REPEAT);
  for (RCint value : {-1, 0, 256}) {
    EXPECT_RAISES(RC_INVALID_VALUE, rcTexParameteri(RC_TEXTURE_2D, RC_TEXTURE_OPAQUE_ALPHA, value));
  }
  for (RCint value : {-1, 0}) {
    EXPECT_RAISES(RC_INVALID_VALUE, rcTexParameteri(RC_TEXTURE_2D, RC_TEXTURE_MAX_ANISOTROPY_EXT, value));
  }
  rcTexParameteri(RC_TEXTURE_2D, RC_TEXTURE_MAX_ANISOTROPY_EXT, 1000);  // more than there are is no error
  EXPECT_EQ(texParameter(RC_TEXTURE_MAX_ANISOTROPY_EXT), 16);
  rcTexParameteriv(RC_TEXTURE_2D, RC_TEXTURE_WRAP_S, nullptr);
  rcTexParameterfv(RC_TEXTURE_2D, RC_TEXTURE_WRAP_S, nullptr);
  rcTexParameterxv(RC_TEXTURE_2D, RC_TEXTURE_WRAP_S, nullptr);
  rcGetTexParameteriv(RC_TEXTURE_2D, RC_TEXTURE_WRAP_S, nullptr);
  EXPECT_CLEAN();
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
  const RCuint name = 3;
  rcBindTexture(RC_TEXTURE_2D, name);
  loadSolid(kRed);
  rcDeleteTextures(1, &name);
  EXPECT_EQ(integer(RC_TEXTURE_BINDING_2D), 0);
  loadSolid(kBlue);  // goes to texture 0
  EXPECT_EQ(shown(), kRed);
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
