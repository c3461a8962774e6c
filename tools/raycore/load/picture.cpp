// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "load/picture.h"

#include <array>
#include <string_view>

#include "codec/codec.h"
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

std::string formatOf(const std::string &bytes, const std::string &name) {
  for (const Signature &signature : kSignatures) {
    if (std::string_view(bytes).starts_with(signature.start)) return signature.format;
  }
  if (extensionOf(name) == ".tga") return "targa";
  reject("no picture format that is known");
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

}  // namespace

Image decodePicture(const std::string &bytes, const std::string &name) {
  const std::string format = formatOf(bytes, name);
  if (format == "jpeg") checkJpegTables(bytes);
  return codec().decode(bytes, format, name);
}

}  // namespace rc::tool
