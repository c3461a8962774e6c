// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Materials: names, parameters, copies. [spec 3.5]
#include "api/context_fixture.h"

namespace rc::test {
namespace {

using MaterialTest = ContextTest;
using Values = std::vector<float>;

constexpr RCenum kBoth = RC_FRONT_AND_BACK;
constexpr RCenum kColours[] = {RC_AMBIENT, RC_DIFFUSE, RC_SPECULAR, RC_AMBIENT_AND_DIFFUSE, RC_EMISSION};
constexpr RCenum kMaterialScalars[] = {RC_SHININESS, RC_SPECULAR_LEVEL, RC_REFRACTION_INDEX, RC_ROUGHNESS};
constexpr RCenum kShares[] = {RC_REFLECTION, RC_TRANSMITTANCE};

TEST_F(MaterialTest, InitialState) {
  for (RCuint name : {0u, 5u}) {
    rcBindMaterial(name);
    EXPECT_EQ(material(RC_AMBIENT, 4), (Values{0.2f, 0.2f, 0.2f, 1}));
    EXPECT_EQ(material(RC_DIFFUSE, 4), (Values{0.8f, 0.8f, 0.8f, 1}));
    EXPECT_EQ(material(RC_SPECULAR, 4), (Values{0, 0, 0, 1}));
    EXPECT_EQ(material(RC_EMISSION, 3), (Values{0, 0, 0}));
    EXPECT_EQ(material(RC_REFLECTION, 3), (Values{0, 0, 0}));
    EXPECT_EQ(material(RC_TRANSMITTANCE, 3), (Values{0, 0, 0}));
    EXPECT_EQ(materialScalar(RC_REFRACTION_INDEX), 1);
    EXPECT_EQ(materialScalar(RC_SHININESS), 0);
    EXPECT_EQ(materialScalar(RC_SPECULAR_LEVEL), 1);
  }
  EXPECT_EQ(integer(RC_MAX_MATERIALS), 512);
  EXPECT_EQ(floats(RC_CURRENT_COLOR, 4), (Values{1, 1, 1, 1}));
  for (const char *profile : {"1000", "mc"}) {
    useProfile(profile);
    EXPECT_EQ(materialScalar(RC_SPECULAR_LEVEL), 0) << profile;
    rcBindMaterial(7);
    EXPECT_EQ(materialScalar(RC_SPECULAR_LEVEL), 0) << profile;
  }
}

TEST_F(MaterialTest, NamesAreTheLowestFreeOnes) {
  EXPECT_TRUE(rcIsMaterial(0));
  EXPECT_FALSE(rcIsMaterial(1));
  RCuint names[3] = {};
  rcGenMaterials(3, names);
  EXPECT_EQ(names[0], 1u);
  EXPECT_EQ(names[2], 3u);
  EXPECT_TRUE(rcIsMaterial(2));
  rcDeleteMaterials(1, &names[1]);
  EXPECT_FALSE(rcIsMaterial(2));
  rcBindMaterial(4);
  EXPECT_TRUE(rcIsMaterial(4));
  rcGenMaterials(2, names);
  EXPECT_EQ(names[0], 2u);
  EXPECT_EQ(names[1], 5u);
  EXPECT_FALSE(rcIsMaterial(511));
  EXPECT_FALSE(rcIsMaterial(512));
  EXPECT_FALSE(rcIsMaterial(0xFFFFFFFF));
  rcGenMaterials(0, nullptr);
  EXPECT_CLEAN();
}

TEST_F(MaterialTest, NamesEndAt511) {
  rcBindMaterial(511);
  EXPECT_CLEAN();
  EXPECT_EQ(integer(RC_MATERIAL_BINDING), 511);
  for (RCuint name : {512u, 513u, 0xFFFFFFFFu}) EXPECT_RAISES(RC_OUT_OF_MEMORY, rcBindMaterial(name));
  RCuint names[520];
  std::fill(std::begin(names), std::end(names), 9999);
  rcGenMaterials(512, names);  // 510 are left
  EXPECT_EQ(rcGetError(), RCenum(RC_OUT_OF_MEMORY));
  EXPECT_EQ(names[0], 1u);
  EXPECT_EQ(names[509], 510u);
  EXPECT_EQ(names[510], 9999u);
  EXPECT_TRUE(rcIsMaterial(510));
  EXPECT_RAISES(RC_OUT_OF_MEMORY, rcGenMaterials(1, names));
  rcDeleteMaterials(1, &names[99]);
  rcGenMaterials(1, names);
  EXPECT_EQ(names[0], 100u);
  EXPECT_CLEAN();
}

TEST_F(MaterialTest, NameErrors) {
  RCuint names[1] = {9};
  EXPECT_RAISES(RC_INVALID_VALUE, rcGenMaterials(-1, names));
  EXPECT_RAISES(RC_INVALID_VALUE, rcDeleteMaterials(-1, names));
  EXPECT_EQ(names[0], 9u);
}

TEST_F(MaterialTest, DeletingIgnoresZeroAndUnknownNamesAndUnbinds) {
  RCuint names[] = {0, 77, 512, 0xFFFFFFFF, 3};
  rcBindMaterial(3);
  rcDeleteMaterials(5, names);
  EXPECT_CLEAN();
  EXPECT_TRUE(rcIsMaterial(0));
  EXPECT_FALSE(rcIsMaterial(3));
  EXPECT_EQ(integer(RC_MATERIAL_BINDING), 0);
}

TEST_F(MaterialTest, ScalarsAreKept) {
  for (RCenum pname : kMaterialScalars) {
    rcMaterialf(kBoth, pname, 1.5f);
    EXPECT_EQ(materialScalar(pname), 1.5f);
    rcMaterialx(kBoth, pname, 5 * kFixedOne / 2);
    EXPECT_EQ(materialScalar(pname), 2.5f);
    const float one[] = {3.5f};
    rcMaterialfv(kBoth, pname, one);
    EXPECT_EQ(materialScalar(pname), 3.5f);
    const auto fixed = std::make_unique<RCfixed[]>(1);
    fixed[0] = 4 * kFixedOne;
    rcMaterialxv(kBoth, pname, fixed.get());
    RCfixed back = 0;
    rcGetMaterialxv(kBoth, pname, &back);
    EXPECT_EQ(back, 4 * kFixedOne);
  }
  rcMaterialf(kBoth, RC_SHININESS, 100000);  // no upper limit
  EXPECT_EQ(materialScalar(RC_SHININESS), 100000);
  EXPECT_CLEAN();
}

TEST_F(MaterialTest, ColoursAreClampedAndThreeValuesAreRead) {
  const auto three = std::make_unique<float[]>(3);  // nothing may be read beyond
  three[0] = 0.25f, three[1] = 2, three[2] = -1;
  for (RCenum pname : kColours) {
    rcMaterialfv(kBoth, pname, three.get());
    EXPECT_EQ(material(pname, 3), (Values{0.25f, 1, 0}));
  }
  const float both[] = {0.5f, 0.75f, 1};
  rcMaterialfv(kBoth, RC_AMBIENT_AND_DIFFUSE, both);
  EXPECT_EQ(material(RC_AMBIENT, 4), (Values{0.5f, 0.75f, 1, 1}));
  EXPECT_EQ(material(RC_DIFFUSE, 4), (Values{0.5f, 0.75f, 1, 1}));
  const auto fixed = std::make_unique<RCfixed[]>(3);
  fixed[0] = fixed[1] = kFixedOne / 2, fixed[2] = 0;
  rcMaterialxv(kBoth, RC_SPECULAR, fixed.get());
  EXPECT_EQ(material(RC_SPECULAR, 3), (Values{0.5f, 0.5f, 0}));
  RCfixed back[4] = {};
  rcGetMaterialxv(kBoth, RC_SPECULAR, back);
  EXPECT_EQ(back[0], kFixedOne / 2);
  EXPECT_EQ(back[3], kFixedOne);
  EXPECT_CLEAN();
}

TEST_F(MaterialTest, SharesAreThreeValuesOrOneByProfile) {
  const auto three = std::make_unique<float[]>(3), one = std::make_unique<float[]>(1);
  three[0] = 0.25f, three[1] = 0.5f, three[2] = 0.125f;
  one[0] = 0.75f;
  for (RCenum pname : kShares) {
    rcMaterialfv(kBoth, pname, three.get());
    EXPECT_EQ(material(pname, 3), (Values{0.25f, 0.5f, 0.125f}));
    rcMaterialf(kBoth, pname, 0.5f);
    EXPECT_EQ(material(pname, 3), (Values{0.5f, 0.5f, 0.5f}));
  }
  for (const char *profile : {"1000", "mc"}) {
    useProfile(profile);
    for (RCenum pname : kShares) {
      rcMaterialfv(kBoth, pname, one.get());  // nothing may be read beyond
      EXPECT_EQ(materialScalar(pname), 0.75f);
    }
    EXPECT_EQ(context->boundMaterial().reflection, Rgb(0.75f)) << profile;
  }
}

TEST_F(MaterialTest, EveryFaceCanBeAsked) {
  for (RCenum face : {RC_FRONT, RC_BACK, RC_FRONT_AND_BACK}) {
    float values[4] = {};
    rcGetMaterialfv(RCenum(face), RC_DIFFUSE, values);
    EXPECT_EQ(values[0], 0.8f);
  }
  EXPECT_CLEAN();
}

TEST_F(MaterialTest, FaceAndNameErrors) {
  float values[4] = {};
  RCfixed fixed[4] = {};
  for (RCenum face : {RCenum(RC_FRONT), RCenum(RC_BACK), kNoToken}) {
    EXPECT_RAISES(RC_INVALID_ENUM, rcMaterialf(face, RC_SHININESS, 1));
    EXPECT_RAISES(RC_INVALID_ENUM, rcMaterialx(face, RC_SHININESS, 1));
    EXPECT_RAISES(RC_INVALID_ENUM, rcMaterialfv(face, RC_AMBIENT, values));
    EXPECT_RAISES(RC_INVALID_ENUM, rcMaterialxv(face, RC_AMBIENT, fixed));
  }
  EXPECT_RAISES(RC_INVALID_ENUM, rcGetMaterialfv(kNoToken, RC_AMBIENT, values));
  EXPECT_RAISES(RC_INVALID_ENUM, rcGetMaterialxv(kNoToken, RC_AMBIENT, fixed));
  for (RCenum pname : {RCenum(RC_POSITION), RCenum(RC_TEXTURE_ALPHA), kNoToken}) {
    EXPECT_RAISES(RC_INVALID_ENUM, rcMaterialf(kBoth, pname, 1));
    EXPECT_RAISES(RC_INVALID_ENUM, rcMaterialx(kBoth, pname, 1));
    EXPECT_RAISES(RC_INVALID_ENUM, rcMaterialfv(kBoth, pname, values));
    EXPECT_RAISES(RC_INVALID_ENUM, rcMaterialxv(kBoth, pname, fixed));
    EXPECT_RAISES(RC_INVALID_ENUM, rcGetMaterialfv(kBoth, pname, values));
    EXPECT_RAISES(RC_INVALID_ENUM, rcGetMaterialxv(kBoth, pname, fixed));
  }
  for (RCenum pname : kColours) {
    EXPECT_RAISES(RC_INVALID_ENUM, rcMaterialf(kBoth, pname, 1));
    EXPECT_RAISES(RC_INVALID_ENUM, rcMaterialx(kBoth, pname, 1));
  }
}

TEST_F(MaterialTest, RangeErrors) {
  for (RCenum pname : kMaterialScalars) {
    const float values[] = {-0.5f};
    const RCfixed fixed[] = {-1};
    EXPECT_RAISES(RC_INVALID_VALUE, rcMaterialf(kBoth, pname, -0.5f));
    EXPECT_RAISES(RC_INVALID_VALUE, rcMaterialf(kBoth, pname, kNan));
    EXPECT_RAISES(RC_INVALID_VALUE, rcMaterialx(kBoth, pname, -1));
    EXPECT_RAISES(RC_INVALID_VALUE, rcMaterialfv(kBoth, pname, values));
    EXPECT_RAISES(RC_INVALID_VALUE, rcMaterialxv(kBoth, pname, fixed));
  }
  EXPECT_RAISES(RC_INVALID_VALUE, rcMaterialfv(kBoth, RC_AMBIENT, nullptr));
  EXPECT_RAISES(RC_INVALID_VALUE, rcMaterialxv(kBoth, RC_AMBIENT, nullptr));
  rcGetMaterialfv(kBoth, RC_AMBIENT, nullptr);
  rcGetMaterialxv(kBoth, RC_AMBIENT, nullptr);
  EXPECT_CLEAN();
}

TEST_F(MaterialTest, ColorSetsAmbientAndDiffuseAndNoSpecular) {
  const float shiny[] = {0.5f, 0.5f, 0.5f};
  rcBindMaterial(2);
  rcMaterialfv(kBoth, RC_SPECULAR, shiny);
  rcColor4f(0.25f, 2, -1, 0.5f);
  EXPECT_EQ(floats(RC_CURRENT_COLOR, 4), (Values{0.25f, 1, 0, 0.5f}));
  EXPECT_EQ(material(RC_AMBIENT, 3), (Values{0.25f, 1, 0}));
  EXPECT_EQ(material(RC_DIFFUSE, 3), (Values{0.25f, 1, 0}));
  EXPECT_EQ(material(RC_SPECULAR, 3), (Values{0, 0, 0}));
  rcColor4ub(255, 0, 51, 102);
  EXPECT_EQ(material(RC_DIFFUSE, 3), (Values{1, 0, 0.2f}));
  EXPECT_EQ(floats(RC_CURRENT_COLOR, 4), (Values{1, 0, 0.2f, 0.4f}));
  rcColor4x(kFixedOne / 2, kFixedOne / 4, 2 * kFixedOne, -1);
  EXPECT_EQ(material(RC_AMBIENT, 3), (Values{0.5f, 0.25f, 1}));
  rcBindMaterial(0);
  EXPECT_EQ(material(RC_AMBIENT, 3), (Values{0.2f, 0.2f, 0.2f}));  // only the bound material
}

TEST_F(MaterialTest, ANewMaterialIsACopyOfTheBoundOne) {
  paint(0.25f, 0.5f, 1);
  rcMaterialf(kBoth, RC_SHININESS, 9);
  rcMaterialf(kBoth, RC_REFLECTION, 0.5f);
  rcEnable(RC_TEXTURE_2D);
  rcBindTexture(RC_TEXTURE_2D, 4);
  RCuint generated = 0;
  rcGenMaterials(1, &generated);
  paint(1, 1, 1);  // comes too late for the generated one
  rcBindMaterial(9);
  EXPECT_EQ(material(RC_AMBIENT, 3), (Values{1, 1, 1}));
  rcBindMaterial(generated);
  EXPECT_EQ(material(RC_AMBIENT, 3), (Values{0.25f, 0.5f, 1}));
  EXPECT_EQ(materialScalar(RC_SHININESS), 9);
  EXPECT_EQ(material(RC_REFLECTION, 3), (Values{0.5f, 0.5f, 0.5f}));
  EXPECT_TRUE(rcIsEnabled(RC_TEXTURE_2D));
  EXPECT_EQ(integer(RC_TEXTURE_BINDING_2D), 4);
}

TEST_F(MaterialTest, ADisabledTextureIsNotCopied) {
  rcBindTexture(RC_TEXTURE_2D, 4);
  rcBindMaterial(1);
  EXPECT_FALSE(rcIsEnabled(RC_TEXTURE_2D));
  EXPECT_EQ(integer(RC_TEXTURE_BINDING_2D), 0);
  rcBindMaterial(0);
  EXPECT_EQ(integer(RC_TEXTURE_BINDING_2D), 4);
}

TEST_F(MaterialTest, BindingAMaterialMakesItsTextureCurrent) {
  rcBindMaterial(1);
  rcBindTexture(RC_TEXTURE_2D, 11);
  rcEnable(RC_TEXTURE_2D);
  rcBindMaterial(2);
  rcBindTexture(RC_TEXTURE_2D, 12);
  rcBindMaterial(1);
  EXPECT_EQ(integer(RC_TEXTURE_BINDING_2D), 11);
  pixelCamera();
  rcEnable(RC_USE_TEXTURE_ONLY);
  loadSolid({200, 0, 0});  // goes to 11
  rcBindMaterial(2);
  loadSolid({0, 0, 200});
  rcBindMaterial(1);
  drawTexturedQuad({0, 0, 64, 48});
  rcFinish();
  EXPECT_EQ(pixel(32, 24), (Colour{200, 0, 0}));
}

TEST_F(MaterialTest, TextureEnablesBelongToTheMaterial) {
  rcBindMaterial(1);
  rcEnable(RC_TEXTURE_2D_NORMAL);
  rcBindMaterial(0);
  EXPECT_FALSE(rcIsEnabled(RC_TEXTURE_2D_NORMAL));
  rcBindMaterial(1);
  EXPECT_TRUE(rcIsEnabled(RC_TEXTURE_2D_NORMAL));
}

}  // namespace
}  // namespace rc::test
