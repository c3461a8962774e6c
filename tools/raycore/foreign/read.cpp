// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "foreign/read.h"

#include <assimp/config.h>
#include <assimp/postprocess.h>

#include <assimp/Importer.hpp>

#include "foreign/convert.h"
#include "foreign/folder_io.h"
#include "foreign/obj_check.h"
#include "input/error.h"
#include "input/file.h"

namespace rc::tool::foreign {
namespace {

constexpr unsigned kSteps = aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_GenSmoothNormals |
                            aiProcess_FlipUVs | aiProcess_TransformUVCoords;
// Scans have no edges to keep, boxes do.
constexpr float kLargestSmoothAngle = 50;

std::string oneLine(std::string text) {
  for (char &c : text) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  return text;
}

// Where no file has the name that an OBJ file gives, Assimp takes one that is called as the model is.
FileExists materialFiles(const std::filesystem::path &model, const std::filesystem::path &folder) {
  return [model, folder](const std::string &name) {
    const FolderIO files(folder);
    return files.Exists((folder / name).c_str()) ||
           files.Exists(std::filesystem::path(model).replace_extension("mtl").c_str());
  };
}

}  // namespace

bool reads(const std::string &extension) { return Assimp::Importer().IsExtensionSupported(extension); }

Scene readFile(const std::string &name) {
  Scene scene;
  const std::string extension = extensionOf(name);
  const std::string folder = std::filesystem::absolute(name).parent_path().string();
  if (extension == ".obj") checkObj(tool::readFile(name), materialFiles(name, folder), scene);
  Assimp::Importer importer;
  importer.SetIOHandler(new FolderIO(folder));  // the importer deletes it
  importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, kLargestSmoothAngle);
  const aiScene *from = importer.ReadFile(name, kSteps);
  if (!from || !from->mRootNode) reject("{}", oneLine(importer.GetErrorString()));
  scene.format = extension.substr(1);
  for (char &c : scene.format) c = static_cast<char>(std::toupper(c));
  scene.zUp = extension == ".stl" || extension == ".3ds";
  convertMaterials(*from, folder, scene);
  convertMeshes(*from, scene);
  const NodeNames names = convertNodes(*from, scene);
  convertSkins(*from, names, scene);
  convertAnimations(*from, names, scene);
  convertViews(*from, names, scene);
  return scene;
}

}  // namespace rc::tool::foreign
