// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// The process is the program's: drawing leaves signal handlers and masks, the processor's mode for floats, locale,
// environment, working directory and file descriptors as they were; and whatever they are, the picture is the same.
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cfenv>
#include <clocale>
#include <cstring>
#include <filesystem>

#include "egl/small_program.h"

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace rc::test {
namespace {

std::vector<std::string> signalActions() {
  std::vector<std::string> actions;
  for (int number = 1; number < NSIG; ++number) {
    struct sigaction action = {};
    sigaction(number, nullptr, &action);
    std::string text(sizeof action.sa_handler, 0);
    std::memcpy(text.data(), &action.sa_handler, text.size());
    actions.push_back(text + std::to_string(action.sa_flags));
  }
  return actions;
}

std::vector<int> blockedSignals() {
  sigset_t set;
  pthread_sigmask(SIG_SETMASK, nullptr, &set);
  std::vector<int> blocked;
  for (int number = 1; number < NSIG; ++number) blocked.push_back(sigismember(&set, number));
  return blocked;
}

std::vector<std::string> environment() {
  std::vector<std::string> all;
  for (char **variable = environ; *variable; ++variable) all.emplace_back(*variable);
  return all;
}

size_t openFiles() {
  size_t count = 0;
  for ([[maybe_unused]] const auto &entry : std::filesystem::directory_iterator("/proc/self/fd")) ++count;
  return count;
}

mode_t fileMask() {
  const mode_t mask = umask(0);
  umask(mask);
  return mask;
}

class HostState : public SmallProgram {
 protected:
  void SetUp() override {
    SmallProgram::SetUp();
    std::fegetenv(&mFloats);
  }
  void TearDown() override {
    std::fesetenv(&mFloats);
    SmallProgram::TearDown();
  }

  Picture drawOnce() {
    const Drawable own = drawable();
    EXPECT_TRUE(select(own));
    const Picture picture = draw();
    EXPECT_TRUE(eglSwapBuffers(mDisplay, own.surface));
    EXPECT_TRUE(unselect());
    EXPECT_TRUE(eglDestroyContext(mDisplay, own.context));
    EXPECT_TRUE(eglDestroySurface(mDisplay, own.surface));
    return picture;
  }

  std::fenv_t mFloats;
};

TEST_F(HostState, IsAsItWas) {
  const auto actions = signalActions();
  const auto blocked = blockedSignals();
  const auto variables = environment();
  const std::string locale = std::setlocale(LC_ALL, nullptr);
  const auto folder = std::filesystem::current_path();
  const mode_t mask = fileMask();
  drawOnce();  // threads that stay may keep files
  const size_t files = openFiles();
  drawOnce();
  EXPECT_EQ(signalActions(), actions);
  EXPECT_EQ(blockedSignals(), blocked);
  EXPECT_EQ(environment(), variables);
  EXPECT_EQ(std::setlocale(LC_ALL, nullptr), locale);
  EXPECT_EQ(std::filesystem::current_path(), folder);
  EXPECT_EQ(fileMask(), mask);
  EXPECT_EQ(openFiles(), files);
}

TEST_F(HostState, RoundingOfTheProgramChangesNoPicture) {
  const Picture usual = drawOnce();
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    ASSERT_EQ(std::fesetround(mode), 0);
    EXPECT_EQ(drawOnce(), usual) << mode;
    EXPECT_EQ(std::fegetround(), mode);
  }
}

#if defined(__SSE__)
TEST_F(HostState, FlushedDenormalsAndTrapsChangeNoPicture) {
  const Picture usual = drawOnce();
  const uint32_t before = _mm_getcsr() & ~0x3fu;
  for (const uint32_t mode : {before | 0x8040, before & ~0xf80u}) {  // FTZ and DAZ; all traps but that of inexactness
    _mm_setcsr(mode);
    const Picture picture = drawOnce();
    EXPECT_EQ(_mm_getcsr() & ~0x3fu, mode);
    _mm_setcsr(before);
    EXPECT_EQ(picture, usual);
  }
}
#endif

}  // namespace
}  // namespace rc::test
