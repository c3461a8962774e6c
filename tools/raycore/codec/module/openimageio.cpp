// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cmath>
#include <string_view>

#include "codec/codec.h"
#include "codec/limits.h"
#include "input/file.h"

namespace rc::tool {
namespace {

// The library's messages may have several lines, or none; ours have one.
std::string oneLine(std::string text, const char *otherwise = "damaged") {
  for (char &c : text) {
    if (c == '\n') c = ' ';
  }
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text.empty() ? otherwise : text;
}

// One to four channels become RGBA.
void spread(const std::vector<uint8_t> &pixels, int channels, Image &image) {
  const size_t count = size_t(image.width) * size_t(image.height);
  const bool grey = channels < 3;
  image.rgba.resize(4 * count);
  for (size_t i = 0; i < count; ++i) {
    const uint8_t *from = &pixels[i * size_t(channels)];
    uint8_t *to = &image.rgba[4 * i];
    for (int c = 0; c < 3; ++c) to[c] = from[grey ? 0 : c];
    to[3] = channels == 4 ? from[3] : channels == 2 ? from[1] : 255;
  }
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

class OpenImageIo final : public Codec {
 public:
  OpenImageIo() { OIIO::attribute("threads", 1); }  // each thread would want its share of the sandbox's memory

  Image decode(const std::string &bytes, const std::string &format, const std::string &name) const override {
    OIIO::ImageSpec wishes;
    wishes["oiio:UnassociatedAlpha"] = 1;
    OIIO::Filesystem::IOMemReader memory(bytes.data(), bytes.size());
    OIIO::Filesystem::IOProxy *proxy = &memory;
    wishes.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
    auto input = OIIO::ImageInput::create(format);
    if (!input) reject("the picture cannot be read: {}", oneLine(OIIO::geterror()));
    OIIO::ImageSpec spec;
    if (!input->open(name.empty() ? "memory" : name, spec, wishes)) {
      reject("the picture cannot be read: {}", oneLine(input->geterror()));
    }
    checkPictureSize(spec.width, spec.height);
    const int channels = std::min(spec.nchannels, 4);
    Image image{name, spec.width, spec.height, {}};
    std::vector<uint8_t> pixels(size_t(spec.width) * size_t(spec.height) * size_t(channels));
    if (!input->read_image(0, 0, 0, channels, OIIO::TypeDesc::UINT8, pixels.data())) {
      reject("the picture cannot be read: {}", oneLine(input->geterror()));
    }
    spread(pixels, channels, image);
    return image;
  }

  void encode(const Image &image, const std::string &file, const std::string &name) const override {
    auto output = OIIO::ImageOutput::create(name);
    if (!output) reject("{}: {}", name, oneLine(OIIO::geterror()));
    const bool linear = extensionOf(name) == ".exr";
    OIIO::ImageSpec spec(image.width, image.height, 3, linear ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::UINT8);
    spec["oiio:ColorSpace"] = linear ? "Linear" : "sRGB";
    if (linear) spec["Compression"] = "zip";
    const std::vector<float> values = linear ? linearPixels(image) : std::vector<float>{};
    const void *pixels = linear ? static_cast<const void *>(values.data()) : image.rgba.data();
    const OIIO::TypeDesc type = linear ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8;
    const OIIO::stride_t step = 4 * OIIO::stride_t(type.size());
    const bool done = output->open(file, spec) && output->write_image(type, pixels, step) && output->close();
    if (!done) reject("{}: cannot be written: {}", name, oneLine(output->geterror(), "the file is not whole"));
    output.reset();
    // Some formats do not look whether their bytes have been written.
    if (!isWhole(file, image.width, image.height)) reject("{}: cannot be written: the file is not whole", name);
  }

  bool isWhole(const std::string &name, int width, int height) const override {
    auto input = OIIO::ImageInput::open(name);
    if (!input) {
      OIIO::geterror();
      return false;
    }
    const OIIO::ImageSpec spec = input->spec();
    if (spec.width != width || spec.height != height) return false;
    std::vector<uint8_t> pixels(size_t(spec.width) * size_t(spec.height) * size_t(spec.nchannels));
    return input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, pixels.data());
  }
};

}  // namespace
}  // namespace rc::tool

extern "C" __attribute__((visibility("default"))) const rc::tool::Codec *raycorePictureCodec(const char *version) {
  static const rc::tool::OpenImageIo codec;
  return std::string_view(version) == RAYCORE_VERSION ? &codec : nullptr;
}
