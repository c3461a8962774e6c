// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "codec/picture.h"

#include <array>
#include <string_view>

#include "codec/codec.h"
#include "codec/jpeg.h"
#include "codec/png.h"
#include "input/error.h"
#include "input/file.h"

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

}  // namespace

Image decodePicture(const std::string &bytes, const std::string &name) {
  const std::string format = formatOf(bytes, name);
  if (format == "png") return decodePng(bytes, name);
  if (format == "jpeg") {
    if (auto image = decodeJpeg(bytes, name)) return *std::move(image);
  }
  return codec().decode(bytes, format, name);
}

}  // namespace rc::tool
