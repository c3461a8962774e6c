// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "load/picture.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <array>
#include <string_view>

#include "load/error.h"
#include "load/file.h"

namespace rc::tool {
namespace {

using namespace std::string_view_literals;

struct Signature {
  std::string_view start;
  const char *format;  // OpenImageIO's name
};

// Files are often named wrongly, and pictures inside models have no name.
constexpr std::array kSignatures{
    Signature{"\x89PNG"sv, "png"}, Signature{"\xff\xd8\xff"sv, "jpeg"},
    Signature{"BM"sv, "bmp"},      Signature{"GIF8"sv, "gif"},
    Signature{"#?R"sv, "hdr"},     Signature{"\x76\x2f\x31\x01"sv, "openexr"},
    Signature{"II*\0"sv, "tiff"},  Signature{"MM\0*"sv, "tiff"},
    Signature{"DDS "sv, "dds"},    Signature{"RIFF"sv, "webp"},
    Signature{"P6"sv, "pnm"},      Signature{"P5"sv, "pnm"},
};

constexpr int kLargestSide = 16384;

std::string formatOf(const std::string &bytes, const std::string &name) {
  for (const Signature &signature : kSignatures) {
    if (std::string_view(bytes).starts_with(signature.start)) return signature.format;
  }
  if (extensionOf(name) == ".tga") return "targa";
  reject("no picture format that is known");
}

// The library's messages may have several lines; ours have one.
std::string oneLine(std::string text) {
  for (char &c : text) {
    if (c == '\n') c = ' ';
  }
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text.empty() ? "damaged" : text;
}

void checkSize(const OIIO::ImageSpec &spec) {
  if (spec.width < 1 || spec.height < 1) reject("the picture has no pixels");
  if (spec.width > kLargestSide || spec.height > kLargestSide) {
    reject("the picture is {} x {}, the largest side is {}", spec.width, spec.height, kLargestSide);
  }
}

// The library reads pictures without Huffman tables as if they were frames of a film: with tables of its own.
void checkJpegTables(std::string_view bytes) {
  constexpr uint8_t kHuffman = 0xC4, kArithmetic = 0xCC, kScan = 0xDA;
  for (size_t at = 2; at + 4 <= bytes.size() && bytes[at] == '\xff';) {
    const auto marker = static_cast<uint8_t>(bytes[at + 1]);
    if (marker == kHuffman || marker == kArithmetic) return;
    if (marker == kScan) reject("the picture cannot be read: it has no Huffman table");
    at += 2 + size_t(uint8_t(bytes[at + 2])) * 256 + uint8_t(bytes[at + 3]);
  }
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

}  // namespace

Image decodePicture(const std::string &bytes, const std::string &name) {
  const std::string format = formatOf(bytes, name);
  if (format == "jpeg") checkJpegTables(bytes);
  OIIO::ImageSpec wishes;
  wishes["oiio:UnassociatedAlpha"] = 1;
  OIIO::Filesystem::IOMemReader memory(bytes.data(), bytes.size());
  OIIO::Filesystem::IOProxy *proxy = &memory;
  wishes.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
  OIIO::attribute("threads", 1);  // each thread would want its share of the sandbox's memory
  auto input = OIIO::ImageInput::create(format);
  if (!input) reject("the picture cannot be read: {}", oneLine(OIIO::geterror()));
  OIIO::ImageSpec spec;
  if (!input->open(name.empty() ? "memory" : name, spec, wishes)) {
    reject("the picture cannot be read: {}", oneLine(input->geterror()));
  }
  checkSize(spec);
  const int channels = std::min(spec.nchannels, 4);
  Image image{name, spec.width, spec.height, {}};
  std::vector<uint8_t> pixels(size_t(spec.width) * size_t(spec.height) * size_t(channels));
  if (!input->read_image(0, 0, 0, channels, OIIO::TypeDesc::UINT8, pixels.data())) {
    reject("the picture cannot be read: {}", oneLine(input->geterror()));
  }
  spread(pixels, channels, image);
  return image;
}

}  // namespace rc::tool
