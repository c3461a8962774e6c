// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// context_fixture.h: a context with a small picture in memory, and what the tests of the C API share.
//
// pixelCamera() makes world coordinates at z = 0 equal to pixels counted from the lower left corner.
// With paint() and the light that shines when no other does, a surface shows exactly its ambient colour.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "RC/rc.h"
#include "RC/rcu.h"
#include "api/context.h"

namespace rc::test {

inline constexpr int kWidth = 64, kHeight = 48;
inline constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
inline constexpr float kInf = std::numeric_limits<float>::infinity();
inline constexpr RCfixed kFixedOne = 0x10000;
inline constexpr RCenum kNoToken = 0x7A7A;  // no token has this value

using Colour = std::array<int, 3>;
inline constexpr Colour kBlack{0, 0, 0}, kWhite{255, 255, 255}, kRed{200, 0, 0}, kBlue{0, 0, 200};
inline constexpr uint32_t kUntouched = 0x00123456;  // no traced pixel has alpha 0

// Pixels 10 to 30 on both axes, as a fan.
inline constexpr float kSquare[] = {10, 10, 0, 30, 10, 0, 30, 30, 0, 10, 30, 0};

// An offset into a bound buffer, as the API wants it.
inline const RCvoid *offset(size_t bytes) { return reinterpret_cast<const RCvoid *>(bytes); }

// A picture in memory. fill() marks all pixels, so that a test sees whether a frame was traced.
class MemorySurface : public api::DrawSurface {
 public:
  MemorySurface(int initialWidth, int initialHeight) { resize(initialWidth, initialHeight); }

  hal::Target backBuffer() override { return {pixels.data(), width, height}; }
  void resize(int newWidth, int newHeight);
  void fill(uint32_t value) { std::fill(pixels.begin(), pixels.end(), value); }

  std::vector<uint32_t> pixels;
  int width = 0, height = 0;
};

class ContextTest : public testing::Test {
 protected:
  void SetUp() override { useProfile("guide"); }
  void TearDown() override;

  // A new context with this profile becomes current.
  void useProfile(const std::string &profile);
  // A new context with these settings, on one thread, becomes current.
  void useSettings(Settings settings);

  void pixelCamera();
  // Flat colour for the bound material.
  void paint(float red, float green, float blue);
  // Diffuse colour only: black without lightFrom().
  void paintDiffuse(float red, float green, float blue);
  // LIGHT0 alone, only its diffuse colour; w = 0 for a direction.
  void lightFrom(float x, float y, float z, float w, float diffuse);

  struct Rect {
    float x0, y0, x1, y1;
  };
  // A quad at the depth z in front of or behind the picture plane; its pointers are gone afterwards.
  void drawQuad(const Rect &rect, float z = 0);
  // Its front looks away from the eye of pixelCamera().
  void drawClockwiseQuad(const Rect &rect, float z = 0);
  // Four floats for each vertex, counter-clockwise from x0, y0.
  void drawColouredQuad(const Rect &rect, const std::vector<float> &colours, float z = 0);
  // Texture coordinates go from (0, 0) at x0, y0 to (u, v) at x1, y1.
  void drawTexturedQuad(const Rect &rect, float u = 1, float v = 1, float z = 0);
  // Triangles of three floats a vertex.
  void drawTriangles(const std::vector<float> &vertices);

  // Loads a 16 x 16 image into the current texture: `low` where the column is below 8, `high` elsewhere.
  void loadColumns(const Colour &low, const Colour &high);
  void loadSolid(const Colour &colour) { loadColumns(colour, colour); }
  // The same of RGBA texels.
  void loadRgba(int red, int green, int blue, int alpha);

  // The picture of what was drawn; the next draw call begins the next frame.
  void trace();
  Colour pixel(int x, int yFromBottom) const;

  RCint integer(RCenum pname) const;
  std::vector<float> floats(RCenum pname, size_t count) const;
  std::vector<float> material(RCenum pname, size_t count) const;
  float materialScalar(RCenum pname) const { return material(pname, 1)[0]; }
  std::vector<float> light(RCenum name, RCenum pname, size_t count) const;
  RCint texParameter(RCenum pname, RCenum target = RC_TEXTURE_2D) const;
  std::array<float, 16> modelview() const;
  std::vector<float> clipPlane(RCenum plane) const;
  std::vector<float> texEnv(RCenum pname, size_t count, RCenum target = RC_TEXTURE_ENV) const;

  // What is wrong with the text of the last error: empty where it names the function, the error and, if a value was
  // refused, the argument. In error_text.cpp.
  std::string flawOfText(RCenum error) const;

  // Everything a program can ask for and what it can only see in pictures, one number after the other.
  // In context_snapshot.cpp.
  std::vector<double> snapshot() const;

  MemorySurface surface{kWidth, kHeight};
  std::unique_ptr<api::Context> context;
  std::string message;  // of the last error
};

inline const std::vector<float> kIdentity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

// The call raises exactly this error, once, with a text that helps, and changes nothing.
#define EXPECT_RAISES(error, ...)                                        \
  do {                                                                   \
    const std::vector<double> before_ = snapshot();                      \
    __VA_ARGS__;                                                         \
    EXPECT_EQ(rcGetError(), static_cast<RCenum>(error)) << #__VA_ARGS__; \
    EXPECT_EQ(rcGetError(), RCenum(RC_NO_ERROR)) << #__VA_ARGS__;        \
    EXPECT_EQ(flawOfText(error), "") << #__VA_ARGS__;                    \
    EXPECT_EQ(snapshot(), before_) << #__VA_ARGS__ " changed the state"; \
  } while (false)

#define EXPECT_CLEAN() EXPECT_EQ(rcGetError(), RCenum(RC_NO_ERROR))

}  // namespace rc::test
