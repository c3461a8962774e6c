// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// pixel_format.h: how a TrueColor visual of any depth stores colours: where its masks put the channels.
#pragma once

#include <X11/Xlib.h>

#include <array>
#include <cstdint>

#include "rchal/device.h"

namespace rc::egl {

// Bits of a pixel that hold a channel.
struct ColourMasks {
  unsigned long red, green, blue;
};
inline ColourMasks colourMasks(const ::Visual &visual) {
  return {visual.red_mask, visual.green_mask, visual.blue_mask};
}

class PixelFormat {
 public:
  PixelFormat(const ColourMasks &masks, int depth);

  // rgba: R in the low byte. Bits of a pixel that hold no colour are set: to a compositor that is opaque.
  uint32_t encode(uint32_t rgba) const {
    return mOpaque | mChannel[0][rgba & 255] | mChannel[1][rgba >> 8 & 255] | mChannel[2][rgba >> 16 & 255];
  }
  // Stores a picture of the image's size, in the image's bits per pixel and byte order.
  void store(const hal::Target &picture, XImage &image) const;

 private:
  std::array<std::array<uint32_t, 256>, 3> mChannel;  // byte of R, G, B -> bits of a pixel
  uint32_t mOpaque = 0;
};

}  // namespace rc::egl
