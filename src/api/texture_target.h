// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// texture_target.h: the place of a material that a texture target names.
#pragma once

#include <optional>

#include "api/context.h"

namespace rc::api {

// The place, or RC_INVALID_ENUM and nothing.
inline std::optional<ddk::TextureSlot> checkTarget(Context &context, RCenum target) {
  if (target == RC_TEXTURE_2D) return ddk::kColourMap;
  if (target == RC_TEXTURE_2D_NORMAL) return ddk::kNormalMap;
  context.fail(RC_INVALID_ENUM, "target 0x%04X is not RC_TEXTURE_2D or RC_TEXTURE_2D_NORMAL", target);
  return std::nullopt;
}

}  // namespace rc::api
