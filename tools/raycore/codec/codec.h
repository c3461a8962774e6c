// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// codec.h: the picture formats that png.h and jpeg.h leave to OpenImageIO, behind a door that opens when somebody
// knocks. That library brings some 250 others, which take longer to start than most models take to be rendered; so it
// is in a module of its own, raycore/pictures.so beside libRayCoreAPI.so.
#pragma once

#include <string>

#include "scene/scene.h"

namespace rc::tool {

class Codec {
 public:
  virtual ~Codec() = default;

  // format: OpenImageIO's name of it; name: for messages. Throws InputError.
  virtual Image decode(const std::string &bytes, const std::string &format, const std::string &name) const = 0;

  // Into the file, in the format of the name's extension; not JPEG, whose library would end the process. Throws
  // InputError.
  virtual void encode(const Image &image, const std::string &file, const std::string &name) const = 0;

  // Whether the file is a picture of this size that can be read to its end.
  virtual bool isWhole(const std::string &name, int width, int height) const = 0;
};

// Loads the module on first use. Throws InputError: it is not there or belongs to another version of the command.
const Codec &codec();

// What the module exports: kCodecEntry, of this type.
using CodecEntry = const Codec *(const char *version);
constexpr const char *kCodecEntry = "raycorePictureCodec";

}  // namespace rc::tool
