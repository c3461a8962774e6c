// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include <assimp/ObjMaterial.h>
#include <assimp/material.h>

#include <algorithm>

#include "codec/picture.h"
#include "foreign/convert.h"
#include "input/error.h"
#include "input/file.h"

namespace rc::tool::foreign {
namespace {

class MaterialReader {
 public:
  MaterialReader(const aiScene &from, const std::string &folder, Scene &to) : mFrom(from), mFolder(folder), mTo(to) {}

  void read(const aiMaterial &from) {
    Material material;
    material.classic = true;
    material.name = from.GetName().C_Str();
    readColours(from, material.phong);
    readTransparency(from, material);
    material.phong.shininess = number(from, AI_MATKEY_SHININESS, 0);
    int twoSided = 0;
    from.Get(AI_MATKEY_TWOSIDED, twoSided);
    material.doubleSided = twoSided != 0;
    material.baseTexture.texture = texture(from, aiTextureType_DIFFUSE);
    if (material.baseTexture.texture < 0) material.baseTexture.texture = texture(from, aiTextureType_BASE_COLOR);
    material.normalTexture.texture = texture(from, aiTextureType_NORMALS);
    if (from.GetTextureCount(aiTextureType_HEIGHT) > 0) {
      mTo.note("bump maps: RayCore takes normal maps, not heights; not used");
    }
    mTo.materials.push_back(std::move(material));
  }

 private:
  static float number(const aiMaterial &from, const char *key, unsigned type, unsigned index, float missing) {
    ai_real value = missing;
    return from.Get(key, type, index, value) == AI_SUCCESS ? value : missing;
  }
  static Vec3 colour(const aiMaterial &from, const char *key, unsigned type, unsigned index, const Vec3 &missing) {
    aiColor3D value;
    return from.Get(key, type, index, value) == AI_SUCCESS ? asVec3(value) : missing;
  }

  void readColours(const aiMaterial &from, Classic &phong) {
    phong.diffuse = colour(from, AI_MATKEY_COLOR_DIFFUSE, phong.diffuse);
    phong.ambient = phong.diffuse;
    phong.specular = colour(from, AI_MATKEY_COLOR_SPECULAR, Vec3(0)) * number(from, AI_MATKEY_SHININESS_STRENGTH, 1);
    phong.emission = colour(from, AI_MATKEY_COLOR_EMISSIVE, Vec3(0));
    const Vec3 ambient = colour(from, AI_MATKEY_COLOR_AMBIENT, Vec3(0));
    if (maxOf(ambient) > 1) {
      mTo.note("ambient colours above 1: taken as light of the surface's own");
      phong.emission = glm::max(phong.emission, ambient);
    }
  }

  // MTL's illumination models: 3, 5, 8 mirror; 4, 6, 7, 9 are glass; 6 and 7 refract.
  void readTransparency(const aiMaterial &from, Material &material) {
    int illumination = 2;
    from.Get(AI_MATKEY_OBJ_ILLUM, illumination);
    const float opacity = std::clamp(number(from, AI_MATKEY_OPACITY, 1), 0.0f, 1.0f);
    const float mirror = number(from, AI_MATKEY_REFLECTIVITY, 0);
    const bool mirrors = illumination >= 3 && illumination <= 9;
    material.phong.reflection = mirrors ? material.phong.specular : Vec3(std::clamp(mirror, 0.0f, 1.0f));
    if (mirror > 0 && illumination == 2) mTo.note("reflectivity: a share of the mirrored ray");
    material.phong.transmittance = Vec3(1 - opacity);
    const bool refracts = illumination == 6 || illumination == 7;
    material.ior = refracts ? std::max(number(from, AI_MATKEY_REFRACTI, 1), 1.0f) : 1;
  }

  int texture(const aiMaterial &from, aiTextureType type) {
    aiString path;
    aiTextureMapMode modes[2] = {aiTextureMapMode_Wrap, aiTextureMapMode_Wrap};
    if (from.GetTexture(type, 0, &path, nullptr, nullptr, nullptr, nullptr, modes) != AI_SUCCESS) return -1;
    const int image = imageOf(path.C_Str());
    if (image < 0) return -1;
    mTo.textures.push_back({image, wrapOf(modes[0]), wrapOf(modes[1])});
    return static_cast<int>(mTo.textures.size()) - 1;
  }

  static Wrap wrapOf(aiTextureMapMode mode) {
    return mode == aiTextureMapMode_Clamp ? Wrap::Clamp : mode == aiTextureMapMode_Mirror ? Wrap::Mirror : Wrap::Repeat;
  }

  int imageOf(const std::string &path) {
    const auto known = mImages.find(path);
    if (known != mImages.end()) return known->second;
    int index = -1;
    try {
      mTo.images.push_back(readImage(path));
      index = static_cast<int>(mTo.images.size()) - 1;
    } catch (const InputError &error) {
      mTo.note(fmt::format("texture \"{}\": {}; drawn without it", path, error.what()));
    }
    return mImages[path] = index;
  }

  Image readImage(std::string path) {
    if (const aiTexture *embedded = mFrom.GetEmbeddedTexture(path.c_str())) return embeddedImage(*embedded, path);
    std::replace(path.begin(), path.end(), '\\', '/');
    if (path.starts_with('/') || path.find("..") != std::string::npos) reject("leaves the model's folder");
    return decodePicture(readFile(mFolder + "/" + path), path);
  }

  static Image embeddedImage(const aiTexture &from, const std::string &name) {
    const char *bytes = reinterpret_cast<const char *>(from.pcData);
    if (from.mHeight == 0) return decodePicture(std::string(bytes, from.mWidth), name);
    Image image{name, int(from.mWidth), int(from.mHeight), {}};
    for (size_t i = 0; i < size_t(from.mWidth) * from.mHeight; ++i) {
      const aiTexel &texel = from.pcData[i];
      image.rgba.insert(image.rgba.end(), {texel.r, texel.g, texel.b, texel.a});
    }
    return image;
  }

  const aiScene &mFrom;
  const std::string &mFolder;
  Scene &mTo;
  std::map<std::string, int> mImages;
};

}  // namespace

void convertMaterials(const aiScene &from, const std::string &folder, Scene &to) {
  MaterialReader reader(from, folder, to);
  for (unsigned i = 0; i < from.mNumMaterials; ++i) reader.read(*from.mMaterials[i]);
}

}  // namespace rc::tool::foreign
