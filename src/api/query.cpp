// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "api/query.h"

#include "RC/rc.h"
#include "api/arrays.h"

namespace rc::api {
namespace {

using Kind = QueryResult::Kind;

struct QueryRow {
  RCenum name;
  Kind kind;
  int count;
  void (*read)(const Context &context, double *values);
};

void writeMatrix(const Mat4 &matrix, double *values) {
  for (int i = 0; i < 16; ++i) values[i] = matrix[i / 4][i % 4];
}

void writeColour(const Vec4 &colour, double *values) {
  for (int i = 0; i < 4; ++i) values[i] = colour[i];
}

void writeColour(const Rgb &colour, double *values) { writeColour(Vec4(colour, 1), values); }

// A row whose value never changes.
template <int Value>
void constant(const Context &, double *values) {
  values[0] = Value;
}

constexpr QueryRow kRows[] = {
    // camera
    {RC_VIEWPORT, Kind::Number, 4,
     [](const Context &c, double *v) {
       const ViewState &view = c.state.view;
       v[0] = view.x, v[1] = view.y, v[2] = view.width, v[3] = view.height;
     }},
    {RC_COLOR_CLEAR_VALUE, Kind::Colour, 4,
     [](const Context &c, double *v) { writeColour(c.state.view.clearColor, v); }},
    {RC_DEPTH_BOUNCE, Kind::Number, 1, [](const Context &c, double *v) { v[0] = c.state.depthBounce; }},
    // matrices
    {RC_MATRIX_MODE, Kind::Token, 1, [](const Context &c, double *v) { v[0] = c.state.matrices.mode; }},
    {RC_MODELVIEW_MATRIX, Kind::Number, 16,
     [](const Context &c, double *v) { writeMatrix(c.state.matrices.modelview.current(), v); }},
    {RC_PROJECTION_MATRIX, Kind::Number, 16,
     [](const Context &c, double *v) { writeMatrix(c.state.matrices.projection.current(), v); }},
    {RC_TEXTURE_MATRIX, Kind::Number, 16,
     [](const Context &c, double *v) { writeMatrix(c.state.matrices.texture.current(), v); }},
    {RC_MODELVIEW_STACK_DEPTH, Kind::Number, 1,
     [](const Context &c, double *v) { v[0] = c.state.matrices.modelview.depth(); }},
    {RC_PROJECTION_STACK_DEPTH, Kind::Number, 1,
     [](const Context &c, double *v) { v[0] = c.state.matrices.projection.depth(); }},
    {RC_TEXTURE_STACK_DEPTH, Kind::Number, 1,
     [](const Context &c, double *v) { v[0] = c.state.matrices.texture.depth(); }},
    // materials and textures
    {RC_CURRENT_COLOR, Kind::Colour, 4, [](const Context &c, double *v) { writeColour(c.state.currentColor, v); }},
    {RC_CURRENT_AMBIENT, Kind::Colour, 4,
     [](const Context &c, double *v) { writeColour(c.objects().materials.bound().ambient, v); }},
    {RC_CURRENT_DIFFUSE, Kind::Colour, 4,
     [](const Context &c, double *v) { writeColour(c.objects().materials.bound().diffuse, v); }},
    {RC_CURRENT_SPECULAR, Kind::Colour, 4,
     [](const Context &c, double *v) { writeColour(c.objects().materials.bound().specular, v); }},
    {RC_MATERIAL_BINDING, Kind::Number, 1,
     [](const Context &c, double *v) { v[0] = c.objects().materials.boundName(); }},
    {RC_TEXTURE_BINDING_2D, Kind::Number, 1,
     [](const Context &c, double *v) { v[0] = c.state.texture.bound[ddk::kColourMap].name; }},
    // buffer objects: none is bound
    {RC_ARRAY_BUFFER_BINDING, Kind::Number, 1, constant<0>},
    {RC_ELEMENT_ARRAY_BUFFER_BINDING, Kind::Number, 1, constant<0>},
    // limits
    {RC_MAX_LIGHTS, Kind::Number, 1, [](const Context &c, double *v) { v[0] = c.profile().lights; }},
    {RC_MAX_MATERIALS, Kind::Number, 1, constant<int(hal::kNamedMaterials)>},
    {RC_MAX_TEXTURE_SIZE, Kind::Number, 1,
     [](const Context &c, double *v) { v[0] = c.state.texture.large ? 16384 : 1024; }},
    {RC_MAX_TEXTURE_UNITS, Kind::Number, 1, constant<1>},
    {RC_MAX_MODELVIEW_STACK_DEPTH, Kind::Number, 1, constant<MatrixStack::kDepth>},
    {RC_MAX_PROJECTION_STACK_DEPTH, Kind::Number, 1, constant<MatrixStack::kDepth>},
    {RC_MAX_TEXTURE_STACK_DEPTH, Kind::Number, 1, constant<MatrixStack::kDepth>},
    {RC_MAX_THRESHOLD_LEVELS, Kind::Number, 1, constant<10>},
    {RC_MAX_VIEWPORT_DIMS, Kind::Number, 2, [](const Context &, double *v) { v[0] = v[1] = 2048; }},
    // the last traced frame
    {RC_FRAME_TRIANGLES, Kind::Number, 1,
     [](const Context &c, double *v) {
       v[0] = double(c.lastFrame().staticTriangles + c.lastFrame().dynamicTriangles);
     }},
    {RC_FRAME_TRIANGLES_SKIPPED, Kind::Number, 1,
     [](const Context &c, double *v) { v[0] = double(c.lastFrame().skippedTriangles); }},
    {RC_FRAME_RAYS, Kind::Number, 1, [](const Context &c, double *v) { v[0] = double(c.lastFrame().rays.all()); }},
};

// What can be enabled can be asked for by the same name.
constexpr RCenum kSwitches[] = {RC_LIGHTING,          RC_TEXTURE_2D,
                                RC_TEXTURE_2D_NORMAL, RC_USE_SHADOW,
                                RC_USE_COLOR_SHADOW,  RC_USE_TRANSMITTANCE_SHADOW,
                                RC_USE_TEXTURE_ONLY,  RC_USE_TEXTURE_ALPHA_SHADOW,
                                RC_LARGE_TEXTURES,    RC_VERTEX_ARRAY,
                                RC_NORMAL_ARRAY,      RC_TEXTURE_COORD_ARRAY};

bool isSwitch(const Context &context, RCenum name) {
  if (name >= RC_LIGHT0 && name - RC_LIGHT0 < context.state.light.lights.size()) return true;
  return std::find(std::begin(kSwitches), std::end(kSwitches), name) != std::end(kSwitches);
}

QueryResult single(Kind kind, double value) { return {kind, 1, {value}}; }

QueryResult queryArray(const ArrayState &arrays, RCenum name) {
  for (const ArrayTokens &row : kArrays) {
    const ClientArray &array = arrays.*row.member;
    if (name == row.type) return single(Kind::Token, array.type);
    if (name == row.stride) return single(Kind::Number, effectiveStride(array));
    if (name == row.bufferBinding) return single(Kind::Number, 0);
    if (row.size != 0 && name == row.size) return single(Kind::Number, array.size);
  }
  return {};
}

}  // namespace

QueryResult query(Context &context, RCenum pname) {
  for (const QueryRow &row : kRows) {
    if (row.name != pname) continue;
    QueryResult result{row.kind, row.count, {}};
    row.read(context, result.values.data());
    return result;
  }
  if (isSwitch(context, pname)) return single(Kind::Switch, rcIsEnabled(pname));
  return queryArray(context.state.arrays, pname);
}

}  // namespace rc::api
