// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "codec/codec.h"

#include <RC/rc.h>
#include <dlfcn.h>

#include <filesystem>

#include "input/error.h"

namespace rc::tool {
namespace {

std::string modulePath() {
  Dl_info library{};
  dladdr(reinterpret_cast<void *>(&rcGetError), &library);
  const std::filesystem::path path = library.dli_fname ? library.dli_fname : "";
  return (path.parent_path() / "raycore" / "pictures.so").string();
}

const Codec &open() {
  void *module = dlopen(modulePath().c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!module) reject("this format of pictures needs a part that is missing: {}", dlerror());
  const auto entry = reinterpret_cast<CodecEntry *>(dlsym(module, kCodecEntry));
  const Codec *codec = entry ? entry(RAYCORE_VERSION) : nullptr;
  if (!codec) reject("{} is of another version than this command, {}", modulePath(), RAYCORE_VERSION);
  return *codec;
}

}  // namespace

const Codec &codec() {
  static const Codec &opened = open();
  return opened;
}

}  // namespace rc::tool
