// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "window/egl_x11_fixture.h"

#include <algorithm>
#include <cstdlib>

#include "RC/rcu.h"

namespace rc::test {
namespace {

int gErrors = 0;

}  // namespace

int countErrors(Display *, XErrorEvent *) { return ++gErrors; }

void draw() {
  RCint viewport[4];
  rcGetIntegerv(RC_VIEWPORT, viewport);
  static const float vertices[] = {-2, -1, -1.5f, 2, -1, -3, 0, 2, -2}, light[] = {0.5f, 0.5f, 0, 1};
  rcClearColor(0.3f, 0.6f, 0.9f, 1);
  rcMatrixMode(RC_PROJECTION);
  rcLoadIdentity();
  rcFrustumf(-1, 1, -1, 1, 1, 10);
  rcMatrixMode(RC_MODELVIEW);
  rcEnable(RC_LIGHTING);
  rcEnable(RC_LIGHT0);
  rcLightfv(RC_LIGHT0, RC_POSITION, light);
  rcEnableClientState(RC_VERTEX_ARRAY);
  rcVertexPointer(3, RC_FLOAT, 0, vertices);
  rcDrawArrays(RC_TRIANGLES, 0, 3);
}

Picture traced() {
  const hal::Target target = egl::threadState().current.draw->picture();
  Picture picture{target.width, target.height, {}};
  for (int i = 0; i < target.width * target.height; ++i) {
    for (int shift = 0; shift < 24; shift += 8) picture.rgb.push_back(uint8_t(target.pixels[i] >> shift));
  }
  return picture;
}

int difference(const Picture &a, const Picture &b) {
  if (a.rgb.empty() || a.width != b.width || a.height != b.height) return 256;
  int largest = 0;
  for (size_t i = 0; i < a.rgb.size(); ++i) largest = std::max(largest, std::abs(a.rgb[i] - b.rgb[i]));
  return largest;
}

void PrintTo(const Screen &screen, std::ostream *out) { *out << screen.name; }

void EglX11::SetUp() {
  if (!XServer::available()) GTEST_SKIP() << "Xvfb is not installed; scripts/setup.sh does it";
  mServer.emplace(GetParam().options);
  ASSERT_TRUE(mServer->connection());
  XSetErrorHandler(countErrors);
  gErrors = 0;
}

void EglX11::TearDown() { EXPECT_EQ(gErrors, 0) << "an error of X reached the program"; }

}  // namespace rc::test
