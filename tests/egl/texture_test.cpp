// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Pbuffers as textures, textures as images, and what configs do to pixels. [EGL 1.5, 3.6, 3.9]
#include <array>
#include <cmath>
#include <thread>

#include "RC/rcu.h"
#include "egl/display.h"
#include "egl/egl_fixture.h"

namespace rc::test {
namespace {

using Colour = std::array<int, 3>;

class Textures : public Egl {
 protected:
  // What the library keeps of a surface. Rows from the top.
  hal::Target pictureOf(EGLSurface surface) {
    egl::threadState().awaitPicture();
    return egl::findDisplay(mDisplay)->surfaces.find(surface)->picture();
  }
  Colour pixel(EGLSurface surface, int x, int y) {
    const hal::Target picture = pictureOf(surface);
    const uint32_t rgba = picture.pixels[y * picture.width + x];
    return {int(rgba & 255), int(rgba >> 8 & 255), int(rgba >> 16 & 255)};
  }
  EGLSurface texturable(EGLConfig config, EGLint format, EGLint mipmaps = EGL_FALSE) {
    return pbufferOf(config, {EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_TEXTURE_FORMAT, format, EGL_TEXTURE_TARGET,
                              EGL_TEXTURE_2D, EGL_MIPMAP_TEXTURE, mipmaps});
  }
  // A picture whose lower half is green and whose upper half is blue: the surface plus a quad.
  void drawTwoColours(EGLSurface surface) {
    rcClearColor(0, 0, 1, 1);
    drawQuad(-1, -1, 1, 0, false);
    ASSERT_TRUE(eglSwapBuffers(mDisplay, surface));
  }
  // On the plane z = -1 of an eye that sees -1 ... 1 of it, lit fully.
  void drawQuad(float left, float bottom, float right, float top, bool textured) {
    rcMatrixMode(RC_PROJECTION);
    rcLoadIdentity();
    rcFrustumf(-1, 1, -1, 1, 1, 10);
    rcMatrixMode(RC_MODELVIEW);
    const float vertices[] = {left, bottom, -1, right, bottom, -1, left, top, -1, right, top, -1};
    const float corners[] = {0, 0, 1, 0, 0, 1, 1, 1};
    const float green[] = {0, 1, 0, 1}, black[] = {0, 0, 0, 1}, white[] = {1, 1, 1, 1};
    rcMaterialfv(RC_FRONT_AND_BACK, RC_EMISSION, textured ? black : green);
    rcMaterialfv(RC_FRONT_AND_BACK, RC_AMBIENT_AND_DIFFUSE, textured ? white : black);
    rcMaterialfv(RC_FRONT_AND_BACK, RC_SPECULAR, black);
    rcEnable(RC_LIGHTING);
    rcEnable(RC_LIGHT0);
    rcLightfv(RC_LIGHT0, RC_AMBIENT, white);
    rcLightfv(RC_LIGHT0, RC_DIFFUSE, black);
    rcEnableClientState(RC_VERTEX_ARRAY);
    rcEnableClientState(RC_TEXTURE_COORD_ARRAY);
    rcVertexPointer(3, RC_FLOAT, 0, vertices);
    rcTexCoordPointer(2, RC_FLOAT, 0, corners);
    rcDrawArrays(RC_TRIANGLE_STRIP, 0, 4);
  }
};

TEST_F(Textures, APbufferIsSeenOnAQuadTheRightWayUp) {
  const EGLSurface source = texturable(mConfig, EGL_TEXTURE_RGB), target = pbuffer(32, 32);
  const EGLContext made = context();
  ASSERT_TRUE(eglMakeCurrent(mDisplay, source, source, made));
  drawTwoColours(source);
  EXPECT_EQ(pixel(source, 8, 2), (Colour{0, 0, 255}));
  EXPECT_EQ(pixel(source, 8, 13), (Colour{0, 255, 0}));

  ASSERT_TRUE(eglMakeCurrent(mDisplay, target, target, made));
  rcViewport(0, 0, 32, 32);
  rcTextureAlpha(255);
  rcBindTexture(RC_TEXTURE_2D, 5);
  rcEnable(RC_TEXTURE_2D);
  ASSERT_TRUE(eglBindTexImage(mDisplay, source, EGL_BACK_BUFFER));
  rcClearColor(1, 0, 0, 1);
  drawQuad(-1, -1, 1, 1, true);
  ASSERT_TRUE(eglSwapBuffers(mDisplay, target));
  EXPECT_EQ(pixel(target, 16, 4), (Colour{0, 0, 255}));
  EXPECT_EQ(pixel(target, 16, 28), (Colour{0, 255, 0}));
  EXPECT_EQ(rcGetError(), RCenum(RC_NO_ERROR));

  EXPECT_FALSE(eglBindTexImage(mDisplay, source, EGL_BACK_BUFFER)) << "it is in a texture";
  expectError(EGL_BAD_ACCESS);
  EXPECT_TRUE(eglReleaseTexImage(mDisplay, source, EGL_BACK_BUFFER));
  EXPECT_TRUE(eglReleaseTexImage(mDisplay, source, EGL_BACK_BUFFER)) << "once more does nothing";
  EXPECT_TRUE(eglBindTexImage(mDisplay, source, EGL_BACK_BUFFER));
}

TEST_F(Textures, APbufferThatAnotherThreadDrawsToIsRefused) {
  const EGLSurface source = texturable(mConfig, EGL_TEXTURE_RGB), target = pbuffer(32, 32);
  ASSERT_TRUE(eglMakeCurrent(mDisplay, source, source, context()));
  std::thread([&] {
    ASSERT_TRUE(eglMakeCurrent(mDisplay, target, target, context()));
    EXPECT_FALSE(eglBindTexImage(mDisplay, source, EGL_BACK_BUFFER));
    expectError(EGL_BAD_ACCESS);
    ASSERT_TRUE(eglReleaseThread());
  }).join();
  EXPECT_TRUE(eglBindTexImage(mDisplay, source, EGL_BACK_BUFFER)) << "its own thread may";
}

TEST_F(Textures, ATextureThatIsLoadedAnewLetsGo) {
  const EGLSurface source = texturable(mConfig, EGL_TEXTURE_RGB);
  ASSERT_TRUE(eglMakeCurrent(mDisplay, source, source, context()));
  rcBindTexture(RC_TEXTURE_2D, 5);
  ASSERT_TRUE(eglBindTexImage(mDisplay, source, EGL_BACK_BUFFER));
  const std::vector<RCubyte> texels(16 * 16 * 3, 100);
  rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGB, 16, 16, 0, RC_RGB, RC_UNSIGNED_BYTE, texels.data());
  EXPECT_TRUE(eglBindTexImage(mDisplay, source, EGL_BACK_BUFFER));
  rcBindTexture(RC_TEXTURE_2D, 0);
  const RCuint name = 5;
  rcDeleteTextures(1, &name);
  EXPECT_TRUE(eglDestroySurface(mDisplay, source));
}

// The memory of the pbuffer's image may come back for one that the program loads: that one is not the pbuffer's.
TEST_F(Textures, ReleasingLeavesAnImageOfTheProgramAlone) {
  const EGLSurface source = texturable(mConfig, EGL_TEXTURE_RGB);
  ASSERT_TRUE(eglMakeCurrent(mDisplay, source, source, context()));
  rcBindTexture(RC_TEXTURE_2D, 5);
  const auto texture = api::currentContext()->objects().textures.find(5);
  const std::vector<RCubyte> texels(16 * 16 * 3, 100);
  for (int round = 0; round < 4; ++round) {
    ASSERT_TRUE(eglBindTexImage(mDisplay, source, EGL_BACK_BUFFER));
    for (int load = 0; load <= round; ++load) {
      rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGB, 16, 16, 0, RC_RGB, RC_UNSIGNED_BYTE, texels.data());
    }
    EXPECT_TRUE(eglReleaseTexImage(mDisplay, source, EGL_BACK_BUFFER));
    ASSERT_TRUE(texture->loaded()) << "after " << round + 1 << " loads";
    EXPECT_EQ(texture->image->levels[0][0] & 255, 100u);
  }
  ASSERT_TRUE(eglBindTexImage(mDisplay, source, EGL_BACK_BUFFER));
  EXPECT_TRUE(eglReleaseTexImage(mDisplay, source, EGL_BACK_BUFFER));
  EXPECT_FALSE(texture->loaded());
}

TEST_F(Textures, AnImageOfATextureThatAPbufferIsIn) {
  const EGLSurface source = texturable(mConfig, EGL_TEXTURE_RGB);
  const EGLContext made = context();
  ASSERT_TRUE(eglMakeCurrent(mDisplay, source, source, made));
  rcBindTexture(RC_TEXTURE_2D, 5);
  ASSERT_TRUE(eglBindTexImage(mDisplay, source, EGL_BACK_BUFFER));
  EXPECT_FALSE(eglCreateImage(mDisplay, made, EGL_GL_TEXTURE_2D, EGLClientBuffer(5), nullptr));
  expectError(EGL_BAD_ACCESS);
}

TEST_F(Textures, MipLevelsAndAlpha) {
  const EGLSurface source = texturable(choose({EGL_ALPHA_SIZE, 8}), EGL_TEXTURE_RGBA, EGL_TRUE);
  ASSERT_TRUE(eglMakeCurrent(mDisplay, source, source, context(choose({EGL_ALPHA_SIZE, 8}))));
  rcBindTexture(RC_TEXTURE_2D, 5);
  ASSERT_TRUE(eglBindTexImage(mDisplay, source, EGL_BACK_BUFFER));
  const auto &image = api::currentContext()->objects().textures.find(5)->image;
  EXPECT_EQ(image->levels.size(), 5u);
  EXPECT_EQ(image->levels[0][0] >> 24, 255u) << "the surface's alpha, not rcTextureAlpha's";
}

TEST_F(Textures, NothingIsBoundWithoutAContext) {
  EXPECT_TRUE(eglBindTexImage(mDisplay, texturable(mConfig, EGL_TEXTURE_RGB), EGL_BACK_BUFFER));
}

TEST_F(Textures, ImagesOfTextures) {
  const EGLSurface surface = pbuffer();
  const EGLContext made = context();
  ASSERT_TRUE(eglMakeCurrent(mDisplay, surface, surface, made));
  const auto image = [&](uintptr_t name, const EGLAttrib *attributes) {
    return eglCreateImage(mDisplay, made, EGL_GL_TEXTURE_2D, EGLClientBuffer(name), attributes);
  };
  rcBindTexture(RC_TEXTURE_2D, 7);
  EXPECT_FALSE(image(7, nullptr)) << "nothing was loaded";
  expectError(EGL_BAD_PARAMETER);
  const std::vector<RCubyte> texels(16 * 16 * 3, 100);
  rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGB, 16, 16, 0, RC_RGB, RC_UNSIGNED_BYTE, texels.data());
  const EGLAttrib tooDeep[] = {EGL_GL_TEXTURE_LEVEL, 9, EGL_NONE};
  EXPECT_FALSE(image(7, tooDeep));
  expectError(EGL_BAD_MATCH);
  const EGLAttrib level1[] = {EGL_GL_TEXTURE_LEVEL, 1, EGL_IMAGE_PRESERVED, EGL_TRUE, EGL_NONE};
  const EGLImage first = image(7, level1);
  ASSERT_TRUE(first);
  EXPECT_FALSE(image(7, nullptr)) << "it is the sibling of an image";
  expectError(EGL_BAD_ACCESS);
  EXPECT_TRUE(eglDestroyImage(mDisplay, first));
  EXPECT_FALSE(eglDestroyImage(mDisplay, first));
  expectError(EGL_BAD_PARAMETER);
  const EGLImage second = image(7, nullptr);
  ASSERT_TRUE(second);
  EXPECT_TRUE(eglDestroyContext(mDisplay, made));
  eglReleaseThread();
  EXPECT_TRUE(eglDestroyImage(mDisplay, second)) << "an image outlives its context";
}

TEST_F(Textures, FiveSixFive) {
  const EGLConfig config = choose({EGL_BUFFER_SIZE, 16});
  ASSERT_EQ(valueOf(config, EGL_RED_SIZE), 5);
  const EGLSurface surface = pbufferOf(config, {EGL_WIDTH, 4, EGL_HEIGHT, 4});
  ASSERT_TRUE(eglMakeCurrent(mDisplay, surface, surface, context(config)));
  rcClearColor(100.5f / 256, 100.5f / 256, 1, 1);
  ASSERT_TRUE(eglSwapBuffers(mDisplay, surface));
  EXPECT_EQ(pixel(surface, 0, 0), (Colour{99, 101, 255})) << "12 of 31, 25 of 63, 31 of 31";
}

TEST_F(Textures, MultisamplingCanBeSwitchedOff) {
  const EGLConfig config = choose({EGL_RED_SIZE, 8, EGL_SAMPLES, 8});
  const EGLSurface surface = pbufferOf(config, {EGL_WIDTH, 10, EGL_HEIGHT, 10});
  ASSERT_TRUE(eglMakeCurrent(mDisplay, surface, surface, context(config)));
  const auto rays = [] {
    RCint count = 0;
    rcFinish();
    rcGetIntegerv(RC_FRAME_RAYS, &count);
    return count;
  };
  EXPECT_EQ(rays(), 800) << "on from the start";
  rcDisable(RC_MULTISAMPLE);
  EXPECT_EQ(rays(), 100);
  rcEnable(RC_MULTISAMPLE);
  EXPECT_EQ(rays(), 800);
}

// An edge of slope 0.37 through a white half plane on black: how much of a pixel is white is known exactly.
class Coverage : public Textures, public testing::WithParamInterface<EGLint> {};

TEST_P(Coverage, AnEdgeOfKnownSlope) {
  const EGLint samples = GetParam();
  constexpr int kSide = 32;
  const EGLConfig config = choose({EGL_RED_SIZE, 8, EGL_SAMPLES, samples});
  ASSERT_EQ(valueOf(config, EGL_SAMPLES), samples);
  const EGLSurface surface = pbufferOf(config, {EGL_WIDTH, kSide, EGL_HEIGHT, kSide});
  ASSERT_TRUE(eglMakeCurrent(mDisplay, surface, surface, context(config)));
  rcMatrixMode(RC_PROJECTION);
  rcLoadIdentity();
  rcFrustumf(0, kSide, 0, kSide, 1, 10);  // a pixel is a unit of the plane z = -1
  rcMatrixMode(RC_MODELVIEW);
  const auto edge = [](double x) { return 10.3 + 0.37 * x; };
  const float far = 3 * kSide;
  const float vertices[] = {-far, -far, -1, far, -far, -1, far, float(edge(far)), -1, -far, float(edge(-far)), -1};
  const float white[] = {1, 1, 1, 1}, black[] = {0, 0, 0, 1};
  rcClearColor(0, 0, 0, 1);
  rcMaterialfv(RC_FRONT_AND_BACK, RC_EMISSION, white);
  rcMaterialfv(RC_FRONT_AND_BACK, RC_AMBIENT_AND_DIFFUSE, black);
  rcEnableClientState(RC_VERTEX_ARRAY);
  rcVertexPointer(3, RC_FLOAT, 0, vertices);
  rcDrawArrays(RC_TRIANGLE_FAN, 0, 4);
  ASSERT_TRUE(eglSwapBuffers(mDisplay, surface));
  double error = 0;
  int partly = 0;
  for (int x = 0; x < kSide; ++x) {
    for (int row = 0; row < kSide; ++row) {
      double inside = 0;
      for (int i = 0; i < 64; ++i) inside += std::clamp(edge(x + (i + 0.5) / 64) - row, 0.0, 1.0) / 64;
      const int level = pixel(surface, x, kSide - 1 - row)[0];
      const double share = level / 255.0;
      ASSERT_NEAR(share, inside, samples == 0 ? 1 : samples == 4 ? 0.3 : 0.2) << x << ", " << row;
      const double step = share * std::max(samples, 1);
      ASSERT_NEAR(step, std::round(step), 0.1) << "so many of " << samples << " samples";
      error += std::abs(share - inside);
      partly += inside > 0.01 && inside < 0.99;
    }
  }
  ASSERT_GT(partly, kSide / 2);
  const double mean = error / partly;
  RecordProperty("mean_error_of_coverage", std::to_string(mean));
  EXPECT_LT(mean, samples == 0 ? 0.5 : samples == 4 ? 0.12 : samples == 8 ? 0.075 : 0.045);
  EXPECT_GT(mean, samples == 0 ? 0.15 : 0.001) << "so few samples cannot know better";
}

INSTANTIATE_TEST_SUITE_P(Samples, Coverage, testing::Values(0, 4, 8, 16));

}  // namespace
}  // namespace rc::test
