// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Pictures in the formats of visuals that no server of the tests has: other masks, byte orders, depths.
#include <gtest/gtest.h>

#include <vector>

// Xlib's macros would be in the way of what comes before.
#include <X11/Xutil.h>

#include "egl/pixel_format.h"

namespace rc::test {
namespace {

struct Format {
  const char *name;
  unsigned long red, green, blue;
  int depth, bitsPerPixel;
  unsigned long colour, white;  // of (255, 128, 8) and of (255, 255, 255)
};

void PrintTo(const Format &format, std::ostream *out) { *out << format.name; }

const Format kFormats[] = {
    {"RGB888", 0xff0000, 0xff00, 0xff, 24, 32, 0xff8008, 0xffffff},
    {"BGR888", 0xff, 0xff00, 0xff0000, 24, 32, 0x0880ff, 0xffffff},
    {"ARGB8888", 0xff0000, 0xff00, 0xff, 32, 32, 0xffff8008, 0xffffffff},
    {"RGB101010", 0x3ff00000, 0xffc00, 0x3ff, 30, 32, 0x3ff00000 | 514 << 10 | 32, 0x3fffffff},
    {"RGB565", 0xf800, 0x7e0, 0x1f, 16, 16, 31 << 11 | 32 << 5 | 1, 0xffff},
    {"BGR555", 0x1f, 0x3e0, 0x7c00, 15, 16, 31 | 16 << 5 | 1 << 10, 0x7fff},
    {"Packed24", 0xff0000, 0xff00, 0xff, 24, 24, 0xff8008, 0xffffff},
    {"RGB332", 0xe0, 0x1c, 0x3, 8, 8, 7 << 5 | 4 << 2 | 0, 0xff},
};

class PixelFormats : public testing::TestWithParam<Format> {};

TEST_P(PixelFormats, StoresInBothByteOrders) {
  const Format &format = GetParam();
  const uint32_t rgba[] = {0xff0880ff, 0xffffffff, 0xff000000, 0xffffffff, 0xff0880ff, 0xff0880ff};
  const unsigned long black = format.depth == 32 ? 0xff000000 : 0;
  const unsigned long expected[] = {format.colour, format.white, black, format.white, format.colour, format.colour};
  std::vector<uint32_t> pixels(std::begin(rgba), std::end(rgba));
  for (const int order : {LSBFirst, MSBFirst}) {
    std::vector<char> memory(64);
    XImage image{};
    image.width = 3;
    image.height = 2;
    image.format = ZPixmap;
    image.data = memory.data();
    image.byte_order = image.bitmap_bit_order = order;
    image.bitmap_unit = image.bitmap_pad = 32;
    image.depth = format.depth;
    image.bits_per_pixel = format.bitsPerPixel;
    image.bytes_per_line = 16;
    image.red_mask = format.red;
    image.green_mask = format.green;
    image.blue_mask = format.blue;
    ASSERT_TRUE(XInitImage(&image));
    egl::PixelFormat({format.red, format.green, format.blue}, format.depth).store({pixels.data(), 3, 2}, image);
    for (int i = 0; i < 6; ++i) EXPECT_EQ(XGetPixel(&image, i % 3, i / 3), expected[i]) << i << ", order " << order;
  }
}

std::string nameOf(const testing::TestParamInfo<Format> &info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Visuals, PixelFormats, testing::ValuesIn(kFormats), nameOf);

}  // namespace
}  // namespace rc::test
