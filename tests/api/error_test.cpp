// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Errors that no family of state shows by itself: memory that is not there, images, frames, the palette's matrices.
#include <functional>

#include "api/allocation_failure.h"
#include "api/context_fixture.h"

namespace rc::test {
namespace {

class ErrorTest : public ContextTest {
 protected:
  // Each allocation of the call fails once: it raises RC_OUT_OF_MEMORY, changes nothing and works the next time.
  void expectAllOrNothing(const char *name, const std::function<void()> &call) {
    for (int good = 0; good < 100; ++good) {
      const std::vector<double> before = snapshot();
      failAllocationAfter(good);
      call();
      const bool failed = allocationFailed();
      EXPECT_EQ(rcGetError(), RCenum(failed ? RC_OUT_OF_MEMORY : RC_NO_ERROR)) << name << ", allocation " << good;
      if (!failed) return;
      EXPECT_EQ(snapshot(), before) << name << ", allocation " << good << " changed the state";
    }
    ADD_FAILURE() << name << " never succeeded";
  }

  static constexpr RCubyte kTexels[32 * 32 * 4] = {};
};

TEST_F(ErrorTest, OutOfMemory) {
  RCuint names[2] = {7, 7};
  rcFinish();  // the copy below finds its picture traced
  EXPECT_RAISES(RC_OUT_OF_MEMORY, rcBindBuffer(starved(RC_ARRAY_BUFFER), 9));
  EXPECT_RAISES(RC_OUT_OF_MEMORY, rcBindTexture(starved(RC_TEXTURE_2D), 9));
  EXPECT_RAISES(RC_OUT_OF_MEMORY, rcGenBuffers(starved(2), names));
  EXPECT_RAISES(RC_OUT_OF_MEMORY, rcGenTextures(starved(2), names));
  EXPECT_RAISES(RC_OUT_OF_MEMORY,
                rcTexImage2D(starved(RC_TEXTURE_2D), 0, RC_RGB, 16, 16, 0, RC_RGB, RC_UNSIGNED_BYTE, kTexels));
  EXPECT_RAISES(RC_OUT_OF_MEMORY, rcCopyTexImage2D(starved(RC_TEXTURE_2D), 0, RC_RGB, 0, 0, 16, 16, 0));
  EXPECT_RAISES(RC_OUT_OF_MEMORY, rcCompressedTexImage2D(starved(RC_TEXTURE_2D), 0, RC_PALETTE8_RGB8_OES, 16, 16, 0,
                                                         256 * 3 + 256, kTexels));
  EXPECT_EQ(names[0], 7u);
}

TEST_F(ErrorTest, EveryAllocationMayFail) {
  expectAllOrNothing("rcBindBuffer", [] { rcBindBuffer(RC_ARRAY_BUFFER, 9); });
  expectAllOrNothing("rcBindTexture", [] { rcBindTexture(RC_TEXTURE_2D, 9); });
  expectAllOrNothing("rcTexImage2D",
                     [] { rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGBA, 32, 32, 0, RC_RGBA, RC_UNSIGNED_BYTE, kTexels); });
  expectAllOrNothing("rcTexSubImage2D",
                     [] { rcTexSubImage2D(RC_TEXTURE_2D, 0, 3, 3, 9, 9, RC_RGBA, RC_UNSIGNED_BYTE, kTexels + 7); });
  expectAllOrNothing("rcCompressedTexImage2D", [] {
    rcCompressedTexImage2D(RC_TEXTURE_2D, 0, RC_PALETTE8_RGB8_OES, 16, 16, 0, 256 * 3 + 256, kTexels);
  });
  expectAllOrNothing("rcBufferData", [] { rcBufferData(RC_ARRAY_BUFFER, 4096, kTexels, RC_STATIC_DRAW); });
  rcBindBuffer(RC_ARRAY_BUFFER, 0);
  expectAllOrNothing("rcBindMaterial", [] { rcBindMaterial(17); });
  expectAllOrNothing("a draw", [this] { drawQuad({0, 0, 9, 9}); });
}

// One name is made or none, whichever allocation fails.
TEST_F(ErrorTest, GeneratedNamesAreWhole) {
  RCuint name = 0;
  expectAllOrNothing("rcGenBuffers", [&] { rcGenBuffers(1, &name); });
  expectAllOrNothing("rcGenTextures", [&] { rcGenTextures(1, &name); });
  EXPECT_TRUE(rcIsTexture(name));
}

TEST_F(ErrorTest, Images) {
  loadSolid({1, 2, 3});
  constexpr RCenum kByte = RC_UNSIGNED_BYTE;
  EXPECT_RAISES(RC_INVALID_ENUM, rcTexImage2D(kNoToken, 0, RC_RGB, 16, 16, 0, RC_RGB, kByte, kTexels));
  EXPECT_RAISES(RC_INVALID_VALUE, rcTexImage2D(RC_TEXTURE_2D, 1, RC_RGB, 16, 16, 0, RC_RGB, kByte, kTexels));
  EXPECT_RAISES(RC_INVALID_VALUE, rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGB, 12, 16, 0, RC_RGB, kByte, kTexels));
  EXPECT_RAISES(RC_INVALID_OPERATION, rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGBA, 16, 16, 0, RC_RGB, kByte, kTexels));
}

TEST_F(ErrorTest, MatricesOfAPaletteThatIsOff) {
  const RCfixed fixed[16] = {};
  rcEnable(RC_MATRIX_PALETTE_OES);
  rcMatrixMode(RC_MATRIX_PALETTE_OES);
  rcDisable(RC_MATRIX_PALETTE_OES);
  EXPECT_CLEAN();
  EXPECT_RAISES(RC_INVALID_OPERATION, rcLoadMatrixx(fixed));
  EXPECT_RAISES(RC_INVALID_OPERATION, rcMultMatrixx(fixed));
}

// The one failing call that changes something: the static scene is given up, and a frame without it is traced.
TEST_F(ErrorTest, FinishWithinTheStaticScene) {
  const auto inStaticScene = [&] { return context->scene.inStaticScene(); };
  rcStaticSceneBegin();
  const uint64_t changes = context->objects().changes;
  const auto beginAgain = [&] {
    EXPECT_FALSE(inStaticScene());
    rcStaticSceneBegin();
    context->objects().changes = changes;
  };
  EXPECT_RAISES(RC_INVALID_OPERATION, rcFinish(), beginAgain());
  EXPECT_RAISES(RC_INVALID_OPERATION, rcFlush(), beginAgain());
  EXPECT_TRUE(inStaticScene());
}

}  // namespace
}  // namespace rc::test
