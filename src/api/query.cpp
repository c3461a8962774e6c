// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "api/query.h"

#include <algorithm>

#include "api/arrays.h"
#include "api/switches.h"

namespace rc::api {
namespace {

using Kind = QueryResult::Kind;

void writeMatrix(const Mat4 &matrix, double *values) {
  for (int i = 0; i < 16; ++i) values[i] = matrix[i / 4][i % 4];
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
     [](const Context &c, double *v) { writeColour(c.boundMaterial().ambient, v); }},
    {RC_CURRENT_DIFFUSE, Kind::Colour, 4,
     [](const Context &c, double *v) { writeColour(c.boundMaterial().diffuse, v); }},
    {RC_CURRENT_SPECULAR, Kind::Colour, 4,
     [](const Context &c, double *v) { writeColour(c.boundMaterial().specular, v); }},
    {RC_MATERIAL_BINDING, Kind::Number, 1, [](const Context &c, double *v) { v[0] = c.state.boundMaterial; }},
    {RC_TEXTURE_BINDING_2D, Kind::Number, 1,
     [](const Context &c, double *v) { v[0] = c.state.texture.bound[ddk::kColourMap].name; }},
    // buffer objects
    {RC_ARRAY_BUFFER_BINDING, Kind::Number, 1,
     [](const Context &c, double *v) { v[0] = c.state.arrays.arrayBuffer.name; }},
    {RC_ELEMENT_ARRAY_BUFFER_BINDING, Kind::Number, 1,
     [](const Context &c, double *v) { v[0] = c.state.arrays.elementBuffer.name; }},
    // hints
    {RC_MIPMAP_HINT, Kind::Token, 1, [](const Context &c, double *v) { v[0] = c.state.hints.mipmap; }},
    {RC_RENDERING_HINT, Kind::Token, 1, [](const Context &c, double *v) { v[0] = c.state.hints.rendering; }},
    {RC_RAYBOUNCE_THRESHOLD_HINT, Kind::Token, 1,
     [](const Context &c, double *v) { v[0] = c.state.hints.rayBounceThreshold; }},
    {RC_FOG_HINT, Kind::Token, 1, [](const Context &c, double *v) { v[0] = c.state.hints.fog; }},
    {RC_GENERATE_MIPMAP_HINT, Kind::Token, 1, [](const Context &c, double *v) { v[0] = c.state.hints.generateMipmap; }},
    {RC_LINE_SMOOTH_HINT, Kind::Token, 1, [](const Context &c, double *v) { v[0] = c.state.hints.lineSmooth; }},
    {RC_PERSPECTIVE_CORRECTION_HINT, Kind::Token, 1,
     [](const Context &c, double *v) { v[0] = c.state.hints.perspective; }},
    {RC_POINT_SMOOTH_HINT, Kind::Token, 1, [](const Context &c, double *v) { v[0] = c.state.hints.pointSmooth; }},
    {RC_STRUCTURE_HINT, Kind::Token, 1, [](const Context &c, double *v) { v[0] = c.state.hints.structure; }},
    // limits
    {RC_MAX_LIGHTS, Kind::Number, 1, [](const Context &c, double *v) { v[0] = c.profile().lights; }},
    {RC_MAX_MATERIALS, Kind::Number, 1, constant<int(hal::kNamedMaterials)>},
    {RC_MAX_TEXTURE_SIZE, Kind::Number, 1,
     [](const Context &c, double *v) { v[0] = c.state.texture.large ? 16384 : 1024; }},
    {RC_MAX_TEXTURE_UNITS, Kind::Number, 1, constant<1>},
    {RC_MAX_TEXTURE_MAX_ANISOTROPY_EXT, Kind::Number, 1, constant<ddk::kMostAnisotropy>},
    {RC_MAX_MODELVIEW_STACK_DEPTH, Kind::Number, 1, constant<MatrixStack::kDepth>},
    {RC_MAX_PROJECTION_STACK_DEPTH, Kind::Number, 1, constant<MatrixStack::kDepth>},
    {RC_MAX_TEXTURE_STACK_DEPTH, Kind::Number, 1, constant<MatrixStack::kDepth>},
    {RC_MAX_THRESHOLD_LEVELS, Kind::Number, 1, constant<10>},
    {RC_MAX_PALETTE_MATRICES_OES, Kind::Number, 1, constant<PaletteState::kMatrices>},
    {RC_MAX_VERTEX_UNITS_OES, Kind::Number, 1, constant<PaletteState::kMatrices>},
    {RC_MAX_VIEWPORT_DIMS, Kind::Number, 2, [](const Context &, double *v) { v[0] = v[1] = 2048; }},
};

QueryResult single(Kind kind, double value) { return {kind, 1, {value}}; }

QueryResult queryArray(const ArrayState &arrays, RCenum name) {
  for (const ArrayTokens &row : kArrays) {
    const ClientArray &array = arrays.*row.member;
    if (name == row.type) return single(Kind::Token, array.type);
    if (name == row.stride) return single(Kind::Number, effectiveStride(array));
    if (name == row.bufferBinding) return single(Kind::Number, array.bufferName);
    if (row.size != 0 && name == row.size) return single(Kind::Number, array.size);
  }
  return {};
}

const QueryRow *findRow(std::span<const QueryRow> table, RCenum name) {
  const auto row = std::find_if(table.begin(), table.end(), [&](const QueryRow &r) { return r.name == name; });
  return row == table.end() ? nullptr : &*row;
}

QueryResult answer(const QueryRow &row, const Context &context) {
  QueryResult result{row.kind, row.count, {}};
  row.read(context, result.values.data());
  return result;
}

}  // namespace

QueryResult query(Context &context, RCenum pname) {
  if (const QueryRow *row = findRow(kRows, pname)) return answer(*row, context);
  if (const QueryRow *row = findRow(rasterQueries(), pname)) return answer(*row, context);
  if (const QueryRow *row = findRow(statisticsQueries(), pname)) {
    context.await();  // they are about the last picture
    return answer(*row, context);
  }
  // What can be enabled can be asked for by the same name.
  if (const ClientArray *array = findArray(context.state.arrays, pname)) return single(Kind::Switch, array->enabled);
  if (const bool *found = findSwitch(context, pname)) return single(Kind::Switch, *found);
  return queryArray(context.state.arrays, pname);
}

}  // namespace rc::api
