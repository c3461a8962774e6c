// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: materials and colours. [spec 3.5; G 6]
#include "RC/rc.h"
#include "api/convert.h"
#include "api/guard.h"
#include "api/material_binding.h"
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
  if (!parameter)
    context.fail(RC_INVALID_ENUM,
                 "pname 0x%04X is no parameter of materials (a colour, RC_REFLECTION, RC_TRANSMITTANCE, "
                 "RC_REFRACTION_INDEX, RC_SHININESS, RC_SPECULAR_LEVEL)",
                 pname);
  return parameter;
}

// values: three for colours and shares, one for scalars.
void set(Context &context, const MaterialParameter &parameter, const float *values) {
  ddk::Material &material = context.boundMaterial();
  if (parameter.kind == Kind::Scalar) {
    if (!(values[0] >= 0)) {
      return context.fail(RC_INVALID_VALUE, "params is %g for pname 0x%04X, not 0 or more", values[0], parameter.name);
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
    return context.fail(RC_INVALID_ENUM, "pname 0x%04X is a colour; rcMaterialfv sets it", pname);
  }
  const float values[3] = {value, value, value};
  set(context, *parameter, values);
}

// Values that a vector call reads, for the tracer; without a context it looks at one only.
int valuesGiven(RCenum pname) {
  const Context *context = currentContext();
  return context ? materialValueCount(pname, context->profile().colouredReflection) : 1;
}

// read(i): the i-th value of the caller's array; no more are read than the parameter has.
template <class Read>
void setVector(Context &context, RCenum face, RCenum pname, bool hasValues, Read &&read) {
  const MaterialParameter *parameter = find(context, face, pname, false);
  if (!parameter) return;
  if (!hasValues) return context.fail(RC_INVALID_VALUE, "params is NULL, not a pointer to values");
  const int count = materialValueCount(pname, context.profile().colouredReflection);
  float values[3];
  for (int i = 0; i < 3; ++i) values[i] = read(count == 1 ? 0 : i);
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

}  // namespace

extern "C" {

void rcGenMaterials(RCsizei n, RCuint *materials) {
  enter(Call("rcGenMaterials", n, materials), [&](Context &context) {
    if (n < 0) return context.fail(RC_INVALID_VALUE, "n is %d, not 0 or more", n);
    if (!materials) return;
    for (RCsizei i = 0; i < n; ++i) {
      const std::optional<RCuint> name = context.objects().materials.generate(context.boundMaterial());
      if (!name) return context.fail(RC_OUT_OF_MEMORY, "all %u material names are in use", hal::kNamedMaterials - 1);
      materials[i] = *name;
    }
  });
}

void rcDeleteMaterials(RCsizei n, RCuint *materials) {
  enter(Call("rcDeleteMaterials", n, list(materials, n)), [&](Context &context) {
    if (n < 0) return context.fail(RC_INVALID_VALUE, "n is %d, not 0 or more", n);
    if (!materials) return;
    for (RCsizei i = 0; i < n; ++i) {
      context.objects().materials.remove(materials[i]);
      if (materials[i] == context.state.boundMaterial) bindMaterial(context, 0);
    }
  });
}

void rcBindMaterial(RCuint material) {
  enter(Call("rcBindMaterial", material), [&](Context &context) {
    if (!MaterialTable::canExist(material)) {
      return context.fail(RC_OUT_OF_MEMORY, "material is %u, not in 0 ... %u", material, hal::kNamedMaterials - 1);
    }
    bindMaterial(context, material);
  });
}

RCboolean rcIsMaterial(RCuint material) {
  return enter(Call("rcIsMaterial", material), [&](Context &context) -> RCboolean {
    return context.objects().materials.contains(material) ? RC_TRUE : RC_FALSE;
  });
}

void rcMaterialf(RCenum face, RCenum pname, RCfloat param) {
  enter(Call("rcMaterialf", face, pname, param), [&](Context &context) { setScalar(context, face, pname, param); });
}

void rcMaterialx(RCenum face, RCenum pname, RCfixed param) {
  enter(Call("rcMaterialx", face, pname, param),
        [&](Context &context) { setScalar(context, face, pname, fromFixed(param)); });
}

void rcMaterialfv(RCenum face, RCenum pname, const RCfloat *params) {
  enter(Call("rcMaterialfv", face, pname, list(params, [&] { return valuesGiven(pname); })), [&](Context &context) {
    setVector(context, face, pname, params != nullptr, [&](int i) { return params[i]; });
  });
}

void rcMaterialxv(RCenum face, RCenum pname, const RCfixed *params) {
  enter(Call("rcMaterialxv", face, pname, list(params, [&] { return valuesGiven(pname); })), [&](Context &context) {
    setVector(context, face, pname, params != nullptr, [&](int i) { return fromFixed(params[i]); });
  });
}

void rcGetMaterialfv(RCenum face, RCenum pname, RCfloat *params) {
  enter(Call("rcGetMaterialfv", face, pname, params), [&](Context &context) {
    get(context, face, pname, [&](int i, float value) {
      if (params) params[i] = value;
    });
  });
}

void rcGetMaterialxv(RCenum face, RCenum pname, RCfixed *params) {
  enter(Call("rcGetMaterialxv", face, pname, params), [&](Context &context) {
    get(context, face, pname, [&](int i, float value) {
      if (params) params[i] = toFixed(value);
    });
  });
}

void rcColor4f(RCfloat red, RCfloat green, RCfloat blue, RCfloat alpha) {
  enter(Call("rcColor4f", red, green, blue, alpha), [&](Context &context) {
    setColor(context, {red, green, blue, alpha});
  });
}

void rcColor4ub(RCubyte red, RCubyte green, RCubyte blue, RCubyte alpha) {
  enter(Call("rcColor4ub", red, green, blue, alpha),
        [&](Context &context) { setColor(context, Vec4(red, green, blue, alpha) / 255.0f); });
}

void rcColor4x(RCfixed red, RCfixed green, RCfixed blue, RCfixed alpha) {
  enter(Call("rcColor4x", red, green, blue, alpha), [&](Context &context) {
    setColor(context, {fromFixed(red), fromFixed(green), fromFixed(blue), fromFixed(alpha)});
  });
}

}  // extern "C"
