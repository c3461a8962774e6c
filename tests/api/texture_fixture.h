// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// texture_fixture.h: a context with textures to load and a quad that shows them.
#pragma once

#include "api/context_fixture.h"

namespace rc::test {

class TextureTest : public ContextTest {
 protected:
  // The bound material shows its texture unlit: exactly the texels.
  void textureOnly() {
    pixelCamera();
    rcBindTexture(RC_TEXTURE_2D, 9);
    rcEnable(RC_TEXTURE_2D);
    rcEnable(RC_USE_TEXTURE_ONLY);
  }

  void load(RCsizei width, RCsizei height, RCenum format = RC_RGB, RCenum type = RC_UNSIGNED_BYTE) {
    const std::vector<RCubyte> texels(size_t(width) * size_t(height) * 4, 100);
    rcTexImage2D(RC_TEXTURE_2D, 0, RCint(format), width, height, 0, format, type, texels.data());
  }

  // All texels the same, as they lie in memory.
  template <class Texel>
  void loadTexels(RCenum format, RCenum type, const Texel &texel) {
    const std::vector<Texel> texels(16 * 16, texel);
    rcTexImage2D(RC_TEXTURE_2D, 0, RCint(format), 16, 16, 0, format, type, texels.data());
  }

  Colour shown() {
    drawTexturedQuad({8, 8, 40, 40});
    rcFinish();
    return pixel(26, 20);  // not on the diagonal
  }
};

}  // namespace rc::test
