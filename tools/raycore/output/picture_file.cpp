// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "output/picture_file.h"

#include <OpenImageIO/imageio.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string_view>

#include "load/error.h"
#include "load/file.h"

namespace rc::tool {
namespace {

namespace fs = std::filesystem;

struct Format {
  const char *extension;
  int channels;
};

constexpr std::array kFormats{Format{".png", 3}, Format{".jpg", 3}, Format{".jpeg", 3},
                              Format{".bmp", 3}, Format{".ppm", 3}, Format{".exr", 3}};

const Format &formatOf(const std::string &name) {
  const std::string extension = extensionOf(name);
  for (const Format &format : kFormats) {
    if (extension == format.extension) return format;
  }
  reject("{}: the extension is none of png, jpg, bmp, ppm, exr, mp4, webm", name);
}

// What OpenEXR keeps is linear.
std::vector<float> linearPixels(const Image &image) {
  std::vector<float> values;
  values.reserve(image.rgba.size());
  for (const uint8_t byte : image.rgba) {
    const float c = float(byte) / 255;
    values.push_back(c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f));
  }
  return values;
}

std::string oneLine(std::string text) {
  for (char &c : text) {
    if (c == '\n') c = ' ';
  }
  return text;
}

void writeTo(const Image &image, const std::string &file, const std::string &name) {
  OIIO::attribute("threads", 1);
  auto output = OIIO::ImageOutput::create(name);
  if (!output) reject("{}: {}", name, oneLine(OIIO::geterror()));
  const bool linear = extensionOf(name) == ".exr";
  const int channels = formatOf(name).channels;
  OIIO::ImageSpec spec(image.width, image.height, channels, linear ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::UINT8);
  spec["oiio:ColorSpace"] = linear ? "Linear" : "sRGB";
  spec["Compression"] = "jpeg:92";
  if (linear) spec["Compression"] = "zip";
  const std::vector<float> values = linear ? linearPixels(image) : std::vector<float>{};
  const void *pixels = linear ? static_cast<const void *>(values.data()) : image.rgba.data();
  const OIIO::TypeDesc type = linear ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8;
  const OIIO::stride_t step = 4 * OIIO::stride_t(type.size());
  const bool done = output->open(file, spec) && output->write_image(type, pixels, step) && output->close();
  if (!done) reject("{}: cannot be written: {}", name, oneLine(output->geterror()));
}

void copyToStandardOutput(const std::string &file) {
  const std::string bytes = readFile(file);
  if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size() || std::fflush(stdout) != 0) {
    reject("standard output cannot be written");
  }
}

// Removed whatever happens, unless it was renamed.
struct Temporary {
  std::string name;
  ~Temporary() {
    std::error_code ignored;
    fs::remove(name, ignored);
  }
};

}  // namespace

void checkPictureName(const std::string &name) {
  if (name != "-") formatOf(name);
}

void checkFolder(const std::string &name) {
  if (!fs::is_directory(name)) reject("{}: is no folder", name);
}

void writePicture(const Image &image, const std::string &name) {
  const bool standard = name == "-";
  const fs::path place = standard ? fs::temp_directory_path() / "picture.png" : fs::path(name);
  const std::string file = fmt::format(".raycore-{}-{}", getpid(), place.filename().string());
  const Temporary temporary{(place.parent_path() / file).string()};
  writeTo(image, temporary.name, standard ? "picture.png" : name);
  if (standard) return copyToStandardOutput(temporary.name);
  std::error_code error;
  fs::rename(temporary.name, place, error);
  if (error) reject("{}: cannot be written: {}", name, error.message());
}

bool isWholePicture(const std::string &name, int width, int height) {
  std::error_code error;
  if (!fs::is_regular_file(name, error) || fs::file_size(name, error) == 0) return false;
  auto input = OIIO::ImageInput::open(name);
  if (!input) {
    OIIO::geterror();
    return false;
  }
  const OIIO::ImageSpec spec = input->spec();
  std::vector<uint8_t> pixels(size_t(spec.width) * size_t(spec.height) * size_t(spec.nchannels));
  return spec.width == width && spec.height == height &&
         input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, pixels.data());
}

}  // namespace rc::tool
