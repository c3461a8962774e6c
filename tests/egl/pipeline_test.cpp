// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// A swapped picture is traced while the program goes on: whatever it does meanwhile is seen in the next one only.
#include <sys/wait.h>
#include <unistd.h>

#include <thread>

#include "egl/small_program.h"

namespace rc::test {
namespace {

constexpr int kPictures = 8;
constexpr RCuint kTexture = 5, kMaterial = 3;

class Pipeline : public SmallProgram {
 protected:
  void SetUp() override {
    SmallProgram::SetUp();
    mDrawable = drawable();
    ASSERT_TRUE(select(mDrawable));
  }

  // All that a picture depends on, chosen by a number, drawn but not traced.
  static void drawFrame(int number) {
    const float share = float(number % 5) / 5;
    const float colour[] = {share, 1 - share, 0.5f, 1}, white[] = {1, 1, 1, 1};
    rcMatrixMode(RC_MODELVIEW);
    rcLoadIdentity();
    rcBindMaterial(0);
    rcMaterialfv(RC_FRONT_AND_BACK, RC_AMBIENT_AND_DIFFUSE, colour);
    rcLightfv(RC_LIGHT0, RC_DIFFUSE, white);
    rcLightfv(RC_LIGHT0, RC_POSITION, std::array{share, 2.0f, 1.0f, 1.0f}.data());
    loadTexture(RCubyte(40 * (number % 6)));
    drawSheet(0.1f * share);
    rcBindMaterial(kMaterial);
    rcEnable(RC_TEXTURE_2D);
    rcBindTexture(RC_TEXTURE_2D, kTexture);
    rcTranslatef(0.3f, 0.2f + share, 0);
    rcScalef(0.3f, 0.3f, 0.3f);
    drawSheet(share);
  }

  // What must not be seen in the picture that was swapped before.
  void meddle() {
    const float red[] = {1, 0, 0, 1};
    const std::vector<RCubyte> texels(16 * 16 * 3, 255);
    rcBindMaterial(kMaterial);
    rcMaterialfv(RC_FRONT_AND_BACK, RC_EMISSION, red);
    rcTexSubImage2D(RC_TEXTURE_2D, 0, 4, 4, 8, 8, RC_RGB, RC_UNSIGNED_BYTE, texels.data());
    rcMaterialfv(RC_FRONT_AND_BACK, RC_EMISSION, std::array{0.0f, 0.0f, 0.0f, 1.0f}.data());
    loadTexture(255);
    rcDeleteTextures(1, &kTexture);
    rcLightfv(RC_LIGHT0, RC_DIFFUSE, red);
    rcClearColor(1, 1, 1, 1);
    rcViewport(0, 0, kSide / 2, kSide / 2);
    drawSheet(1);
  }

  static void drawSheet(float height) {
    rcClearColor(0.2f, 0.3f, 0.4f, 1);
    rcViewport(0, 0, kSide, kSide);
    rcuPerspective(50, 1, 0.1f, 100);
    rcuLookAt(0.3f, 1.5f, 2.5f, 0, 0, 0, 0, 1, 0);
    rcEnable(RC_LIGHTING);
    rcEnable(RC_LIGHT0);
    rcEnableClientState(RC_VERTEX_ARRAY);
    rcEnableClientState(RC_TEXTURE_COORD_ARRAY);
    const float vertices[] = {-1, height, -1, -1, 0, 1, 1, height, -1, 1, 0, 1}, corners[] = {0, 1, 0, 0, 1, 1, 1, 0};
    rcVertexPointer(3, RC_FLOAT, 0, vertices);
    rcTexCoordPointer(2, RC_FLOAT, 0, corners);
    rcDrawArrays(RC_TRIANGLE_STRIP, 0, 4);
  }
  static void loadTexture(RCubyte level) {
    std::vector<RCubyte> texels(16 * 16 * 3);
    for (size_t i = 0; i < texels.size(); ++i) texels[i] = RCubyte(i % 2 ? level : 255 - level);
    rcBindTexture(RC_TEXTURE_2D, kTexture);
    rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGB, 16, 16, 0, RC_RGB, RC_UNSIGNED_BYTE, texels.data());
  }
  static Picture read() {
    Picture picture{};
    rcReadPixels(0, 0, kSide, kSide, RC_RGBA, RC_UNSIGNED_BYTE, picture.data());
    EXPECT_EQ(rcGetError(), RCenum(RC_NO_ERROR));
    return picture;
  }
  // Of the surface as the swapped picture left it, without another trace; rows from the bottom.
  static Picture shown(const egl::Current &current = egl::threadState().current) {
    egl::threadState().awaitPicture();
    const hal::Target target = current.draw->picture();
    Picture picture{};
    for (size_t row = 0; row < kSide; ++row) {
      std::copy_n(target.pixels + (kSide - 1 - row) * kSide, kSide, picture.begin() + std::ptrdiff_t(row * kSide));
    }
    return picture;
  }
  // The pictures of frames that are waited for before anything else is done.
  std::vector<Picture> truth() {
    std::vector<Picture> pictures;
    for (int i = 0; i < kPictures; ++i) {
      drawFrame(i);
      rcFinish();
      pictures.push_back(read());
      EXPECT_TRUE(eglSwapBuffers(mDisplay, mDrawable.surface));
    }
    return pictures;
  }
  void swap() { ASSERT_TRUE(eglSwapBuffers(mDisplay, mDrawable.surface)); }

  Drawable mDrawable{};
};

TEST_F(Pipeline, WhatIsChangedMeanwhileIsNotSeen) {
  const std::vector<Picture> expected = truth();
  EXPECT_NE(expected[0], expected[1]);
  for (int i = 0; i < kPictures; ++i) {
    drawFrame(i);
    swap();
    meddle();
    ASSERT_EQ(shown(), expected[size_t(i)]) << i;
    rcSceneAllInit();  // what was drawn meanwhile is no part of the next frame
  }
  EXPECT_EQ(rcGetError(), RCenum(RC_NO_ERROR));
}

// Nothing waits in between but the swaps themselves.
TEST_F(Pipeline, FramesInARow) {
  const std::vector<Picture> expected = truth();
  for (int i = 0; i < kPictures; ++i) {
    drawFrame(i);
    swap();
  }
  EXPECT_EQ(shown(), expected.back());
}

TEST_F(Pipeline, AStaticSceneIsReplacedOnceItIsNoLongerNeeded) {
  const auto declare = [](float height) {
    rcStaticSceneBegin();
    drawSheet(height);
    rcStaticSceneEnd();
  };
  std::vector<Picture> expected;
  for (const bool waits : {true, false}) {
    for (int i = 0; i < kPictures; ++i) {
      declare(0.1f * float(i));
      swap();
      if (waits) {
        expected.push_back(shown());
      } else {
        i % 2 ? declare(-0.5f) : rcSceneAllInit();
        ASSERT_EQ(shown(), expected[size_t(i)]) << i;
      }
    }
  }
  EXPECT_NE(expected[0], expected[1]);
}

TEST_F(Pipeline, ReadingAndAskingWait) {
  drawFrame(1);
  swap();
  RCint triangles = 0, rays = 0;
  rcGetIntegerv(RC_FRAME_TRIANGLES, &triangles);
  rcGetIntegerv(RC_FRAME_RAYS_PRIMARY, &rays);
  EXPECT_EQ(triangles, 4);
  EXPECT_EQ(rays, kSide * kSide);
}

TEST_F(Pipeline, WhatWasSwappedCanBeRead) {
  const std::vector<Picture> expected = truth();
  drawFrame(2);
  swap();
  EXPECT_EQ(read(), expected[2]) << "the buffer is preserved";
  rcEnable(RC_LIGHT1);
  Picture empty{};
  empty.fill(read()[0]);
  EXPECT_EQ(read(), empty) << "what moves has ended with its frame, so another one shows nothing of it";
}

// What other contexts of a share group change asks for no other picture of it either.
TEST_F(Pipeline, WhatWasSwappedCanBeReadThoughOthersChangeTheirs) {
  const std::vector<Picture> expected = truth();
  const EGLContext other = eglCreateContext(mDisplay, mConfig, mDrawable.context, nullptr);
  drawFrame(2);
  swap();
  std::thread([&] {
    ASSERT_TRUE(select({pbuffer(kSide, kSide), other}));
    rcClearColor(1, 0, 0, 1);
    ASSERT_TRUE(eglReleaseThread());
  }).join();
  EXPECT_EQ(read(), expected[2]);
}

// The usual way not to run ahead of the pictures.
TEST_F(Pipeline, WaitingForAFenceBehindASwapMakesNoOtherPicture) {
  drawFrame(1);
  swap();
  const EGLSync fence = eglCreateSync(mDisplay, EGL_SYNC_FENCE, nullptr);
  EXPECT_EQ(eglClientWaitSync(mDisplay, fence, EGL_SYNC_FLUSH_COMMANDS_BIT, EGL_FOREVER), EGL_CONDITION_SATISFIED);
  RCint triangles = 0;
  rcGetIntegerv(RC_FRAME_TRIANGLES, &triangles);
  EXPECT_EQ(triangles, 4);
  EXPECT_TRUE(eglDestroySync(mDisplay, fence));
}

TEST_F(Pipeline, AFenceBehindASwapIsPassedByItself) {
  for (int i = 0; i < kPictures; ++i) {
    drawFrame(i);
    swap();
    const EGLSync fence = eglCreateSync(mDisplay, EGL_SYNC_FENCE, nullptr);
    // The thread of the context does nothing about it.
    std::thread other([&] { EXPECT_EQ(eglClientWaitSync(mDisplay, fence, 0, EGL_FOREVER), EGL_CONDITION_SATISFIED); });
    other.join();
    EXPECT_TRUE(eglDestroySync(mDisplay, fence));
  }
}

TEST_F(Pipeline, AnotherSurfaceTakesItsPlace) {
  const std::vector<Picture> expected = truth();
  const egl::Current first = egl::threadState().current;
  for (int i = 0; i < kPictures; ++i) {
    drawFrame(i);
    swap();
    ASSERT_TRUE(select({pbuffer(kSide, kSide), mDrawable.context}));
    ASSERT_EQ(shown(first), expected[size_t(i)]);
    ASSERT_TRUE(select(mDrawable));
  }
  drawFrame(1);
  swap();
  EXPECT_TRUE(unselect());
  EXPECT_EQ(shown(first), expected[1]);
}

TEST_F(Pipeline, AForkWaitsForThePictureOrTakesItAlong) {
  const std::vector<Picture> expected = truth();
  for (int i = 0; i < kPictures; ++i) {
    drawFrame(i);
    swap();
    const pid_t child = fork();
    if (child == 0) {
      alarm(60);
      _exit(shown() == expected[size_t(i)] ? 0 : 1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_EQ(status, 0) << i;
    EXPECT_EQ(shown(), expected[size_t(i)]) << "and so does the parent";
  }
}

}  // namespace
}  // namespace rc::test
