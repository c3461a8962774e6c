// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// One scene with all that OpenGL ES 1.1 adds, on the reference device and on the fast one.
#include "api/context_fixture.h"

namespace rc::test {
namespace {

class DeviceAgreementTest : public ContextTest {
 protected:
  void floorAndMirror() {
    paintDiffuse(0.6f, 0.7f, 0.8f);
    drawQuad({-40, -30, 110, 80}, -30);
    rcBindMaterial(1);
    rcMaterialf(RC_FRONT_AND_BACK, RC_REFLECTION, 0.5f);
    drawQuad({34, 4, 60, 30}, -5);
    rcBindMaterial(0);
  }
  void cutAndCulled() {
    const float planes[2][4] = {{1, 0.3f, 0, -9.7f}, {-1, -1, 0, 43.3f}};
    for (RCenum i = 0; i < 2; ++i) {
      rcClipPlanef(RC_CLIP_PLANE0 + i, planes[i]);
      rcEnable(RC_CLIP_PLANE0 + i);
    }
    drawColouredQuad({2, 2, 30, 40}, {1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1, 1, 1, 1, 1}, 8);
    rcShadeModel(RC_FLAT);
    drawColouredQuad({12, 8, 44, 30}, {1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1, 0, 1, 1, 1}, 3);
    rcShadeModel(RC_SMOOTH);
    for (RCenum i = 0; i < 2; ++i) rcDisable(RC_CLIP_PLANE0 + i);
    rcEnable(RC_CULL_FACE);
    drawClockwiseQuad({40, 30, 60, 45}, 2);
    rcCullFace(RC_FRONT);
    drawQuad({5, 30, 20, 44}, 6);
    rcDisable(RC_CULL_FACE);
  }
  // Texels whose alpha grows along s; half of them pass.
  void alphaTested() {
    rcBindMaterial(2);
    rcMaterialf(RC_FRONT_AND_BACK, RC_REFLECTION, 0);
    rcEnable(RC_TEXTURE_2D);
    rcBindTexture(RC_TEXTURE_2D, 1);
    rcTexParameteri(RC_TEXTURE_2D, RC_TEXTURE_OPAQUE_ALPHA, 255);
    std::vector<RCubyte> texels;
    for (int i = 0; i < 256; ++i) {
      for (int channel : {200, 8 * (i / 16), 60, 16 * (i % 16)}) texels.push_back(RCubyte(channel));
    }
    rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGBA, 16, 16, 0, RC_RGBA, RC_UNSIGNED_BYTE, texels.data());
    rcTexEnvi(RC_TEXTURE_ENV, RC_TEXTURE_ENV_MODE, RC_MODULATE);
    rcAlphaFunc(RC_GREATER, 0.5f);
    rcEnable(RC_ALPHA_TEST);
    rcEnable(RC_USE_TEXTURE_ALPHA_SHADOW);
    drawTexturedQuad({20, 20, 54, 44}, 2, 2, 10);
    rcDisable(RC_ALPHA_TEST);
    rcDisable(RC_USE_TEXTURE_ALPHA_SHADOW);
  }
  void normalMapped() {
    rcBindMaterial(3);
    rcDisable(RC_TEXTURE_2D);
    rcBindTexture(RC_TEXTURE_2D_NORMAL, 2);
    rcEnable(RC_TEXTURE_2D_NORMAL);
    std::vector<RCubyte> texels;
    for (int i = 0; i < 256; ++i) {
      for (int channel : {64 + 8 * (i % 16), 64 + 8 * (i / 16), 230}) texels.push_back(RCubyte(channel));
    }
    rcTexImage2D(RC_TEXTURE_2D_NORMAL, 0, RC_RGB, 16, 16, 0, RC_RGB, RC_UNSIGNED_BYTE, texels.data());
    drawTexturedQuad({6, 4, 26, 18}, 1, 1, 12);
    rcBindMaterial(0);
  }
  void fogAndFrame() {
    const float fog[] = {0.3f, 0.4f, 0.5f, 1}, ambient[] = {0.2f, 0.1f, 0.1f, 1};
    rcFogfv(RC_FOG_COLOR, fog);
    rcFogf(RC_FOG_DENSITY, 0.004f);
    rcEnable(RC_FOG);
    rcLightModelfv(RC_LIGHT_MODEL_AMBIENT, ambient);
    rcClearColor(0.1f, 0.5f, 0.2f, 0);
    rcEnable(RC_SCISSOR_TEST);
    rcScissor(1, 2, 60, 45);
    rcColorMask(RC_TRUE, RC_TRUE, RC_TRUE, RC_FALSE);
  }

  std::vector<uint32_t> picture(const char *device, bool parallel) {
    Settings settings;
    settings.device = device;
    useSettings(settings);
    surface.fill(0x01020304);
    pixelCamera();
    if (parallel) rcOrthof(-kWidth / 2, kWidth / 2, -kHeight / 2, kHeight / 2, 0, 200);
    lightFrom(50, 60, 70, 1, 0.9f);
    floorAndMirror();
    cutAndCulled();
    alphaTested();
    normalMapped();
    fogAndFrame();
    rcFinish();
    EXPECT_CLEAN();
    return surface.pixels;
  }
};

TEST_F(DeviceAgreementTest, CpuAgreesWithRef) {
  for (const bool parallel : {false, true}) {
    const std::vector<uint32_t> truth = picture("ref", parallel);
    const RCint rays = integer(RC_FRAME_RAYS);
    const std::vector<uint32_t> found = picture("cpu", parallel);
    EXPECT_EQ(integer(RC_FRAME_RAYS), rays);
    const hal::RayCounts counts = context->lastFrame().rays;
    EXPECT_TRUE(counts.shadow > 0 && counts.reflected > 0 && counts.straight > 0) << "every kind of ray is needed";
    for (size_t i = 0; i < truth.size(); ++i) {
      for (int shift = 0; shift < 32; shift += 8) {
        ASSERT_NEAR(double(found[i] >> shift & 255), double(truth[i] >> shift & 255), 1) << "pixel " << i;
      }
    }
  }
}

}  // namespace
}  // namespace rc::test
