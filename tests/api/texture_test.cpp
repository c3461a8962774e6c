// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Textures: names, loading, parameters. [spec 3.4]
#include "api/texture_fixture.h"

namespace rc::test {
namespace {

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

}  // namespace
}  // namespace rc::test
