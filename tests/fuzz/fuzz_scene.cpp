// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Files that the command reads, in this process: glTF by our own reader, then posed and drawn; what of other formats is
// ours (the check of OBJ, the archive that comes back from the loader's process). The first byte says which.
//
// Formats that Assimp reads run only with RAYCORE_FUZZ_FOREIGN set: a fault in that library ends the loader's process,
// as is meant to be, and would end this one. Replays of sound files do it, so that the conversion is run too.
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "draw/show.h"
#include "foreign/obj_check.h"
#include "gltf/parts.h"
#include "input.h"
#include "input/error.h"
#include "load/archive.h"
#include "load/load.h"

namespace rc::fuzz {
namespace {

using tool::Scene;

// As the command would, in a small picture.
void draw(Scene scene) {
  tool::ShowSettings settings;
  settings.width = 16;
  settings.height = 12;
  settings.samples = 1;
  settings.bounces = 2;
  if (!scene.animations.empty()) settings.animation = "0";
  tool::Show show(std::move(scene), settings);
  show.picture(0.4f);
}

void readGltf(std::string_view bytes) {
  const Scene scene = tool::gltf::readGltf(bytes, "/nowhere");
  draw(tool::unpacked(tool::packed(scene)));
}

void checkObj(std::string_view bytes) {
  Scene scene;
  tool::foreign::checkObj(
      bytes, [](const std::string &name) { return name.size() % 2 == 0; }, scene);
}

void unpack(std::string_view bytes) { tool::unpacked(bytes); }

// The loader, where it is asked for, wants a file.
template <size_t N>
void readForeign(const char (&extension)[N], std::string_view bytes) {
  if (!std::getenv("RAYCORE_FUZZ_FOREIGN")) return;
  std::string name = (std::filesystem::temp_directory_path() / "raycore-fuzz-XXXXXX").string() + extension;
  close(mkstemps(name.data(), N - 1));
  std::ofstream(name, std::ios::binary).write(bytes.data(), std::streamsize(bytes.size()));
  struct Removal {
    const std::string &file;
    ~Removal() { unlink(file.c_str()); }
  } removal{name};
  draw(tool::readModel(name));
}

constexpr std::array<void (*)(std::string_view), 9> kReaders{
    readGltf,
    checkObj,
    unpack,
    [](std::string_view bytes) { readForeign(".obj", bytes); },
    [](std::string_view bytes) { readForeign(".ply", bytes); },
    [](std::string_view bytes) { readForeign(".stl", bytes); },
    [](std::string_view bytes) { readForeign(".3ds", bytes); },
    [](std::string_view bytes) { readForeign(".dae", bytes); },
    [](std::string_view bytes) { readForeign(".off", bytes); },
};

}  // namespace

void run(Input in) {
  const auto &read = in.oneOf(kReaders);
  const std::string_view bytes(reinterpret_cast<const char *>(in.data()), in.left());
  try {
    read(bytes);
  } catch (const std::exception &) {  // what the command reports
  }
}

}  // namespace rc::fuzz
