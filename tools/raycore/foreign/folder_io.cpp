// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "foreign/folder_io.h"

#include <assimp/MemoryIOWrapper.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>

#include "input/file.h"

namespace rc::tool::foreign {
namespace {

// Records of MTL that Assimp reads. Of others it takes the first letter for one of these and fails ("aniso").
constexpr std::array<std::string_view, 34> kRecords{
    "newmtl",       "Ka",       "Kd",       "Ks",     "Ke",     "Kt",     "Tf",     "Tr",     "d",
    "Ns",           "Ni",       "illum",    "map_Ka", "map_Kd", "map_Ks", "map_Ke", "map_Ns", "map_d",
    "map_emissive", "map_Bump", "map_bump", "map_Kn", "bump",   "Bump",   "norm",   "refl",   "disp",
    "Pr",           "Pm",       "Ps",       "Pc",     "map_Pr", "map_Pm", "map_Ps"};

std::string knownRecords(const std::string &text) {
  std::istringstream lines(text);
  std::string kept;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string record;
    words >> record;
    if (std::find(kRecords.begin(), kRecords.end(), record) != kRecords.end()) kept += line + '\n';
  }
  return kept + '\n';  // Assimp takes an empty file for a failure
}

Assimp::IOStream *materialStream(const char *file) {
  const std::string text = knownRecords(tool::readFile(file));
  auto *bytes = new uint8_t[text.size()];
  std::copy(text.begin(), text.end(), bytes);
  return new Assimp::MemoryIOStream(bytes, text.size(), true);  // which deletes them
}

}  // namespace

Assimp::IOStream *FolderIO::Open(const char *file, const char *mode) {
  if (!inside(file) || !std::filesystem::is_regular_file(file)) return nullptr;
  return extensionOf(file) == ".mtl" ? materialStream(file) : DefaultIOSystem::Open(file, mode);
}

bool FolderIO::inside(const char *file) const {
  std::error_code error;
  const auto path = std::filesystem::weakly_canonical(file, error);
  const auto ends = std::mismatch(mFolder.begin(), mFolder.end(), path.begin(), path.end());
  return !error && ends.first == mFolder.end();
}

}  // namespace rc::tool::foreign
