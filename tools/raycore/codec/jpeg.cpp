// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "codec/jpeg.h"

// clang-format off
#include <cstdio>  // jpeglib.h does without
#include <jpeglib.h>
// clang-format on

#include <csetjmp>
#include <cstdlib>
#include <string_view>

#include "codec/limits.h"
#include "codec/rgb.h"

namespace rc::tool {
namespace {

// libjpeg leaves by longjmp: nothing with a destructor lives in the steps below.
struct JpegErrors {
  jpeg_error_mgr base;
  std::jmp_buf out;
  char text[JMSG_LENGTH_MAX];
};

[[noreturn]] void leaveJpeg(j_common_ptr jpeg) {
  auto *errors = reinterpret_cast<JpegErrors *>(jpeg->err);
  jpeg->err->format_message(jpeg, errors->text);
  std::longjmp(errors->out, 1);
}
void ignoreWarning(j_common_ptr, int) {}

class JpegDecoder {
 public:
  JpegDecoder() {
    mJpeg.err = jpeg_std_error(&mErrors.base);
    mErrors.base.error_exit = leaveJpeg;
    mErrors.base.emit_message = ignoreWarning;  // a picture that ends too early is grey from there on
  }
  ~JpegDecoder() { jpeg_destroy_decompress(&mJpeg); }
  JpegDecoder(const JpegDecoder &) = delete;
  JpegDecoder &operator=(const JpegDecoder &) = delete;

  bool readHeader(const std::string &bytes) {
    if (setjmp(mErrors.out)) return false;
    jpeg_create_decompress(&mJpeg);
    jpeg_mem_src(&mJpeg, reinterpret_cast<const unsigned char *>(bytes.data()), bytes.size());
    jpeg_read_header(&mJpeg, TRUE);
    return true;
  }
  // rgb: three bytes a pixel.
  bool readRows(uint8_t *rgb) {
    if (setjmp(mErrors.out)) return false;
    mJpeg.out_color_space = JCS_RGB;
    jpeg_start_decompress(&mJpeg);
    while (mJpeg.output_scanline < mJpeg.output_height) {
      JSAMPROW row = rgb + size_t(mJpeg.output_scanline) * mJpeg.output_width * 3;
      jpeg_read_scanlines(&mJpeg, &row, 1);
    }
    return true;
  }

  int64_t width() const { return mJpeg.image_width; }
  int64_t height() const { return mJpeg.image_height; }
  int colours() const { return mJpeg.num_components; }
  const char *error() const { return mErrors.text; }

 private:
  JpegErrors mErrors{};
  jpeg_decompress_struct mJpeg{};
};

class JpegEncoder {
 public:
  JpegEncoder() {
    mJpeg.err = jpeg_std_error(&mErrors.base);
    mErrors.base.error_exit = leaveJpeg;
  }
  ~JpegEncoder() {
    jpeg_destroy_compress(&mJpeg);
    std::free(mBytes);
  }
  JpegEncoder(const JpegEncoder &) = delete;
  JpegEncoder &operator=(const JpegEncoder &) = delete;

  bool write(uint8_t *rgb, int width, int height) {
    if (setjmp(mErrors.out)) return false;
    jpeg_create_compress(&mJpeg);
    jpeg_mem_dest(&mJpeg, &mBytes, &mSize);
    mJpeg.image_width = JDIMENSION(width);
    mJpeg.image_height = JDIMENSION(height);
    mJpeg.input_components = 3;
    mJpeg.in_color_space = JCS_RGB;
    jpeg_set_defaults(&mJpeg);
    jpeg_set_quality(&mJpeg, kQuality, TRUE);
    jpeg_start_compress(&mJpeg, TRUE);
    while (mJpeg.next_scanline < mJpeg.image_height) {
      JSAMPROW row = rgb + size_t(mJpeg.next_scanline) * mJpeg.image_width * 3;
      jpeg_write_scanlines(&mJpeg, &row, 1);
    }
    jpeg_finish_compress(&mJpeg);
    return true;
  }
  std::string bytes() const { return {reinterpret_cast<const char *>(mBytes), mSize}; }
  const char *error() const { return mErrors.text; }

 private:
  static constexpr int kQuality = 92;  // of 100

  JpegErrors mErrors{};
  jpeg_compress_struct mJpeg{};
  unsigned char *mBytes = nullptr;
  unsigned long mSize = 0;
};

// libjpeg reads pictures without Huffman tables as if they were frames of a film: with tables of its own.
void checkTables(std::string_view bytes) {
  constexpr uint8_t kHuffman = 0xC4, kArithmetic = 0xCC, kScan = 0xDA;
  for (size_t at = 2; at + 4 <= bytes.size() && bytes[at] == '\xff';) {
    const auto marker = static_cast<uint8_t>(bytes[at + 1]);
    if (marker == kHuffman || marker == kArithmetic) return;
    if (marker == kScan) reject("the picture cannot be read: it has no Huffman table");
    at += 2 + size_t(uint8_t(bytes[at + 2])) * 256 + uint8_t(bytes[at + 3]);
  }
}

}  // namespace

std::optional<Image> decodeJpeg(const std::string &bytes, const std::string &name) {
  checkTables(bytes);
  JpegDecoder decoder;
  if (!decoder.readHeader(bytes)) reject("the picture cannot be read: {}", decoder.error());
  checkPictureSize(decoder.width(), decoder.height());
  if (decoder.colours() != 1 && decoder.colours() != 3) return std::nullopt;
  Image image{name, int(decoder.width()), int(decoder.height()), {}};
  std::vector<uint8_t> rgb(size_t(image.width) * size_t(image.height) * 3);
  if (!decoder.readRows(rgb.data())) reject("the picture cannot be read: {}", decoder.error());
  image.rgba.reserve(rgb.size() / 3 * 4);
  for (size_t i = 0; i < rgb.size(); i += 3) {
    image.rgba.insert(image.rgba.end(), {rgb[i], rgb[i + 1], rgb[i + 2], 255});
  }
  return image;
}

std::string encodeJpeg(const Image &image) {
  std::vector<uint8_t> rgb = rgbOf(image);
  JpegEncoder encoder;
  if (!encoder.write(rgb.data(), image.width, image.height)) reject("JPEG: {}", encoder.error());
  return encoder.bytes();
}

}  // namespace rc::tool
