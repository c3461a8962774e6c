// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// folder_io.h: Assimp's way to files: the model's folder and nothing outside it.
#pragma once

#include <assimp/DefaultIOSystem.h>

#include <filesystem>

namespace rc::tool::foreign {

class FolderIO : public Assimp::DefaultIOSystem {
 public:
  explicit FolderIO(const std::filesystem::path &folder) : mFolder(std::filesystem::weakly_canonical(folder)) {}

  bool Exists(const char *file) const override { return inside(file) && DefaultIOSystem::Exists(file); }
  Assimp::IOStream *Open(const char *file, const char *mode) override;

 private:
  bool inside(const char *file) const;

  std::filesystem::path mFolder;
};

}  // namespace rc::tool::foreign
