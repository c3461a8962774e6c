// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "output/png.h"

#include <png.h>

#include <cstring>

#include "load/error.h"

namespace rc::tool {
namespace {

png_image newImage() {
  png_image image;
  std::memset(&image, 0, sizeof image);
  image.version = PNG_IMAGE_VERSION;
  return image;
}

}  // namespace

void writePng(const Image &image, const std::string &file, const std::string &name) {
  std::vector<uint8_t> rgb;
  rgb.reserve(image.rgba.size() / 4 * 3);
  for (size_t i = 0; i < image.rgba.size(); i += 4) rgb.insert(rgb.end(), &image.rgba[i], &image.rgba[i] + 3);
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
