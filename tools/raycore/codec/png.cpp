// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "codec/png.h"

#include <png.h>

#include <cstdio>
#include <cstring>

#include "codec/limits.h"
#include "codec/rgb.h"

namespace rc::tool {
namespace {

// libpng leaves by longjmp: nothing with a destructor lives in the steps of PngDecoder.
struct PngInput {
  const char *at;
  size_t left;
  char error[160];
};

[[noreturn]] void leavePng(png_structp png, png_const_charp text) {
  auto *input = static_cast<PngInput *>(png_get_error_ptr(png));
  std::snprintf(input->error, sizeof input->error, "%s", text);
  png_longjmp(png, 1);
}
void ignoreWarning(png_structp, png_const_charp) {}

void readBytes(png_structp png, png_bytep to, size_t count) {
  auto *input = static_cast<PngInput *>(png_get_io_ptr(png));
  if (count > input->left) png_error(png, "it ends too early");
  std::memcpy(to, input->at, count);
  input->at += count;
  input->left -= count;
}

class PngDecoder {
 public:
  explicit PngDecoder(const std::string &bytes) : mInput{bytes.data(), bytes.size(), {}} {
    mPng = png_create_read_struct(PNG_LIBPNG_VER_STRING, &mInput, leavePng, ignoreWarning);
    if (mPng) mInfo = png_create_info_struct(mPng);
    if (mInfo) return;
    png_destroy_read_struct(&mPng, nullptr, nullptr);
    reject("there is not enough memory");
  }
  ~PngDecoder() { png_destroy_read_struct(&mPng, &mInfo, nullptr); }
  PngDecoder(const PngDecoder &) = delete;
  PngDecoder &operator=(const PngDecoder &) = delete;

  bool readHeader() {
    if (setjmp(png_jmpbuf(mPng))) return false;
    png_set_read_fn(mPng, &mInput, readBytes);
    png_set_user_limits(mPng, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // ours are checked
    png_read_info(mPng, mInfo);
    return true;
  }
  bool readRows(png_bytepp rows) {
    if (setjmp(png_jmpbuf(mPng))) return false;
    png_set_expand(mPng);
    png_set_scale_16(mPng);
    png_set_gray_to_rgb(mPng);
    png_set_add_alpha(mPng, 255, PNG_FILLER_AFTER);
    png_set_interlace_handling(mPng);
    png_read_update_info(mPng, mInfo);
    if (png_get_rowbytes(mPng, mInfo) != size_t(width()) * 4) png_error(mPng, "its rows are not understood");
    png_read_image(mPng, rows);
    return true;
  }

  png_uint_32 width() const { return png_get_image_width(mPng, mInfo); }
  png_uint_32 height() const { return png_get_image_height(mPng, mInfo); }
  const char *error() const { return mInput.error; }

 private:
  PngInput mInput;
  png_structp mPng = nullptr;
  png_infop mInfo = nullptr;
};

// For libpng's simple way.
png_image newImage() {
  png_image image;
  std::memset(&image, 0, sizeof image);
  image.version = PNG_IMAGE_VERSION;
  return image;
}

}  // namespace

Image decodePng(const std::string &bytes, const std::string &name) {
  PngDecoder decoder(bytes);
  if (!decoder.readHeader()) reject("the picture cannot be read: {}", decoder.error());
  checkPictureSize(decoder.width(), decoder.height());
  Image image{name, int(decoder.width()), int(decoder.height()), {}};
  image.rgba.resize(size_t(image.width) * size_t(image.height) * 4);
  std::vector<png_bytep> rows;
  for (size_t y = 0; y < size_t(image.height); ++y) rows.push_back(&image.rgba[y * size_t(image.width) * 4]);
  if (!decoder.readRows(rows.data())) reject("the picture cannot be read: {}", decoder.error());
  return image;
}

void writePng(const Image &image, const std::string &file, const std::string &name) {
  const std::vector<uint8_t> rgb = rgbOf(image);
  png_image png = newImage();
  png.width = png_uint_32(image.width);
  png.height = png_uint_32(image.height);
  png.format = PNG_FORMAT_RGB;
  if (!png_image_write_to_file(&png, file.c_str(), 0, rgb.data(), 0, nullptr)) {
    reject("{}: cannot be written: {}", name, png.message);
  }
}

bool isWholePng(const std::string &file, int width, int height) {
  png_image png = newImage();
  if (!png_image_begin_read_from_file(&png, file.c_str())) return false;
  if (png.width != png_uint_32(width) || png.height != png_uint_32(height)) {
    png_image_free(&png);
    return false;
  }
  png.format = PNG_FORMAT_RGB;
  std::vector<uint8_t> rgb(PNG_IMAGE_SIZE(png));
  return png_image_finish_read(&png, nullptr, rgb.data(), 0, nullptr) != 0;
}

}  // namespace rc::tool
