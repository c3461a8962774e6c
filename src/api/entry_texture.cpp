// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: texture objects and their parameters. [spec 3.4; G 5]
#include "RC/rc.h"
#include "api/convert.h"
#include "api/guard.h"
#include "api/texture_target.h"

using namespace rc;
using namespace rc::api;

namespace {

constexpr char kNoTextureParameter[] =
    "pname 0x%04X is not RC_TEXTURE_WRAP_S, _WRAP_T, _MIN_FILTER, _MAG_FILTER, RC_GENERATE_MIPMAP, "
    "RC_TEXTURE_OPAQUE_ALPHA or RC_TEXTURE_MAX_ANISOTROPY_EXT";

bool isWrap(RCenum value) { return value == RC_REPEAT || value == RC_CLAMP_TO_EDGE || value == RC_MIRRORED_REPEAT; }

// A wrap mode goes to the texture, and to the material that is bound if it is an object. [spec 3.4]
void setWrap(Context &context, ddk::TextureSlot slot, RCenum pname, RCenum value) {
  if (!isWrap(value))
    return context.fail(RC_INVALID_ENUM, "param 0x%04X is not RC_REPEAT, RC_CLAMP_TO_EDGE or RC_MIRRORED_REPEAT",
                        value);
  const bool s = pname == RC_TEXTURE_WRAP_S;
  ddk::Texture &texture = *context.state.texture.bound[slot].texture;
  (s ? texture.wrapS : texture.wrapT) = value;
  if (context.state.boundMaterial != 0) {
    ddk::TextureUse &use = context.boundMaterial().textures[slot];
    (s ? use.wrapS : use.wrapT) = value;
  }
  context.touch();
}

void setParameter(Context &context, RCenum target, RCenum pname, RCint value) {
  const auto slot = checkTarget(context, target);
  if (!slot) return;
  ddk::Texture &texture = *context.state.texture.bound[*slot].texture;
  switch (pname) {
    case RC_TEXTURE_WRAP_S:
    case RC_TEXTURE_WRAP_T:
      return setWrap(context, *slot, pname, static_cast<RCenum>(value));
    case RC_TEXTURE_MIN_FILTER:
      texture.minFilter = static_cast<RCenum>(value);
      break;
    case RC_TEXTURE_MAG_FILTER:
      texture.magFilter = static_cast<RCenum>(value);
      break;
    case RC_GENERATE_MIPMAP:
      context.state.texture.generateMipmap = value != 0;
      break;
    case RC_TEXTURE_OPAQUE_ALPHA:
      if (value < 1 || value > 255) return context.fail(RC_INVALID_VALUE, "param is %d, not in 1 ... 255", value);
      texture.opaqueAlpha = value;
      break;
    case RC_TEXTURE_MAX_ANISOTROPY_EXT:
      if (value < 1) return context.fail(RC_INVALID_VALUE, "param is %d, not 1 or more", value);
      texture.anisotropy = std::min(value, ddk::kMostAnisotropy);
      break;
    default:
      return context.fail(RC_INVALID_ENUM, kNoTextureParameter, pname);
  }
  context.touch();
}

template <class Value>
void getParameter(Context &context, RCenum target, RCenum pname, Value *params) {
  const auto slot = checkTarget(context, target);
  if (!slot) return;
  const ddk::Texture &texture = *context.state.texture.bound[*slot].texture;
  const ddk::TextureUse &use = context.boundMaterial().textures[*slot];
  RCint value = 0;
  switch (pname) {
    case RC_TEXTURE_WRAP_S:
      value = RCint(use.wrapS.value_or(texture.wrapS));
      break;
    case RC_TEXTURE_WRAP_T:
      value = RCint(use.wrapT.value_or(texture.wrapT));
      break;
    case RC_TEXTURE_MIN_FILTER:
      value = RCint(texture.minFilter);
      break;
    case RC_TEXTURE_MAG_FILTER:
      value = RCint(texture.magFilter);
      break;
    case RC_GENERATE_MIPMAP:
      value = context.state.texture.generateMipmap;
      break;
    case RC_TEXTURE_OPAQUE_ALPHA:
      value = texture.opaqueAlpha;
      break;
    case RC_TEXTURE_MAX_ANISOTROPY_EXT:
      value = texture.anisotropy;
      break;
    default:
      return context.fail(RC_INVALID_ENUM, kNoTextureParameter, pname);
  }
  if (params) *params = static_cast<Value>(value);
}

void bind(Context &context, ddk::TextureSlot slot, RCuint name) {
  const std::shared_ptr<ddk::Texture> texture = context.objects().textures.bind(name);
  context.state.texture.bound[slot] = {name, texture};
  context.state.texture.last = slot;
  ddk::TextureUse &use = context.boundMaterial().textures[slot];
  use.name = name;
  use.texture = texture;
  context.touch();
}

// The state without a material object is GL's: what was bound gives way to texture 0. Material objects keep theirs.
void unbind(Context &context, RCuint name) {
  const std::shared_ptr<ddk::Texture> texture = context.objects().textures.bind(0);
  for (TextureBinding &binding : context.state.texture.bound) {
    if (binding.name == name) binding = {0, texture};
  }
  for (ddk::TextureUse &use : context.state.material0.textures) {
    if (use.name != name) continue;
    use.name = 0;
    use.texture = texture;
    context.touch();
  }
}

}  // namespace

extern "C" {

void rcGenTextures(RCsizei n, RCuint *textures) {
  enter(Call("rcGenTextures", n, textures), [&](Context &context) {
    if (n < 0) return context.fail(RC_INVALID_VALUE, "n is %d, not 0 or more", n);
    for (RCsizei i = 0; textures && i < n; ++i) textures[i] = context.objects().textures.generate();
  });
}

void rcDeleteTextures(RCsizei n, const RCuint *textures) {
  enter(Call("rcDeleteTextures", n, list(textures, n)), [&](Context &context) {
    if (n < 0) return context.fail(RC_INVALID_VALUE, "n is %d, not 0 or more", n);
    for (RCsizei i = 0; textures && i < n; ++i) {
      if (textures[i] == 0) continue;
      context.objects().textures.remove(textures[i]);
      unbind(context, textures[i]);
    }
  });
}

void rcBindTexture(RCenum target, RCuint texture) {
  enter(Call("rcBindTexture", target, texture), [&](Context &context) {
    if (const auto slot = checkTarget(context, target)) bind(context, *slot, texture);
  });
}

RCboolean rcIsTexture(RCuint texture) {
  return enter(Call("rcIsTexture", texture), [&](Context &context) -> RCboolean {
    return context.objects().textures.contains(texture) ? RC_TRUE : RC_FALSE;
  });
}

void rcTexParameterf(RCenum target, RCenum pname, RCfloat param) {
  enter(Call("rcTexParameterf", target, pname, param),
        [&](Context &context) { setParameter(context, target, pname, roundToInt(param)); });
}

void rcTexParameteri(RCenum target, RCenum pname, RCint param) {
  enter(Call("rcTexParameteri", target, pname, param),
        [&](Context &context) { setParameter(context, target, pname, param); });
}

// Tokens and counts are not scaled: x values are plain integers here, as in GL.
void rcTexParameterx(RCenum target, RCenum pname, RCfixed param) {
  enter(Call("rcTexParameterx", target, pname, param),
        [&](Context &context) { setParameter(context, target, pname, param); });
}

void rcTexParameterfv(RCenum target, RCenum pname, const RCfloat *params) {
  enter(Call("rcTexParameterfv", target, pname, list(params, 1)), [&](Context &context) {
    if (params) setParameter(context, target, pname, roundToInt(*params));
  });
}

void rcTexParameteriv(RCenum target, RCenum pname, const RCint *params) {
  enter(Call("rcTexParameteriv", target, pname, list(params, 1)), [&](Context &context) {
    if (params) setParameter(context, target, pname, *params);
  });
}

void rcTexParameterxv(RCenum target, RCenum pname, const RCfixed *params) {
  enter(Call("rcTexParameterxv", target, pname, list(params, 1)), [&](Context &context) {
    if (params) setParameter(context, target, pname, *params);
  });
}

void rcGetTexParameterfv(RCenum target, RCenum pname, RCfloat *params) {
  enter(Call("rcGetTexParameterfv", target, pname, params),
        [&](Context &context) { getParameter(context, target, pname, params); });
}

void rcGetTexParameteriv(RCenum target, RCenum pname, RCint *params) {
  enter(Call("rcGetTexParameteriv", target, pname, params),
        [&](Context &context) { getParameter(context, target, pname, params); });
}

void rcGetTexParameterxv(RCenum target, RCenum pname, RCfixed *params) {
  enter(Call("rcGetTexParameterxv", target, pname, params),
        [&](Context &context) { getParameter(context, target, pname, params); });
}

}  // extern "C"
