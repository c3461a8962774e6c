// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Camera: viewport, window, viewer, clear colour. [spec 3.1]
#include "api/context_fixture.h"

namespace rc::test {
namespace {

using CameraTest = ContextTest;

std::vector<double> windowOf(const api::Context &context) {
  const ddk::Window &w = context.state.view.camera.window;
  return {w.left, w.right, w.bottom, w.top, w.near};
}

TEST_F(CameraTest, InitialState) {
  EXPECT_EQ(floats(RC_VIEWPORT, 4), (std::vector<float>{0, 0, kWidth, kHeight}));
  EXPECT_EQ(floats(RC_COLOR_CLEAR_VALUE, 4), (std::vector<float>{0, 0, 0, 0}));
  const ddk::Camera &camera = context->state.view.camera;
  EXPECT_EQ(camera.eye, Vec3(0));
  EXPECT_EQ(camera.back, Vec3(0, 0, 1));
  EXPECT_EQ(camera.up, Vec3(0, 1, 0));
  const double top = 0.1 * std::tan(std::acos(-1.0) / 6);
  EXPECT_NEAR(camera.window.top, top, 1e-9);
  EXPECT_NEAR(camera.window.bottom, -top, 1e-9);
  EXPECT_NEAR(camera.window.right, top * 800 / 480, 1e-9);
  EXPECT_NEAR(camera.window.left, -top * 800 / 480, 1e-9);
  EXPECT_NEAR(camera.window.near, 0.1, 1e-9);
}

TEST_F(CameraTest, TheViewportIsThatOfTheGuideUntilThereIsASurface) {
  const api::Context fresh{Settings{}};
  EXPECT_EQ(fresh.state.view.width, 800);
  EXPECT_EQ(fresh.state.view.height, 480);
}

TEST_F(CameraTest, OnlyTheFirstSurfaceSetsTheViewport) {
  rcViewport(0, 0, 10, 20);
  context->attach(nullptr);
  context->attach(&surface);
  EXPECT_EQ(floats(RC_VIEWPORT, 4), (std::vector<float>{0, 0, 10, 20}));
}

TEST_F(CameraTest, ValuesAreKept) {
  rcViewport(3, 4, 30, 40);
  EXPECT_EQ(floats(RC_VIEWPORT, 4), (std::vector<float>{3, 4, 30, 40}));
  rcViewport(0, 0, 0, 0);
  EXPECT_EQ(floats(RC_VIEWPORT, 4), (std::vector<float>{0, 0, 0, 0}));
  rcFrustum(-1, 2, -3, 4, 5, 6);
  EXPECT_EQ(windowOf(*context), (std::vector<double>{-1, 2, -3, 4, 5}));
  rcFrustumf(-2, 3, -4, 5, 6, 1);
  EXPECT_EQ(windowOf(*context), (std::vector<double>{-2, 3, -4, 5, 6}));
  rcFrustumx(-kFixedOne, kFixedOne / 2, -kFixedOne, kFixedOne, kFixedOne / 4, kFixedOne);
  EXPECT_EQ(windowOf(*context), (std::vector<double>{-1, 0.5, -1, 1, 0.25}));
  rcuPerspective(90, 2, 3, 100);
  const std::vector<double> window = windowOf(*context);
  for (size_t i = 0; i < 5; ++i) EXPECT_NEAR(window[i], (std::vector<double>{-6, 6, -3, 3, 3})[i], 1e-5);
  EXPECT_CLEAN();
}

TEST_F(CameraTest, ViewportErrors) {
  EXPECT_RAISES(RC_INVALID_VALUE, rcViewport(0, 0, -1, 5));
  EXPECT_RAISES(RC_INVALID_VALUE, rcViewport(0, 0, 5, -1));
}

TEST_F(CameraTest, FrustumErrors) {
  const double values[][6] = {{-1, 1, -1, 1, 0, 10}, {-1, 1, -1, 1, -1, 10}, {-1, 1, -1, 1, 1, 0},
                              {-1, 1, -1, 1, 1, -1}, {-1, 1, -1, 1, 5, 5},   {2, 2, -1, 1, 1, 10},
                              {-1, 1, 2, 2, 1, 10}};
  for (const auto &v : values) {
    EXPECT_RAISES(RC_INVALID_VALUE, rcFrustum(v[0], v[1], v[2], v[3], v[4], v[5]));
    float f[6];
    RCfixed x[6];
    for (int i = 0; i < 6; ++i) {
      f[i] = static_cast<float>(v[i]);
      x[i] = static_cast<RCfixed>(v[i]) * kFixedOne;
    }
    EXPECT_RAISES(RC_INVALID_VALUE, rcFrustumf(f[0], f[1], f[2], f[3], f[4], f[5]));
    EXPECT_RAISES(RC_INVALID_VALUE, rcFrustumx(x[0], x[1], x[2], x[3], x[4], x[5]));
  }
  EXPECT_RAISES(RC_INVALID_VALUE, rcFrustumf(kNan, 1, -1, 1, 1, 10));
  EXPECT_RAISES(RC_INVALID_VALUE, rcFrustumf(-1, 1, -1, 1, kNan, 10));
  EXPECT_RAISES(RC_INVALID_VALUE, rcFrustumf(-1, kInf, -1, 1, 1, 10));
  EXPECT_RAISES(RC_INVALID_VALUE, rcFrustum(-1.5e308, 1.5e308, -1, 1, 1, 10));
}

TEST_F(CameraTest, PerspectiveErrors) {
  for (float fovy : {0.0f, -10.0f, 180.0f, 200.0f, kNan}) {
    EXPECT_RAISES(RC_INVALID_VALUE, rcuPerspective(fovy, 1, 1, 10));
  }
  for (float aspect : {0.0f, -1.0f, kNan, kInf}) EXPECT_RAISES(RC_INVALID_VALUE, rcuPerspective(60, aspect, 1, 10));
  EXPECT_RAISES(RC_INVALID_VALUE, rcuPerspective(60, 1, 0, 10));
  EXPECT_RAISES(RC_INVALID_VALUE, rcuPerspective(60, 1, -1, 10));
  EXPECT_RAISES(RC_INVALID_VALUE, rcuPerspective(60, 1, 1, 0));
  EXPECT_RAISES(RC_INVALID_VALUE, rcuPerspective(60, 1, 1, -1));
  EXPECT_RAISES(RC_INVALID_VALUE, rcuPerspective(60, 1, 7, 7));
}

TEST_F(CameraTest, LookAtErrors) {
  rcuLookAt(1, 2, 3, 4, 5, 7, 0, 1, 0);
  EXPECT_CLEAN();
  EXPECT_RAISES(RC_INVALID_VALUE, rcuLookAt(1, 2, 3, 1, 2, 3, 0, 1, 0));
  EXPECT_RAISES(RC_INVALID_VALUE, rcuLookAt(0, 0, 0, 0, 0, -1, 0, 0, 0));
  EXPECT_RAISES(RC_INVALID_VALUE, rcuLookAt(0, 0, 0, 0, 5, 0, 0, -2, 0));
  EXPECT_RAISES(RC_INVALID_VALUE, rcuLookAt(kNan, 0, 0, 0, 0, -1, 0, 1, 0));
  EXPECT_RAISES(RC_INVALID_VALUE, rcuLookAt(0, 0, 0, 0, kInf, -1, 0, 1, 0));
  EXPECT_RAISES(RC_INVALID_VALUE, rcuLookAt(0, 0, 0, 0, 0, -1, 0, kNan, 0));
}

TEST_F(CameraTest, LookAtMovesTheViewerAndNoMatrix) {
  rcuLookAt(5, 6, 7, 5, 6, -7, 0, 3, 0);
  EXPECT_EQ(context->state.view.camera.eye, Vec3(5, 6, 7));
  EXPECT_EQ(floats(RC_MODELVIEW_MATRIX, 16), kIdentity);
  EXPECT_EQ(floats(RC_PROJECTION_MATRIX, 16), kIdentity);
}

TEST_F(CameraTest, UpIsMadePerpendicularOnlyInTheGuidesProfile) {
  rcuLookAt(0, 0, 0, 0, 0, -1, 0, 1, 1);
  EXPECT_EQ(context->state.view.camera.up, Vec3(0, 1, 0));
  useProfile("1000");
  rcuLookAt(0, 0, 0, 0, 0, -1, 0, 1, 1);
  EXPECT_NEAR(context->state.view.camera.up.z, std::sqrt(0.5f), 1e-6);
  EXPECT_NEAR(context->state.view.camera.up.y, std::sqrt(0.5f), 1e-6);
}

TEST_F(CameraTest, ClearColourIsClamped) {
  rcClearColor(-1, 0.5f, 2, kNan);
  EXPECT_EQ(floats(RC_COLOR_CLEAR_VALUE, 4), (std::vector<float>{0, 0.5f, 1, 0}));
  rcClearColorx(-5, kFixedOne / 4, 3 * kFixedOne, kFixedOne);
  EXPECT_EQ(floats(RC_COLOR_CLEAR_VALUE, 4), (std::vector<float>{0, 0.25f, 1, 1}));
}

TEST_F(CameraTest, AnEmptyFrameShowsTheClearColour) {
  rcClearColor(0.25f, 0.5f, 1, 0);
  rcFinish();
  for (const auto &[x, y] : {std::pair{0, 0}, {kWidth - 1, kHeight - 1}, {20, 30}}) {
    EXPECT_EQ(pixel(x, y), (Colour{64, 128, 255}));
  }
}

// Column i passes l + (r - l) i / W: an edge at x = 10 belongs to the columns from 10 on.
TEST_F(CameraTest, TheSampleOfAPixelIsItsLowerLeftCorner) {
  pixelCamera();
  paint(1, 1, 1);
  drawQuad({9.75f, 19.75f, 20.25f, 30.25f});
  rcFinish();
  EXPECT_EQ(pixel(10, 20), (Colour{255, 255, 255}));
  EXPECT_EQ(pixel(20, 30), (Colour{255, 255, 255}));
  EXPECT_EQ(pixel(9, 20), kBlack);
  EXPECT_EQ(pixel(10, 19), kBlack);
  EXPECT_EQ(pixel(21, 30), kBlack);
  EXPECT_EQ(pixel(20, 31), kBlack);
}

TEST_F(CameraTest, NearAndFarClipNothing) {
  pixelCamera();
  paint(1, 0, 0);
  drawQuad({20, 15, 40, 30}, 60);  // at distance 4, the screen is at 64
  rcFrustumf(-32, 32, -24, 24, 64, 65);
  rcFinish();
  EXPECT_EQ(pixel(32, 24), (Colour{255, 0, 0}));
  drawQuad({-1e5f, -1e5f, 1e5f, 1e5f}, -5000);
  rcFinish();
  EXPECT_EQ(pixel(32, 24), (Colour{255, 0, 0}));
}

TEST_F(CameraTest, TheSameWindowNearerOrFartherShowsTheSame) {
  for (const double scale : {1.0, 0x1p-1060, 1e-300, 0x1p-100, 0x1p100, 1e300}) {
    pixelCamera();
    rcFrustum(-32 * scale, 32 * scale, -24 * scale, 24 * scale, 64 * scale, 100 * scale);
    paint(1, 1, 1);
    drawQuad({9.75f, 19.75f, 20.25f, 30.25f});
    rcFinish();
    EXPECT_EQ(pixel(15, 25), (Colour{255, 255, 255})) << scale;
    for (const auto &[x, y] : {std::pair{9, 25}, {21, 25}, {15, 19}, {15, 31}}) EXPECT_EQ(pixel(x, y), kBlack) << scale;
  }
  EXPECT_CLEAN();
}

TEST_F(CameraTest, OffCentreWindowsAreHonouredOrCentredByProfile) {
  for (const char *profile : {"guide", "1000", "mc"}) {
    useProfile(profile);
    pixelCamera();
    rcFrustumf(0, 64, -24, 24, 64, 100);
    paint(1, 1, 1);
    drawQuad({32.5f, 0, 63.5f, 48});
    rcFinish();
    const bool centred = profile != std::string("guide");
    EXPECT_EQ(pixel(10, 24) != kBlack, !centred) << profile;
    EXPECT_EQ(pixel(42, 24) != kBlack, centred) << profile;
  }
}

TEST_F(CameraTest, ProjectionMatrixLeavesTheCameraAlone) {
  pixelCamera();
  rcMatrixMode(RC_PROJECTION);
  rcScalef(0, 0, 0);
  paint(1, 1, 1);
  drawQuad({20, 15, 40, 30});
  rcFinish();
  EXPECT_EQ(pixel(32, 24), (Colour{255, 255, 255}));
}

TEST_F(CameraTest, ASmallViewportIsAtTheLowerLeft) {
  pixelCamera();
  rcViewport(7, 9, 32, 24);  // half the surface; x and y are not used
  rcClearColor(0, 0, 0.5f, 0);
  paint(1, 1, 1);
  drawQuad({-5, -5, 70, 55});
  rcFinish();
  EXPECT_EQ(pixel(0, 0), (Colour{255, 255, 255}));
  EXPECT_EQ(pixel(31, 23), (Colour{255, 255, 255}));
  EXPECT_EQ(pixel(32, 10), (Colour{0, 0, 128}));
  EXPECT_EQ(pixel(10, 24), (Colour{0, 0, 128}));
}

TEST_F(CameraTest, ALargeViewportIsCropped) {
  pixelCamera();
  rcViewport(0, 0, 2 * kWidth, 2 * kHeight);
  paint(1, 1, 1);
  drawQuad({10, 10, 20, 20});  // at twice the pixels now
  rcFinish();
  EXPECT_EQ(pixel(30, 30), (Colour{255, 255, 255}));
  EXPECT_EQ(pixel(15, 15), kBlack);
}

TEST_F(CameraTest, AnEmptyViewportShowsTheClearColour) {
  pixelCamera();
  rcViewport(0, 0, 0, 0);
  rcClearColor(0.5f, 0, 0, 0);
  drawQuad({-5, -5, 70, 55});
  rcFinish();
  EXPECT_EQ(pixel(0, 0), (Colour{128, 0, 0}));
  EXPECT_EQ(pixel(63, 47), (Colour{128, 0, 0}));
}

}  // namespace
}  // namespace rc::test
