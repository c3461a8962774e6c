// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// material_table.h: the material objects 1 ... 511 by name, shared by the contexts of a group. Material 0, the state
// without an object, and which material is bound belong to each context. [spec 3.5; reference 4.2]
#pragma once

#include <optional>
#include <vector>

#include "RC/rctypes.h"
#include "base/memory.h"
#include "rcddk/material.h"

namespace rc::api {

class MaterialTable {
 public:
  // texture0: the texture object of name 0, which every material has until another is bound.
  explicit MaterialTable(std::shared_ptr<ddk::Texture> texture0)
      : mRows(hal::kNamedMaterials), mInUse(hal::kNamedMaterials), mTexture0(std::move(texture0)) {
    mInUse[0] = true;
  }

  std::span<const ddk::Material> rows() const { return mRows; }
  const std::shared_ptr<ddk::Texture> &texture0() const { return mTexture0; }
  ddk::Material &operator[](RCuint name) { return mRows[name]; }
  const ddk::Material &operator[](RCuint name) const { return mRows[name]; }
  static bool canExist(RCuint name) { return name < hal::kNamedMaterials; }
  bool contains(RCuint name) const { return canExist(name) && mInUse[name]; }

  // A copy of `original` under the lowest free name; nothing if all are in use.
  std::optional<RCuint> generate(const ddk::Material &original) {
    for (RCuint name = 1; name < mRows.size(); ++name) {
      if (mInUse[name]) continue;
      make(name, original);
      return name;
    }
    return std::nullopt;
  }

  void make(RCuint name, const ddk::Material &original) {
    mRows[name] = original;
    for (ddk::TextureUse &use : mRows[name].textures) {  // only textures in use are copied along
      if (use.enabled) continue;
      use.name = 0;
      use.texture = mTexture0;
    }
    mInUse[name] = true;
  }

  // The values stay for triangles that still name the material, until the name is made anew.
  void remove(RCuint name) {
    if (name != 0 && canExist(name)) mInUse[name] = false;
  }

 private:
  Array<ddk::Material> mRows;  // row 0 is not used
  std::vector<bool> mInUse;
  std::shared_ptr<ddk::Texture> mTexture0;
};

}  // namespace rc::api
