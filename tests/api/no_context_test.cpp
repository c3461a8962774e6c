// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Every call without a current context: nothing happens, rcGetError tells. [spec 3.8]
#include <algorithm>
#include <functional>

#include "api/context_fixture.h"

namespace rc::test {
namespace {

class NoContextTest : public testing::Test {
 protected:
  void SetUp() override {
    api::setCurrentContext(nullptr);
    rcGetError();
  }

  RCfloat f[16] = {7};
  RCfixed x[16] = {7};
  RCuint u[4] = {7};
  RCboolean b[16] = {7};
  RCvoid *p = this;
};

struct Call {
  const char *name;
  std::function<void()> call;
};
#define CALL(name, ...)               \
  {                                   \
#name, [&] { name(__VA_ARGS__); } \
  }

TEST_F(NoContextTest, NothingHappensAndTheErrorTells) {
  const std::vector<Call> calls{
      CALL(rcBindBuffer, RC_ARRAY_BUFFER, 1),
      CALL(rcBindMaterial, 1),
      CALL(rcBindTexture, RC_TEXTURE_2D, 1),
      CALL(rcBufferData, RC_ARRAY_BUFFER, 4, u, RC_STATIC_DRAW),
      CALL(rcBufferSubData, RC_ARRAY_BUFFER, 0, 4, u),
      CALL(rcClear, 0),
      CALL(rcClearColor, 1, 1, 1, 1),
      CALL(rcClearColorx, 1, 1, 1, 1),
      CALL(rcColor4f, 1, 1, 1, 1),
      CALL(rcColor4ub, 1, 1, 1, 1),
      CALL(rcColor4x, 1, 1, 1, 1),
      CALL(rcColorPointer, 4, RC_FLOAT, 0, f),
      CALL(rcCurrentPaletteMatrixOES, 1),
      CALL(rcDeleteBuffers, 1, u),
      CALL(rcDeleteMaterials, 1, u),
      CALL(rcDeleteTextures, 1, u),
      CALL(rcDepthBounce, 3),
      CALL(rcDisable, RC_LIGHTING),
      CALL(rcDisableClientState, RC_VERTEX_ARRAY),
      CALL(rcDrawArrays, RC_TRIANGLES, 0, 3),
      CALL(rcDrawElements, RC_TRIANGLES, 3, RC_UNSIGNED_INT, u),
      CALL(rcEnable, RC_LIGHTING),
      CALL(rcEnableClientState, RC_VERTEX_ARRAY),
      CALL(rcFinish),
      CALL(rcFlush),
      CALL(rcFrustum, -1, 1, -1, 1, 1, 2),
      CALL(rcFrustumf, -1, 1, -1, 1, 1, 2),
      CALL(rcFrustumx, -1, 1, -1, 1, 1, 2),
      CALL(rcGenBuffers, 1, u),
      CALL(rcGenMaterials, 1, u),
      CALL(rcGenTextures, 1, u),
      CALL(rcGetBooleanv, RC_VIEWPORT, b),
      CALL(rcGetBufferParameteriv, RC_ARRAY_BUFFER, RC_BUFFER_SIZE, reinterpret_cast<RCint *>(u)),
      CALL(rcGetFixedv, RC_VIEWPORT, x),
      CALL(rcGetFloatv, RC_VIEWPORT, f),
      CALL(rcGetIntegerv, RC_VIEWPORT, x),
      CALL(rcGetLightfv, RC_LIGHT0, RC_AMBIENT, f),
      CALL(rcGetLightxv, RC_LIGHT0, RC_AMBIENT, x),
      CALL(rcGetMaterialfv, RC_FRONT, RC_AMBIENT, f),
      CALL(rcGetMaterialxv, RC_FRONT, RC_AMBIENT, x),
      CALL(rcGetPointerv, RC_VERTEX_ARRAY_POINTER, &p),
      CALL(rcGetTexParameterfv, RC_TEXTURE_2D, RC_TEXTURE_WRAP_S, f),
      CALL(rcGetTexParameteriv, RC_TEXTURE_2D, RC_TEXTURE_WRAP_S, x),
      CALL(rcGetTexParameterxv, RC_TEXTURE_2D, RC_TEXTURE_WRAP_S, x),
      CALL(rcHint, RC_MIPMAP_HINT, RC_NICEST),
      CALL(rcIsBuffer, 1),
      CALL(rcLightf, RC_LIGHT0, RC_SPOT_EXPONENT, 1),
      CALL(rcLightfv, RC_LIGHT0, RC_AMBIENT, f),
      CALL(rcLightx, RC_LIGHT0, RC_SPOT_EXPONENT, 1),
      CALL(rcLightxv, RC_LIGHT0, RC_AMBIENT, x),
      CALL(rcLoadIdentity),
      CALL(rcLoadMatrixf, f),
      CALL(rcLoadMatrixx, x),
      CALL(rcLoadPaletteFromModelViewMatrixOES),
      CALL(rcMaterialf, RC_FRONT_AND_BACK, RC_SHININESS, 1),
      CALL(rcMaterialfv, RC_FRONT_AND_BACK, RC_AMBIENT, f),
      CALL(rcMaterialx, RC_FRONT_AND_BACK, RC_SHININESS, 1),
      CALL(rcMaterialxv, RC_FRONT_AND_BACK, RC_AMBIENT, x),
      CALL(rcMatrixIndexPointerOES, 1, RC_UNSIGNED_BYTE, 0, u),
      CALL(rcMatrixMode, RC_MODELVIEW),
      CALL(rcMultMatrixf, f),
      CALL(rcMultMatrixx, x),
      CALL(rcNormalPointer, RC_FLOAT, 0, f),
      CALL(rcPopMatrix),
      CALL(rcPushMatrix),
      CALL(rcRotatef, 1, 1, 1, 1),
      CALL(rcRotatex, 1, 1, 1, 1),
      CALL(rcScalef, 1, 1, 1),
      CALL(rcScalex, 1, 1, 1),
      CALL(rcSceneAllInit),
      CALL(rcSetDiffuseRate, 1),
      CALL(rcSetLightRadius, 1),
      CALL(rcSetSPPCount, 1),
      CALL(rcStaticSceneBegin),
      CALL(rcStaticSceneEnd),
      CALL(rcTexCoordPointer, 2, RC_FLOAT, 0, f),
      CALL(rcTexImage2D, RC_TEXTURE_2D, 0, RC_RGB, 16, 16, 0, RC_RGB, RC_UNSIGNED_BYTE, nullptr),
      CALL(rcTexParameterf, RC_TEXTURE_2D, RC_TEXTURE_WRAP_S, RC_REPEAT),
      CALL(rcTexParameterfv, RC_TEXTURE_2D, RC_TEXTURE_WRAP_S, f),
      CALL(rcTexParameteri, RC_TEXTURE_2D, RC_TEXTURE_WRAP_S, RC_REPEAT),
      CALL(rcTexParameteriv, RC_TEXTURE_2D, RC_TEXTURE_WRAP_S, x),
      CALL(rcTexParameterx, RC_TEXTURE_2D, RC_TEXTURE_WRAP_S, RC_REPEAT),
      CALL(rcTexParameterxv, RC_TEXTURE_2D, RC_TEXTURE_WRAP_S, x),
      CALL(rcTextureAlpha, 3),
      CALL(rcTranslatef, 1, 1, 1),
      CALL(rcTranslatex, 1, 1, 1),
      CALL(rcVertexPointer, 3, RC_FLOAT, 0, f),
      CALL(rcViewport, 0, 0, 1, 1),
      CALL(rcWeightPointerOES, 1, RC_FLOAT, 0, f),
      CALL(rcuLookAt, 0, 0, 0, 0, 0, -1, 0, 1, 0),
      CALL(rcuPerspective, 60, 1, 1, 2),
  };
  std::vector<std::string> called{"rcGetError"}, entries;
  for (const Call &call : calls) {
    call.call();
    EXPECT_EQ(rcGetError(), RCenum(RC_INVALID_OPERATION)) << call.name;
    EXPECT_EQ(rcGetError(), RCenum(RC_NO_ERROR)) << call.name;
    called.emplace_back(call.name);
  }
  // Nothing was written, and what returns something returns nothing.
  EXPECT_EQ(f[0], 7);
  EXPECT_EQ(x[0], 7);
  EXPECT_EQ(u[0], 7u);
  EXPECT_EQ(b[0], 7);
  EXPECT_EQ(p, this);
  for (const char *name : {"rcGetString", "rcIsEnabled", "rcIsMaterial", "rcIsTexture"}) called.emplace_back(name);
  std::sort(called.begin(), called.end());
  called.erase(std::unique(called.begin(), called.end()), called.end());
  EXPECT_EQ(rcGetString(RC_VENDOR), nullptr);
  EXPECT_FALSE(rcIsEnabled(RC_USE_SHADOW));
  EXPECT_FALSE(rcIsMaterial(0));
  EXPECT_FALSE(rcIsTexture(0));
  EXPECT_FALSE(rcIsBuffer(0));
  EXPECT_EQ(rcGetError(), RCenum(RC_INVALID_OPERATION));
#define RC_ENTRY(name) entries.emplace_back(#name);
#include "api/entry_points.inc"
#undef RC_ENTRY
  std::sort(entries.begin(), entries.end());
  EXPECT_EQ(called, entries);  // none is missing
}

TEST_F(NoContextTest, ACallWithoutContextLeavesNoErrorInALaterContext) {
  rcFinish();
  Settings settings;
  settings.threads = 1;
  api::Context context{settings};
  api::setCurrentContext(&context);
  EXPECT_CLEAN();
  api::setCurrentContext(nullptr);
}

}  // namespace
}  // namespace rc::test
