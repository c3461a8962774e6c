// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Parameters by name: lights, materials, fog, texture environment; and the gets. A number is set by the f call, a
// sequence by the fv call; its length is checked here, because C reads as many values as the parameter has.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "core.h"

namespace raycore {
namespace {

using namespace py::literals;

struct Count {
  RCenum name;
  size_t least, most;  // values that a sequence may have
};
constexpr Count kCounts[] = {
    {RC_AMBIENT, 3, 4},
    {RC_DIFFUSE, 3, 4},
    {RC_SPECULAR, 3, 4},
    {RC_AMBIENT_AND_DIFFUSE, 3, 4},
    {RC_EMISSION, 3, 4},
    {RC_REFLECTION, 3, 3},
    {RC_TRANSMITTANCE, 3, 3},
    {RC_POSITION, 4, 4},
    {RC_SPOT_DIRECTION, 3, 3},
    {RC_ATTENUATION_RANGE, 2, 2},
    {RC_FOG_COLOR, 4, 4},
    {RC_TEXTURE_ENV_COLOR, 4, 4},
    {RC_LIGHT_MODEL_AMBIENT, 4, 4},
    {RC_POINT_DISTANCE_ATTENUATION, 3, 3},
};

// One value, or as many as the parameter has; names that are none go to C, which says so.
std::vector<float> valuesFor(RCenum pname, const py::object &value, const char *call) {
  std::vector<float> found = values(value, std::string(call) + ": value");
  const auto *row =
      std::find_if(std::begin(kCounts), std::end(kCounts), [&](const Count &c) { return c.name == pname; });
  const bool scalar = py::array(value).ndim() == 0;
  const size_t least = row == std::end(kCounts) ? 1 : row->least, most = row == std::end(kCounts) ? 1 : row->most;
  if (scalar || (found.size() >= least && found.size() <= most)) {
    if (!scalar) found.resize(16, 1.0f);  // nothing of C's reads beyond it
    return found;
  }
  char text[96];
  std::snprintf(text, sizeof text, "%s: parameter 0x%04X takes %zu values, got %zu", call, pname, least, found.size());
  throw py::value_error(text);
}

// rcXf for one value, rcXfv for several, with what stands before pname.
template <class... Before>
void set(const char *call, void (*one)(Before..., RCenum, RCfloat), void (*several)(Before..., RCenum, const RCfloat *),
         Before... before, RCenum pname, const py::object &value) {
  const std::vector<float> given = valuesFor(pname, value, call);
  if (given.size() == 1) {
    one(before..., pname, given[0]);
  } else {
    several(before..., pname, given.data());
  }
  throwIfFailed();
}

// What a get writes, found out by asking twice into memory of different content.
template <class Value, class Get>
py::object ask(Get &&get) {
  constexpr size_t kMost = 64;
  Value first[kMost], second[kMost];
  std::memset(first, 0x55, sizeof first);
  std::memset(second, 0x2A, sizeof second);
  get(first);
  throwIfFailed();
  get(second);
  size_t count = 0;
  while (count < kMost && !std::memcmp(&first[count], &second[count], sizeof(Value))) ++count;
  if (count == 1) return py::cast(first[0]);
  py::array_t<Value> result(static_cast<py::ssize_t>(count));
  std::copy_n(first, count, result.mutable_data());
  // Column by column in C; rows and columns of numpy are those of mathematics.
  return count == 16 ? py::object(result.attr("reshape")(4, 4).attr("T").attr("copy")()) : py::object(result);
}

void addSetters(py::module_ &m) {
  m.def(
      "light",
      [](RCenum light, RCenum pname, const py::object &value) {
        set<RCenum>("light", rcLightf, rcLightfv, light, pname, value);
      },
      "light"_a, "pname"_a, "value"_a);
  m.def(
      "material",
      [](RCenum pname, const py::object &value) {
        set<RCenum>("material", rcMaterialf, rcMaterialfv, RC_FRONT_AND_BACK, pname, value);
      },
      "pname"_a, "value"_a);
  m.def(
      "light_model",
      [](RCenum pname, const py::object &value) { set<>("light_model", rcLightModelf, rcLightModelfv, pname, value); },
      "pname"_a, "value"_a);
  m.def(
      "fog", [](RCenum pname, const py::object &value) { set<>("fog", rcFogf, rcFogfv, pname, value); }, "pname"_a,
      "value"_a);
  m.def(
      "point_parameter",
      [](RCenum pname, const py::object &value) {
        set<>("point_parameter", rcPointParameterf, rcPointParameterfv, pname, value);
      },
      "pname"_a, "value"_a);
  m.def(
      "tex_env",
      [](RCenum pname, const py::object &value, RCenum target) {
        set<RCenum>("tex_env", rcTexEnvf, rcTexEnvfv, target, pname, value);
      },
      "pname"_a, "value"_a, "target"_a = RC_TEXTURE_ENV);
  m.def(
      "tex_parameter",
      [](RCenum pname, RCint value, RCenum target) {
        rcTexParameteri(target, pname, value);
        throwIfFailed();
      },
      "pname"_a, "value"_a, "target"_a = RC_TEXTURE_2D);
}

void addGetters(py::module_ &m) {
  m.def(
      "get_float", [](RCenum pname) { return ask<RCfloat>([=](RCfloat *out) { rcGetFloatv(pname, out); }); },
      "pname"_a);
  m.def(
      "get_integer", [](RCenum pname) { return ask<RCint>([=](RCint *out) { rcGetIntegerv(pname, out); }); },
      "pname"_a);
  m.def(
      "get_boolean",
      [](RCenum pname) {
        const py::object found = ask<RCint>([=](RCint *out) { rcGetIntegerv(pname, out); });
        return py::array(found).attr("astype")("bool").attr("tolist")();
      },
      "pname"_a);
  m.def(
      "get_light",
      [](RCenum light, RCenum pname) { return ask<RCfloat>([=](RCfloat *out) { rcGetLightfv(light, pname, out); }); },
      "light"_a, "pname"_a);
  m.def(
      "get_material",
      [](RCenum pname) { return ask<RCfloat>([=](RCfloat *out) { rcGetMaterialfv(RC_FRONT_AND_BACK, pname, out); }); },
      "pname"_a);
  m.def(
      "get_tex_env",
      [](RCenum pname, RCenum target) {
        return ask<RCfloat>([=](RCfloat *out) { rcGetTexEnvfv(target, pname, out); });
      },
      "pname"_a, "target"_a = RC_TEXTURE_ENV);
  m.def(
      "get_tex_parameter",
      [](RCenum pname, RCenum target) {
        RCint values[4] = {};
        rcGetTexParameteriv(target, pname, values);
        throwIfFailed();
        return values[0];
      },
      "pname"_a, "target"_a = RC_TEXTURE_2D);
  m.def(
      "get_clip_plane", [](RCenum plane) { return ask<RCfloat>([=](RCfloat *out) { rcGetClipPlanef(plane, out); }); },
      "plane"_a);
  m.def(
      "get_string",
      [](RCenum name) {
        const RCubyte *text = rcGetString(name);
        throwIfFailed();
        return std::string(reinterpret_cast<const char *>(text));
      },
      "name"_a);
}

std::vector<float> exactly(const py::object &object, const char *name, size_t count) {
  std::vector<float> found = values(object, name);
  if (found.size() == count) return found;
  throw py::value_error(std::string(name) + ": " + std::to_string(count) + " values expected, got " +
                        std::to_string(found.size()));
}

void addVectors(py::module_ &m) {
  m.def(
      "look_at",
      [](const py::object &eye, const py::object &center, const py::object &up) {
        const std::vector<float> e = exactly(eye, "eye", 3), c = exactly(center, "center", 3), u = exactly(up, "up", 3);
        rcuLookAt(e[0], e[1], e[2], c[0], c[1], c[2], u[0], u[1], u[2]);
        throwIfFailed();
      },
      "eye"_a, "center"_a, "up"_a = py::make_tuple(0, 1, 0));
  m.def(
      "clip_plane",
      [](RCenum plane, const py::object &equation) {
        rcClipPlanef(plane, exactly(equation, "equation", 4).data());
        throwIfFailed();
      },
      "plane"_a, "equation"_a);
  // Matrices of numpy are read row by row; C takes columns.
  const auto matrixCall = [&](const char *name, void (*call)(const RCfloat *)) {
    m.def(
        name,
        [call](const py::object &matrix) {
          const Array<float> rows(numbers(matrix, "matrix"));
          if (rows.ndim() != 2 || rows.shape(0) != 4 || rows.shape(1) != 4) {
            throw py::value_error("matrix: shape (4, 4) expected, got " + describe(rows));
          }
          float columns[16];
          for (int i = 0; i < 16; ++i) columns[i] = rows.at(i % 4, i / 4);
          call(columns);
          throwIfFailed();
        },
        "matrix"_a);
  };
  matrixCall("load_matrix", rcLoadMatrixf);
  matrixCall("mult_matrix", rcMultMatrixf);
}

}  // namespace

void addParameters(py::module_ &module) {
  addSetters(module);
  addGetters(module);
  addVectors(module);
}

}  // namespace raycore
