// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// material_table.h: the 512 materials by name and which one is bound. [spec 3.5; reference 4.2]
#pragma once

#include <optional>
#include <vector>

#include "RC/rctypes.h"
#include "rcddk/material.h"

namespace rc::api {

class MaterialTable {
 public:
  // texture0: the texture object of name 0, which every material has until another is bound.
  MaterialTable(float specularLevel, std::shared_ptr<ddk::Texture> texture0)
      : mRows(hal::kNamedMaterials), mInUse(hal::kNamedMaterials), mTexture0(std::move(texture0)) {
    for (ddk::Material &row : mRows) {
      row.specularLevel = specularLevel;
      for (ddk::TextureUse &use : row.textures) use.texture = mTexture0;
    }
    mInUse[0] = true;
  }

  std::span<const ddk::Material> rows() const { return mRows; }
  RCuint boundName() const { return mBound; }
  ddk::Material &bound() { return mRows[mBound]; }
  const ddk::Material &bound() const { return mRows[mBound]; }
  bool contains(RCuint name) const { return name < mRows.size() && mInUse[name]; }

  // A copy of the bound material under the lowest free name; nothing if all are in use.
  std::optional<RCuint> generate() {
    for (RCuint name = 1; name < mRows.size(); ++name) {
      if (mInUse[name]) continue;
      make(name);
      return name;
    }
    return std::nullopt;
  }

  // False for names that cannot exist.
  bool bind(RCuint name) {
    if (name >= mRows.size()) return false;
    if (!mInUse[name]) make(name);
    mBound = name;
    return true;
  }

  // The values stay for triangles that still name the material, until the name is made anew.
  void remove(RCuint name) {
    if (name == 0 || !contains(name)) return;
    mInUse[name] = false;
    if (mBound == name) mBound = 0;
  }

 private:
  void make(RCuint name) {
    mRows[name] = mRows[mBound];
    for (ddk::TextureUse &use : mRows[name].textures) {  // only textures in use are copied along
      if (use.enabled) continue;
      use.name = 0;
      use.texture = mTexture0;
    }
    mInUse[name] = true;
  }

  std::vector<ddk::Material> mRows;
  std::vector<bool> mInUse;
  std::shared_ptr<ddk::Texture> mTexture0;
  RCuint mBound = 0;
};

}  // namespace rc::api
