// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// The library: which file it is, what it says of its environment, whether it traces.
#include <RC/rc.h>
#include <RC/rcu.h>
#include <dlfcn.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>

#include "doctor/checks.h"
#include "draw/target.h"
#include "input/error.h"

namespace rc::tool {
namespace {

constexpr int kSide = 32;

// docs/environment.md; the last one is of the test programs.
constexpr std::array kVariables{
    "RAYCORE_DEVICE",  "RAYCORE_THREADS", "RAYCORE_ACCEL",    "RAYCORE_INSTRUCTION_SET", "RAYCORE_MEMORY_LIMIT",
    "RAYCORE_PROFILE", "RAYCORE_SAMPLES", "RAYCORE_PIPELINE", "RAYCORE_FRAMES",          "RAYCORE_CAPTURE",
    "RAYCORE_LOG",     "RAYCORE_TRACE",   "RAYCORE_TEST",     "RAYCORE_TEST_RAYS"};

// What is written to stderr while it lives.
class CaughtErrors {
 public:
  CaughtErrors() : mFile(memfd_create("raycore", MFD_CLOEXEC)), mBefore(dup(STDERR_FILENO)) {
    std::fflush(stderr);
    if (mFile >= 0 && mBefore >= 0) dup2(mFile, STDERR_FILENO);
  }
  ~CaughtErrors() {
    release();
    if (mFile >= 0) close(mFile);
  }
  CaughtErrors(const CaughtErrors &) = delete;
  CaughtErrors &operator=(const CaughtErrors &) = delete;

  std::string text() {
    release();
    std::string text(4096, '\0');
    const ssize_t size = mFile >= 0 ? pread(mFile, text.data(), text.size(), 0) : 0;
    text.resize(size > 0 ? size_t(size) : 0);
    return text;
  }

 private:
  void release() {
    std::fflush(stderr);
    if (mBefore < 0) return;
    dup2(mBefore, STDERR_FILENO);
    close(mBefore);
    mBefore = -1;
  }

  int mFile, mBefore;
};

std::string oneLine(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  for (size_t at; (at = text.find('\n')) != text.npos;) text.replace(at, 1, "; ");
  for (size_t at; (at = text.find("raycore: ")) != text.npos;) text.erase(at, 9);
  return text;
}

std::string joinNames(const std::vector<std::string> &names) { return fmt::format("{}", fmt::join(names, ", ")); }

}  // namespace

Check checkLibrary() {
  Check check{"library", Finding::Ok, {}, {}};
  Dl_info info{};
  std::error_code error;
  if (dladdr(reinterpret_cast<const void *>(&rcGetString), &info) && info.dli_fname) {
    check.found = std::filesystem::canonical(info.dli_fname, error).string();
    if (error) check.found = info.dli_fname;
  }
  const char *vendor = eglQueryString(eglGetDisplay(EGL_DEFAULT_DISPLAY), EGL_VENDOR);
  check.found = fmt::format("{}, {}", RAYCORE_VERSION, check.found);
  if (vendor || eglGetError() == EGL_NOT_INITIALIZED) return check;
  return {check.name, Finding::Problem, check.found, "its EGL does not answer: is it libRayCoreAPI that is loaded?"};
}

Check checkSettings() {
  std::vector<std::string> set, unknown;
  for (char **variable = environ; *variable; ++variable) {
    const std::string name(*variable, std::strcspn(*variable, "="));
    if (!name.starts_with("RAYCORE_")) continue;
    const bool known = std::find(kVariables.begin(), kVariables.end(), name) != kVariables.end();
    set.emplace_back(*variable);
    if (!known) unknown.push_back(name);
  }
  std::sort(set.begin(), set.end());
  Check check{"settings", Finding::Ok, set.empty() ? "no variable RAYCORE_* is set" : joinNames(set), {}};
  CaughtErrors errors;
  try {
    const Target target(kSide, kSide);
  } catch (const InputError &) {  // a check of its own
  }
  const std::string said = oneLine(errors.text());
  if (!said.empty()) {
    check.finding = Finding::Problem;
    check.advice = said;
  } else if (!unknown.empty()) {
    check.finding = Finding::Problem;
    check.advice = fmt::format("nobody reads {}: the names are in docs/environment.md", joinNames(unknown));
  }
  return check;
}

// A triangle in front of a dark ground, read back.
Check checkPicture() {
  constexpr float kCorners[] = {-1, -1, 0, 1, -1, 0, 0, 1, 0};
  const char *device = std::getenv("RAYCORE_DEVICE");
  if (device && !std::strcmp(device, "null")) {
    return {"picture", Finding::Note, "not tried", "the device null traces nothing: unset RAYCORE_DEVICE"};
  }
  try {
    const Target target(kSide, kSide);
    rcClearColor(0, 0, 0, 1);
    rcuPerspective(60, 1, 1, 100);
    rcuLookAt(0, 0, 3, 0, 0, 0, 0, 1, 0);
    rcColor4f(1, 1, 1, 1);
    rcEnableClientState(RC_VERTEX_ARRAY);
    rcVertexPointer(3, RC_FLOAT, 0, kCorners);
    rcDrawArrays(RC_TRIANGLES, 0, 3);
    checkErrors("drawing a triangle");
    const Image image = target.picture(kSide, kSide);
    const size_t middle = (size_t(kSide) * kSide / 2 + kSide / 2) * 4;
    if (image.rgba[middle] > image.rgba[0]) return {"picture", Finding::Ok, "a triangle was traced", {}};
    return {"picture", Finding::Problem, "a triangle was traced, and is not there", "please report this"};
  } catch (const InputError &error) {
    return {"picture", Finding::Problem, "none", error.what()};
  }
}

}  // namespace rc::tool
