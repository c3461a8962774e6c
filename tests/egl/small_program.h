// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// small_program.h: a context with a picture of a lit, tilted sheet with mirrors, in the fewest calls.
#pragma once

#include <array>
#include <cmath>

#include "RC/rc.h"
#include "RC/rcu.h"
#include "egl/egl_fixture.h"

namespace rc::test {

class SmallProgram : public Egl {
 protected:
  static constexpr int kSide = 48;
  using Picture = std::array<uint32_t, size_t(kSide) * kSide>;

  struct Drawable {
    EGLSurface surface;
    EGLContext context;
  };

  Drawable drawable() { return {pbuffer(kSide, kSide), context()}; }
  bool select(const Drawable &to) { return eglMakeCurrent(mDisplay, to.surface, to.surface, to.context); }
  bool unselect() { return eglMakeCurrent(mDisplay, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }

  static Picture draw() {
    rcClearColor(0.2f, 0.3f, 0.4f, 1);
    rcuPerspective(50, 1, 0.1f, 100);
    rcuLookAt(0.3f, 1.5f, 2.5f, 0, 0, 0, 0, 1, 0);
    rcEnable(RC_LIGHTING);
    rcEnable(RC_LIGHT0);
    rcMaterialf(RC_FRONT_AND_BACK, RC_REFLECTION, 0.4f);
    rcEnableClientState(RC_VERTEX_ARRAY);
    rcVertexPointer(3, RC_FLOAT, 0, sheet().data());
    rcDrawArrays(RC_QUADS, 0, RCsizei(sheet().size() / 3));
    rcFinish();
    Picture picture{};
    rcReadPixels(0, 0, kSide, kSide, RC_RGBA, RC_UNSIGNED_BYTE, picture.data());
    EXPECT_EQ(rcGetError(), RCenum(RC_NO_ERROR));
    return picture;
  }

 private:
  static const std::vector<float> &sheet() {
    static const std::vector<float> vertices = [] {
      constexpr int kCells = 24;
      std::vector<float> made;
      for (int cell = 0; cell < kCells * kCells; ++cell) {
        for (const auto &[di, dj] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
          const float x = float(cell / kCells + di) / kCells - 0.5f, z = float(cell % kCells + dj) / kCells - 0.5f;
          made.insert(made.end(), {2 * x, 0.2f * std::sin(9 * x) * std::cos(8 * z), 2 * z});
        }
      }
      return made;
    }();
    return vertices;
  }
};

}  // namespace rc::test
