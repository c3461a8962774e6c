// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "output/picture_file.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "codec/codec.h"
#include "codec/jpeg.h"
#include "codec/png.h"
#include "input/error.h"
#include "input/file.h"

namespace rc::tool {
namespace {

namespace fs = std::filesystem;

constexpr std::array kOthers{".bmp", ".ppm", ".exr"};

bool isPng(const std::string &name) { return extensionOf(name) == ".png"; }
bool isJpeg(const std::string &name) { return extensionOf(name) == ".jpg" || extensionOf(name) == ".jpeg"; }

void writeBytes(const std::string &bytes, const std::string &file, const std::string &name) {
  std::ofstream out(file, std::ios::binary);
  out.write(bytes.data(), std::streamsize(bytes.size()));
  out.close();
  if (!out) reject("{}: cannot be written: {}", name, std::strerror(errno));
}

void writeTo(const Image &image, const std::string &file, const std::string &name) {
  if (isPng(name)) return writePng(image, file, name);
  if (isJpeg(name)) return writeBytes(encodeJpeg(image), file, name);
  codec().encode(image, file, name);
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
  if (name == "-" || isPng(name) || isJpeg(name)) return;
  if (!std::ranges::count(kOthers, extensionOf(name))) {
    refuseOption("{}: the extension is none of png, jpg, bmp, ppm, exr", name);
  }
  codec();
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
  return isPng(name) ? isWholePng(name, width, height) : codec().isWhole(name, width, height);
}

}  // namespace rc::tool
