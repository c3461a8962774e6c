// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Every call without a current context: nothing happens, rcGetError tells. [spec 3.8]
#include <algorithm>
#include <functional>

#include "api/context_fixture.h"
#include "api/functions.h"

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
      CALL(rcActiveTexture, 1),
      CALL(rcAlphaFunc, 1, 1),
      CALL(rcAlphaFuncx, 1, 1),
      CALL(rcBindBuffer, RC_ARRAY_BUFFER, 1),
      CALL(rcBindMaterial, 1),
      CALL(rcBindTexture, RC_TEXTURE_2D, 1),
      CALL(rcBlendFunc, 1, 1),
      CALL(rcBufferData, RC_ARRAY_BUFFER, 4, u, RC_STATIC_DRAW),
      CALL(rcBufferSubData, RC_ARRAY_BUFFER, 0, 4, u),
      CALL(rcClear, 0),
      CALL(rcClearColor, 1, 1, 1, 1),
      CALL(rcClearColorx, 1, 1, 1, 1),
      CALL(rcClearDepthf, 1),
      CALL(rcClearDepthx, 1),
      CALL(rcClearStencil, 1),
      CALL(rcClientActiveTexture, 1),
      CALL(rcClipPlanef, 1, f),
      CALL(rcClipPlanex, 1, x),
      CALL(rcColor4f, 1, 1, 1, 1),
      CALL(rcColor4ub, 1, 1, 1, 1),
      CALL(rcColor4x, 1, 1, 1, 1),
      CALL(rcColorMask, 1, 1, 1, 1),
      CALL(rcColorPointer, 4, RC_FLOAT, 0, f),
      CALL(rcCompressedTexImage2D, 1, 1, 1, 1, 1, 1, 1, u),
      CALL(rcCompressedTexSubImage2D, 1, 1, 1, 1, 1, 1, 1, 1, u),
      CALL(rcCopyTexImage2D, 1, 1, 1, 1, 1, 1, 1, 1),
      CALL(rcCopyTexSubImage2D, 1, 1, 1, 1, 1, 1, 1, 1),
      CALL(rcCullFace, 1),
      CALL(rcCurrentPaletteMatrixOES, 1),
      CALL(rcDebugMessageCallbackRCX, nullptr, nullptr),
      CALL(rcDeleteBuffers, 1, u),
      CALL(rcDeleteMaterials, 1, u),
      CALL(rcDeleteTextures, 1, u),
      CALL(rcDepthBounce, 3),
      CALL(rcDepthFunc, 1),
      CALL(rcDepthMask, 1),
      CALL(rcDepthRangef, 1, 1),
      CALL(rcDepthRangex, 1, 1),
      CALL(rcDisable, RC_LIGHTING),
      CALL(rcDisableClientState, RC_VERTEX_ARRAY),
      CALL(rcDrawArrays, RC_TRIANGLES, 0, 3),
      CALL(rcDrawElements, RC_TRIANGLES, 3, RC_UNSIGNED_INT, u),
      CALL(rcEnable, RC_LIGHTING),
      CALL(rcEnableClientState, RC_VERTEX_ARRAY),
      CALL(rcFinish),
      CALL(rcFlush),
      CALL(rcFogf, 1, 1),
      CALL(rcFogfv, 1, f),
      CALL(rcFogx, 1, 1),
      CALL(rcFogxv, 1, x),
      CALL(rcFrontFace, 1),
      CALL(rcFrustum, -1, 1, -1, 1, 1, 2),
      CALL(rcFrustumf, -1, 1, -1, 1, 1, 2),
      CALL(rcFrustumx, -1, 1, -1, 1, 1, 2),
      CALL(rcGenBuffers, 1, u),
      CALL(rcGenMaterials, 1, u),
      CALL(rcGenTextures, 1, u),
      CALL(rcGetBooleanv, RC_VIEWPORT, b),
      CALL(rcGetBufferParameteriv, RC_ARRAY_BUFFER, RC_BUFFER_SIZE, reinterpret_cast<RCint *>(u)),
      CALL(rcGetClipPlanef, 1, f),
      CALL(rcGetClipPlanex, 1, x),
      CALL(rcGetFixedv, RC_VIEWPORT, x),
      CALL(rcGetFloatv, RC_VIEWPORT, f),
      CALL(rcGetIntegerv, RC_VIEWPORT, x),
      CALL(rcGetLightfv, RC_LIGHT0, RC_AMBIENT, f),
      CALL(rcGetLightxv, RC_LIGHT0, RC_AMBIENT, x),
      CALL(rcGetMaterialfv, RC_FRONT, RC_AMBIENT, f),
      CALL(rcGetMaterialxv, RC_FRONT, RC_AMBIENT, x),
      CALL(rcGetPointerv, RC_VERTEX_ARRAY_POINTER, &p),
      CALL(rcGetTexEnvfv, 1, 1, f),
      CALL(rcGetTexEnviv, 1, 1, x),
      CALL(rcGetTexEnvxv, 1, 1, x),
      CALL(rcGetTexParameterfv, RC_TEXTURE_2D, RC_TEXTURE_WRAP_S, f),
      CALL(rcGetTexParameteriv, RC_TEXTURE_2D, RC_TEXTURE_WRAP_S, x),
      CALL(rcGetTexParameterxv, RC_TEXTURE_2D, RC_TEXTURE_WRAP_S, x),
      CALL(rcHint, RC_MIPMAP_HINT, RC_NICEST),
      CALL(rcIsBuffer, 1),
      CALL(rcLightModelf, 1, 1),
      CALL(rcLightModelfv, 1, f),
      CALL(rcLightModelx, 1, 1),
      CALL(rcLightModelxv, 1, x),
      CALL(rcLightf, RC_LIGHT0, RC_SPOT_EXPONENT, 1),
      CALL(rcLightfv, RC_LIGHT0, RC_AMBIENT, f),
      CALL(rcLightx, RC_LIGHT0, RC_SPOT_EXPONENT, 1),
      CALL(rcLightxv, RC_LIGHT0, RC_AMBIENT, x),
      CALL(rcLineWidth, 1),
      CALL(rcLineWidthx, 1),
      CALL(rcLoadIdentity),
      CALL(rcLoadMatrixf, f),
      CALL(rcLoadMatrixx, x),
      CALL(rcLoadPaletteFromModelViewMatrixOES),
      CALL(rcLogicOp, 1),
      CALL(rcMaterialf, RC_FRONT_AND_BACK, RC_SHININESS, 1),
      CALL(rcMaterialfv, RC_FRONT_AND_BACK, RC_AMBIENT, f),
      CALL(rcMaterialx, RC_FRONT_AND_BACK, RC_SHININESS, 1),
      CALL(rcMaterialxv, RC_FRONT_AND_BACK, RC_AMBIENT, x),
      CALL(rcMatrixIndexPointerOES, 1, RC_UNSIGNED_BYTE, 0, u),
      CALL(rcMatrixMode, RC_MODELVIEW),
      CALL(rcMultMatrixf, f),
      CALL(rcMultMatrixx, x),
      CALL(rcMultiTexCoord4f, 1, 1, 1, 1, 1),
      CALL(rcMultiTexCoord4x, 1, 1, 1, 1, 1),
      CALL(rcNormal3f, 1, 1, 1),
      CALL(rcNormal3x, 1, 1, 1),
      CALL(rcNormalPointer, RC_FLOAT, 0, f),
      CALL(rcOrtho, 1, 1, 1, 1, 1, 1),
      CALL(rcOrthof, 1, 1, 1, 1, 1, 1),
      CALL(rcOrthox, 1, 1, 1, 1, 1, 1),
      CALL(rcPixelStorei, 1, 1),
      CALL(rcPointParameterf, 1, 1),
      CALL(rcPointParameterfv, 1, f),
      CALL(rcPointParameterx, 1, 1),
      CALL(rcPointParameterxv, 1, x),
      CALL(rcPointSize, 1),
      CALL(rcPointSizePointerOES, 1, 1, u),
      CALL(rcPointSizex, 1),
      CALL(rcPolygonOffset, 1, 1),
      CALL(rcPolygonOffsetx, 1, 1),
      CALL(rcPopMatrix),
      CALL(rcPushMatrix),
      CALL(rcReadPixels, 1, 1, 1, 1, 1, 1, u),
      CALL(rcReadRaysRCX, 1, 1, 1, 1, RC_RAY_BOXES, f),
      CALL(rcRotatef, 1, 1, 1, 1),
      CALL(rcRotatex, 1, 1, 1, 1),
      CALL(rcSampleCoverage, 1, 1),
      CALL(rcSampleCoveragex, 1, 1),
      CALL(rcScalef, 1, 1, 1),
      CALL(rcScalex, 1, 1, 1),
      CALL(rcSceneAllInit),
      CALL(rcScissor, 1, 1, 1, 1),
      CALL(rcSetDiffuseRate, 1),
      CALL(rcSetLightRadius, 1),
      CALL(rcSetSPPCount, 1),
      CALL(rcShadeModel, 1),
      CALL(rcStaticSceneBegin),
      CALL(rcStaticSceneEnd),
      CALL(rcStencilFunc, 1, 1, 1),
      CALL(rcStencilMask, 1),
      CALL(rcStencilOp, 1, 1, 1),
      CALL(rcTexCoordPointer, 2, RC_FLOAT, 0, f),
      CALL(rcTexEnvf, 1, 1, 1),
      CALL(rcTexEnvfv, 1, 1, f),
      CALL(rcTexEnvi, 1, 1, 1),
      CALL(rcTexEnviv, 1, 1, x),
      CALL(rcTexEnvx, 1, 1, 1),
      CALL(rcTexEnvxv, 1, 1, x),
      CALL(rcTexImage2D, RC_TEXTURE_2D, 0, RC_RGB, 16, 16, 0, RC_RGB, RC_UNSIGNED_BYTE, nullptr),
      CALL(rcTexParameterf, RC_TEXTURE_2D, RC_TEXTURE_WRAP_S, RC_REPEAT),
      CALL(rcTexParameterfv, RC_TEXTURE_2D, RC_TEXTURE_WRAP_S, f),
      CALL(rcTexParameteri, RC_TEXTURE_2D, RC_TEXTURE_WRAP_S, RC_REPEAT),
      CALL(rcTexParameteriv, RC_TEXTURE_2D, RC_TEXTURE_WRAP_S, x),
      CALL(rcTexParameterx, RC_TEXTURE_2D, RC_TEXTURE_WRAP_S, RC_REPEAT),
      CALL(rcTexParameterxv, RC_TEXTURE_2D, RC_TEXTURE_WRAP_S, x),
      CALL(rcTexSubImage2D, 1, 1, 1, 1, 1, 1, 1, 1, u),
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
  for (const api::FunctionRow &row : api::functions()) entries.emplace_back(row.name);
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
