// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// PNG and JPEG are read as OpenImageIO reads them, and what is damaged is said.
#include "codec/codec.h"

#include <gtest/gtest.h>
#include <png.h>
#include <zlib.h>
// clang-format off
#include <cstdio>  // jpeglib.h does without
#include <jpeglib.h>
// clang-format on

#include <algorithm>
#include <cstdlib>
#include <functional>

#include "codec/jpeg.h"
#include "codec/limits.h"
#include "codec/picture.h"
#include "codec/png.h"
#include "input/error.h"

namespace rc::tool {
namespace {

constexpr int kWidth = 9, kHeight = 5;

struct Kind {
  const char *name;
  int colours, bits;
  bool interlaced = false, transparency = false;
};
constexpr Kind kKinds[] = {
    {"grey of 1 bit", PNG_COLOR_TYPE_GRAY, 1},
    {"grey of 2 bits, one of them clear", PNG_COLOR_TYPE_GRAY, 2, false, true},
    {"grey of 16 bits", PNG_COLOR_TYPE_GRAY, 16},
    {"grey and opacity, interlaced", PNG_COLOR_TYPE_GRAY_ALPHA, 8, true},
    {"a palette of 4 bits, some of it clear", PNG_COLOR_TYPE_PALETTE, 4, false, true},
    {"a palette of 8 bits, interlaced", PNG_COLOR_TYPE_PALETTE, 8, true},
    {"colours", PNG_COLOR_TYPE_RGB, 8},
    {"colours, one of them clear", PNG_COLOR_TYPE_RGB, 8, false, true},
    {"colours of 16 bits, interlaced", PNG_COLOR_TYPE_RGB, 16, true},
    {"colours and opacity", PNG_COLOR_TYPE_RGB_ALPHA, 8},
    {"colours and opacity of 16 bits", PNG_COLOR_TYPE_RGB_ALPHA, 16},
};

void append(png_structp png, png_bytep data, size_t count) {
  static_cast<std::string *>(png_get_io_ptr(png))->append(reinterpret_cast<const char *>(data), count);
}

std::string pngOf(const Kind &kind) {
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(png, &bytes, append, nullptr);
  png_set_IHDR(png, info, kWidth, kHeight, kind.bits, kind.colours,
               kind.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_BASE,
               PNG_FILTER_TYPE_BASE);
  std::vector<png_color> palette;
  for (int i = 0; i < 1 << std::min(kind.bits, 8); ++i) {
    palette.push_back({png_byte(i * 37), png_byte(255 - i), png_byte(i * 11)});
  }
  if (kind.colours == PNG_COLOR_TYPE_PALETTE) png_set_PLTE(png, info, palette.data(), int(palette.size()));
  png_byte alphas[] = {0, 100, 200};
  png_color_16 clear{0, 37, 37, 37, 1};
  if (kind.transparency) png_set_tRNS(png, info, alphas, std::size(alphas), &clear);
  png_write_info(png, info);
  std::vector<std::vector<png_byte>> rows;
  std::vector<png_bytep> pointers;
  for (size_t y = 0; y < kHeight; ++y) {
    rows.emplace_back(png_get_rowbytes(png, info));
    for (size_t x = 0; x < rows[y].size(); ++x) rows[y][x] = png_byte(37 * x + 91 * y);
    pointers.push_back(rows[y].data());
  }
  png_write_image(png, pointers.data());
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

Image gradient() {
  Image image{"gradient", 40, 24, {}};
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      image.rgba.insert(image.rgba.end(), {uint8_t(x * 6), uint8_t(y * 10), uint8_t(255 - x), 255});
    }
  }
  return image;
}

// Smooth, of so many components.
std::string jpegOf(int components, bool progressive) {
  jpeg_error_mgr errors;
  jpeg_compress_struct jpeg;
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char *bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &bytes, &size);
  jpeg.image_width = 40;
  jpeg.image_height = 24;
  jpeg.input_components = components;
  constexpr J_COLOR_SPACE kSpaces[] = {JCS_UNKNOWN, JCS_GRAYSCALE, JCS_UNKNOWN, JCS_RGB, JCS_CMYK};
  jpeg.in_color_space = kSpaces[components];
  jpeg_set_defaults(&jpeg);
  if (progressive) jpeg_simple_progression(&jpeg);
  jpeg_start_compress(&jpeg, TRUE);
  std::vector<uint8_t> row(40 * size_t(components));
  for (size_t y = 0; y < 24; ++y) {
    for (size_t i = 0; i < row.size(); ++i) row[i] = uint8_t(i * 6 / size_t(components) + y * (1 + i % 3) * 3);
    uint8_t *start = row.data();
    jpeg_write_scanlines(&jpeg, &start, 1);
  }
  jpeg_finish_compress(&jpeg);
  jpeg_destroy_compress(&jpeg);
  std::string out(reinterpret_cast<const char *>(bytes), size);
  std::free(bytes);
  return out;
}

std::string complaint(const std::function<void()> &act) {
  try {
    act();
  } catch (const InputError &error) {
    return error.what();
  }
  return {};
}

TEST(Png, EveryKindIsWhatOpenImageIoMakesOfIt) {
  for (const Kind &kind : kKinds) {
    SCOPED_TRACE(kind.name);
    const std::string bytes = pngOf(kind);
    const Image ours = decodePng(bytes, "ours"), theirs = codec().decode(bytes, "png", "theirs");
    EXPECT_EQ(ours.width, kWidth);
    EXPECT_EQ(ours.height, kHeight);
    EXPECT_EQ(ours.rgba, theirs.rgba);
  }
}

TEST(Png, ColoursAndOpacityComeAsTheyAre) {
  const Image image = decodePng(pngOf({"", PNG_COLOR_TYPE_RGB_ALPHA, 8}), "");
  for (size_t y = 0; y < kHeight; ++y) {
    for (size_t x = 0; x < 4 * kWidth; ++x) EXPECT_EQ(image.rgba[y * 4 * kWidth + x], uint8_t(37 * x + 91 * y));
  }
}

TEST(Png, DamageIsSaid) {
  const std::string bytes = pngOf({"", PNG_COLOR_TYPE_RGB, 8});
  for (size_t size = 8; size + 16 < bytes.size(); ++size) {  // but for the end's own mark
    const std::string said = complaint([&] { decodePng(bytes.substr(0, size), ""); });
    EXPECT_TRUE(said.starts_with("the picture cannot be read: ")) << size << ": " << said;
  }
}

TEST(Png, SizesHaveALimit) {
  std::string bytes = pngOf({"", PNG_COLOR_TYPE_RGB, 8});
  bytes.replace(16, 4, std::string("\0\0\x40\1", 4));  // 16385 pixels wide
  const uint32_t check = uint32_t(crc32(0, reinterpret_cast<const Bytef *>(&bytes[12]), 17));
  for (size_t i = 0; i < 4; ++i) bytes[29 + i] = char(check >> (24 - 8 * i));
  EXPECT_EQ(complaint([&] { decodePng(bytes, ""); }), "the picture is 16385 x 5, the largest side is 16384");
}

TEST(Jpeg, EveryKindIsWhatOpenImageIoMakesOfIt) {
  for (const int components : {1, 2, 3, 4}) {
    for (const bool progressive : {false, true}) {
      SCOPED_TRACE(components);
      const std::string bytes = jpegOf(components, progressive);
      EXPECT_EQ(decodeJpeg(bytes, "").has_value(), components == 1 || components == 3);
      const Image ours = decodePicture(bytes, "ours"), theirs = codec().decode(bytes, "jpeg", "theirs");
      EXPECT_EQ(ours.width, 40);
      EXPECT_EQ(ours.height, 24);
      EXPECT_EQ(ours.rgba, theirs.rgba);
    }
  }
}

TEST(Jpeg, WhatIsWrittenIsRead) {
  const Image image = gradient(), back = decodeJpeg(encodeJpeg(image), "").value();
  ASSERT_EQ(back.rgba.size(), image.rgba.size());
  for (size_t i = 0; i < image.rgba.size(); ++i) EXPECT_NEAR(back.rgba[i], image.rgba[i], 12) << i;
}

TEST(Jpeg, DamageIsSaidOrGrey) {
  const std::string bytes = jpegOf(3, false);
  for (const size_t size : {4, 20, 100, 300}) {
    const std::string said = complaint([&] { decodeJpeg(bytes.substr(0, size), ""); });
    EXPECT_TRUE(said.starts_with("the picture cannot be read: ")) << size << ": " << said;
  }
  const Image whole = decodePicture(bytes, ""), cut = decodePicture(bytes.substr(0, bytes.size() - 30), "");
  ASSERT_EQ(cut.rgba.size(), whole.rgba.size());
  EXPECT_TRUE(std::equal(cut.rgba.begin(), cut.rgba.begin() + 8 * 40 * 4, whole.rgba.begin())) << "what is there shows";
}

TEST(PictureSize, HasALimit) {
  EXPECT_EQ(complaint([] { checkPictureSize(16384, 1); }), "");
  EXPECT_EQ(complaint([] { checkPictureSize(16385, 1); }), "the picture is 16385 x 1, the largest side is 16384");
  EXPECT_EQ(complaint([] { checkPictureSize(0, 1); }), "the picture has no pixels");
}

TEST(Picture, TheFirstBytesTellTheFormat) {
  EXPECT_EQ(decodePicture(pngOf(kKinds[6]), "picture.jpg").width, kWidth);
  EXPECT_EQ(decodePicture(jpegOf(3, false), "picture.png").width, 40);
  EXPECT_EQ(complaint([] { decodePicture("nothing", "picture.png"); }), "no picture format that is known");
}

}  // namespace
}  // namespace rc::tool
