// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// material_binding.h: what it means to bind a material. [spec 3.5]
#pragma once

#include "api/context.h"

namespace rc::api {

// A name that is not in use is made; the material's colour texture becomes the current texture. [spec 3.5]
inline void bindMaterial(Context &context, RCuint name) {
  MaterialTable &materials = context.objects().materials;
  if (!materials.contains(name)) materials.make(name, context.boundMaterial());
  context.state.boundMaterial = name;
  const ddk::TextureUse &use = context.boundMaterial().textures[ddk::kColourMap];
  TextureBinding &binding = context.state.texture.bound[ddk::kColourMap];
  binding.texture = use.texture;
  // A deleted texture lives on in its materials, without a name.
  binding.name = context.objects().textures.find(use.name) == use.texture ? use.name : 0;
  context.state.texture.last = ddk::kColourMap;
}

}  // namespace rc::api
