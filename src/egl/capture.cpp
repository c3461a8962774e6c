// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "egl/capture.h"

#include <png.h>
#include <unistd.h>

#include <atomic>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "base/log.h"
#include "base/memory.h"

namespace rc::egl {
namespace {

struct CloseFile {
  void operator()(std::FILE *file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

Array<uint8_t> rgbOf(const hal::Target &picture) {
  Array<uint8_t> rgb;
  const size_t pixels = size_t(picture.width) * size_t(picture.height);
  rgb.reserve(3 * pixels);
  for (size_t i = 0; i < pixels; ++i) {
    for (int shift = 0; shift < 24; shift += 8) rgb.push_back(uint8_t(picture.pixels[i] >> shift));
  }
  return rgb;
}

bool writePpm(std::FILE *file, const hal::Target &picture) {
  const Array<uint8_t> rgb = rgbOf(picture);
  std::fprintf(file, "P6\n%d %d\n255\n", picture.width, picture.height);
  return std::fwrite(rgb.data(), 1, rgb.size(), file) == rgb.size();
}

bool writePng(std::FILE *file, const hal::Target &picture) {
  const Array<uint8_t> rgb = rgbOf(picture);
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = png_uint_32(picture.width);
  image.height = png_uint_32(picture.height);
  image.format = PNG_FORMAT_RGB;
  return png_image_write_to_stdio(&image, file, 0, rgb.data(), 0, nullptr) != 0;
}

bool endsWith(const std::string &text, const std::string &end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

}  // namespace

std::string captureName(const std::string &pattern, int frame) {
  for (size_t start = pattern.find('%'); start != std::string::npos; start = pattern.find('%', start + 1)) {
    size_t end = start + 1;
    while (end < pattern.size() && std::isdigit(static_cast<unsigned char>(pattern[end]))) ++end;
    if (end >= pattern.size() || pattern[end] != 'd' || end - start > 4) continue;
    const std::string width = pattern.substr(start + 1, end - start - 1);
    std::string number = std::to_string(frame);
    const size_t wanted = width.empty() ? 0 : size_t(std::stoi(width));
    if (number.size() < wanted) number.insert(0, wanted - number.size(), width[0] == '0' ? '0' : ' ');
    return pattern.substr(0, start) + number + pattern.substr(end + 1);
  }
  return pattern;
}

bool writePicture(const std::string &name, const hal::Target &picture) {
  // Threads and processes may write the same file: the last one stays.
  static constinit std::atomic<unsigned> count = 0;
  const std::string unfinished = name + "." + std::to_string(getpid()) + "-" + std::to_string(++count) + ".part";
  File file(std::fopen(unfinished.c_str(), "wb"));
  bool written = false;
  if (file) {
    written = endsWith(name, ".ppm") ? writePpm(file.get(), picture) : writePng(file.get(), picture);
    written = std::fclose(file.release()) == 0 && written;
  }
  if (written && std::rename(unfinished.c_str(), name.c_str()) == 0) return true;
  const int reason = errno;
  std::remove(unfinished.c_str());
  log(LogLevel::Warning, "RAYCORE_CAPTURE: cannot write \"%s\": %s; the program goes on without the picture",
      name.c_str(), std::strerror(reason));
  return false;
}

}  // namespace rc::egl
