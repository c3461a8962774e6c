// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: materials and colours. [spec 3.5; G 6]
#include "RC/rc.h"
#include "api/convert.h"
#include "api/guard.h"
#include "api/material_parameters.h"

using namespace rc;
using namespace rc::api;

namespace {

using Kind = MaterialParameter::Kind;

// The parameter, or an error and null.
const MaterialParameter *find(Context &context, RCenum face, RCenum pname, bool get) {
  const bool oneSide = face == RC_FRONT || face == RC_BACK;
  if (face != RC_FRONT_AND_BACK && !(get && oneSide)) {
    context.fail(RC_INVALID_ENUM, "face 0x%04X is not RC_FRONT_AND_BACK", face);
    return nullptr;
  }
  const MaterialParameter *parameter = findMaterialParameter(pname);
  if (!parameter) context.fail(RC_INVALID_ENUM, "0x%04X is no material parameter", pname);
  return parameter;
}

// values: three for colours and shares, one for scalars.
void set(Context &context, const MaterialParameter &parameter, const float *values) {
  ddk::Material &material = context.boundMaterial();
  if (parameter.kind == Kind::Scalar) {
    if (!(values[0] >= 0)) {
      return context.fail(RC_INVALID_VALUE, "%g is below 0 for parameter 0x%04X", values[0], parameter.name);
    }
    *parameter.scalar(material) = values[0];
  } else {
    *parameter.colour(material) = clamp01(values);
    if (parameter.name == RC_AMBIENT_AND_DIFFUSE) material.diffuse = material.ambient;
  }
  context.touch();
}

void setScalar(Context &context, RCenum face, RCenum pname, float value) {
  const MaterialParameter *parameter = find(context, face, pname, false);
  if (!parameter) return;
  if (parameter->kind == Kind::Colour) {
    return context.fail(RC_INVALID_ENUM, "parameter 0x%04X is a colour; use rcMaterialfv", pname);
  }
  const float values[3] = {value, value, value};
  set(context, *parameter, values);
}

// read(i): the i-th value of the caller's array; no more are read than the parameter has.
template <class Read>
void setVector(Context &context, RCenum face, RCenum pname, bool hasValues, Read &&read) {
  const MaterialParameter *parameter = find(context, face, pname, false);
  if (!parameter) return;
  if (!hasValues) return context.fail(RC_INVALID_VALUE, "params is NULL");
  const bool single =
      parameter->kind == Kind::Scalar || (parameter->kind == Kind::Share && !context.profile().colouredReflection);
  float values[3];
  for (int i = 0; i < 3; ++i) values[i] = read(single ? 0 : i);
  set(context, *parameter, values);
}

// write(i, value) for each value of the parameter: colours and shares have four, alpha 1.
template <class Write>
void get(Context &context, RCenum face, RCenum pname, Write &&write) {
  const MaterialParameter *parameter = find(context, face, pname, true);
  if (!parameter) return;
  ddk::Material &material = context.boundMaterial();
  if (parameter->kind == Kind::Scalar) return write(0, *parameter->scalar(material));
  const Rgb colour = *parameter->colour(material);
  const int channels = parameter->kind == Kind::Share && !context.profile().colouredReflection ? 1 : 3;
  for (int i = 0; i < channels; ++i) write(i, colour[i]);
  if (parameter->kind == Kind::Colour) write(3, 1.0f);
}

void setColor(Context &context, const Vec4 &given) {
  Vec4 &colour = context.state.currentColor;
  for (int i = 0; i < 4; ++i) colour[i] = clamp01(given[i]);
  ddk::Material &material = context.boundMaterial();
  material.ambient = material.diffuse = Rgb(colour);
  material.specular = Rgb(0);
  context.touch();
}

// A name that is not in use is made; the material's colour texture becomes the current texture. [spec 3.5]
void bind(Context &context, RCuint name) {
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

}  // namespace

extern "C" {

void rcGenMaterials(RCsizei n, RCuint *materials) {
  enter("rcGenMaterials", [&](Context &context) {
    if (n < 0) return context.fail(RC_INVALID_VALUE, "n is %d", n);
    if (!materials) return;
    for (RCsizei i = 0; i < n; ++i) {
      const std::optional<RCuint> name = context.objects().materials.generate(context.boundMaterial());
      if (!name) return context.fail(RC_OUT_OF_MEMORY, "all %u material names are in use", hal::kNamedMaterials - 1);
      materials[i] = *name;
    }
  });
}

void rcDeleteMaterials(RCsizei n, RCuint *materials) {
  enter("rcDeleteMaterials", [&](Context &context) {
    if (n < 0) return context.fail(RC_INVALID_VALUE, "n is %d", n);
    if (!materials) return;
    for (RCsizei i = 0; i < n; ++i) {
      context.objects().materials.remove(materials[i]);
      if (materials[i] == context.state.boundMaterial) bind(context, 0);
    }
  });
}

void rcBindMaterial(RCuint material) {
  enter("rcBindMaterial", [&](Context &context) {
    if (!MaterialTable::canExist(material)) {
      return context.fail(RC_OUT_OF_MEMORY, "%u is above the last material name, %u", material,
                          hal::kNamedMaterials - 1);
    }
    bind(context, material);
  });
}

RCboolean rcIsMaterial(RCuint material) {
  return enter("rcIsMaterial", [&](Context &context) -> RCboolean {
    return context.objects().materials.contains(material) ? RC_TRUE : RC_FALSE;
  });
}

void rcMaterialf(RCenum face, RCenum pname, RCfloat param) {
  enter("rcMaterialf", [&](Context &context) { setScalar(context, face, pname, param); });
}

void rcMaterialx(RCenum face, RCenum pname, RCfixed param) {
  enter("rcMaterialx", [&](Context &context) { setScalar(context, face, pname, fromFixed(param)); });
}

void rcMaterialfv(RCenum face, RCenum pname, const RCfloat *params) {
  enter("rcMaterialfv", [&](Context &context) {
    setVector(context, face, pname, params != nullptr, [&](int i) { return params[i]; });
  });
}

void rcMaterialxv(RCenum face, RCenum pname, const RCfixed *params) {
  enter("rcMaterialxv", [&](Context &context) {
    setVector(context, face, pname, params != nullptr, [&](int i) { return fromFixed(params[i]); });
  });
}

void rcGetMaterialfv(RCenum face, RCenum pname, RCfloat *params) {
  enter("rcGetMaterialfv", [&](Context &context) {
    get(context, face, pname, [&](int i, float value) {
      if (params) params[i] = value;
    });
  });
}

void rcGetMaterialxv(RCenum face, RCenum pname, RCfixed *params) {
  enter("rcGetMaterialxv", [&](Context &context) {
    get(context, face, pname, [&](int i, float value) {
      if (params) params[i] = toFixed(value);
    });
  });
}

void rcColor4f(RCfloat red, RCfloat green, RCfloat blue, RCfloat alpha) {
  enter("rcColor4f", [&](Context &context) { setColor(context, {red, green, blue, alpha}); });
}

void rcColor4ub(RCubyte red, RCubyte green, RCubyte blue, RCubyte alpha) {
  enter("rcColor4ub", [&](Context &context) { setColor(context, Vec4(red, green, blue, alpha) / 255.0f); });
}

void rcColor4x(RCfixed red, RCfixed green, RCfixed blue, RCfixed alpha) {
  enter("rcColor4x", [&](Context &context) {
    setColor(context, {fromFixed(red), fromFixed(green), fromFixed(blue), fromFixed(alpha)});
  });
}

}  // extern "C"
