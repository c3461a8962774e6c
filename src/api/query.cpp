// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "api/query.h"

#include "RC/rc.h"
#include "api/arrays.h"
#include "api/caps.h"

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
    {RC_MAX_PALETTE_MATRICES_OES, Kind::Number, 1, constant<PaletteState::kMatrices>},
    {RC_MAX_VERTEX_UNITS_OES, Kind::Number, 1, constant<PaletteState::kMatrices>},
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

// State of rasterisation has no meaning for rays: it answers with fixed values. [reference 4.11]
struct FixedRow {
  RCenum name;
  Kind kind;
  int count;
  double value;  // of each
};

constexpr FixedRow kRasterState[] = {
    {RC_CULL_FACE_MODE, Kind::Token, 1, RC_BACK},
    {RC_ACTIVE_TEXTURE, Kind::Token, 1, RC_TEXTURE0},
    {RC_CLIENT_ACTIVE_TEXTURE, Kind::Token, 1, RC_TEXTURE0},
    {RC_MULTISAMPLE, Kind::Switch, 1, 1},
    {RC_FRONT_FACE, Kind::Token, 1, 0},
    {RC_MAX_CLIP_PLANES, Kind::Number, 1, 0},
    {RC_CURRENT_TEXTURE_COORDS, Kind::Number, 4, 0},
    {RC_ALPHA_TEST_FUNC, Kind::Token, 1, 0},
    {RC_ALPHA_TEST_REF, Kind::Number, 1, 0},
    {RC_SCISSOR_BOX, Kind::Number, 4, 0},
    {RC_COLOR_WRITEMASK, Kind::Switch, 4, 0},
    {RC_BLEND_DST, Kind::Token, 1, 0},
    {RC_BLEND_SRC, Kind::Token, 1, 0},
    {RC_LOGIC_OP_MODE, Kind::Token, 1, 0},
    {RC_FOG_DENSITY, Kind::Number, 1, 0},
    {RC_FOG_START, Kind::Number, 1, 0},
    {RC_FOG_END, Kind::Number, 1, 0},
    {RC_FOG_MODE, Kind::Token, 1, 0},
    {RC_FOG_COLOR, Kind::Colour, 4, 0},
    {RC_STENCIL_CLEAR_VALUE, Kind::Number, 1, 0},
    {RC_STENCIL_FUNC, Kind::Token, 1, 0},
    {RC_STENCIL_VALUE_MASK, Kind::Number, 1, 0},
    {RC_STENCIL_FAIL, Kind::Token, 1, 0},
    {RC_STENCIL_PASS_DEPTH_FAIL, Kind::Token, 1, 0},
    {RC_STENCIL_PASS_DEPTH_PASS, Kind::Token, 1, 0},
    {RC_STENCIL_REF, Kind::Number, 1, 0},
    {RC_STENCIL_WRITEMASK, Kind::Number, 1, 0},
    {RC_STENCIL_BITS, Kind::Number, 1, 0},
    {RC_DEPTH_RANGE, Kind::Number, 2, 0},
    {RC_DEPTH_WRITEMASK, Kind::Switch, 1, 0},
    {RC_DEPTH_CLEAR_VALUE, Kind::Number, 1, 0},
    {RC_DEPTH_FUNC, Kind::Token, 1, 0},
    {RC_DEPTH_BITS, Kind::Number, 1, 0},
    {RC_POINT_SIZE, Kind::Number, 1, 0},
    {RC_POINT_SIZE_MIN, Kind::Number, 1, 0},
    {RC_POINT_SIZE_MAX, Kind::Number, 1, 0},
    {RC_POINT_FADE_THRESHOLD_SIZE, Kind::Number, 1, 0},
    {RC_POINT_DISTANCE_ATTENUATION, Kind::Number, 3, 0},
    {RC_SMOOTH_POINT_SIZE_RANGE, Kind::Number, 2, 0},
    {RC_ALIASED_POINT_SIZE_RANGE, Kind::Number, 2, 0},
    {RC_LINE_WIDTH, Kind::Number, 1, 0},
    {RC_SMOOTH_LINE_WIDTH_RANGE, Kind::Number, 2, 0},
    {RC_ALIASED_LINE_WIDTH_RANGE, Kind::Number, 2, 0},
    {RC_POLYGON_OFFSET_UNITS, Kind::Number, 1, 0},
    {RC_POLYGON_OFFSET_FACTOR, Kind::Number, 1, 0},
    {RC_SAMPLE_BUFFERS, Kind::Number, 1, 0},
    {RC_SAMPLES, Kind::Number, 1, 0},
    {RC_SAMPLE_COVERAGE_VALUE, Kind::Number, 1, 0},
    {RC_SAMPLE_COVERAGE_INVERT, Kind::Switch, 1, 0},
    {RC_SHADE_MODEL, Kind::Token, 1, 0},
    {RC_LIGHT_MODEL_AMBIENT, Kind::Colour, 4, 0},
    {RC_LIGHT_MODEL_TWO_SIDE, Kind::Switch, 1, 0},
    {RC_SUBPIXEL_BITS, Kind::Number, 1, 0},
    {RC_RED_BITS, Kind::Number, 1, 0},
    {RC_GREEN_BITS, Kind::Number, 1, 0},
    {RC_BLUE_BITS, Kind::Number, 1, 0},
    {RC_ALPHA_BITS, Kind::Number, 1, 0},
    {RC_UNPACK_ALIGNMENT, Kind::Number, 1, 0},
    {RC_PACK_ALIGNMENT, Kind::Number, 1, 0},
    {RC_NUM_COMPRESSED_TEXTURE_FORMATS, Kind::Number, 1, 0},
    {RC_IMPLEMENTATION_COLOR_READ_TYPE_OES, Kind::Token, 1, 0},
    {RC_IMPLEMENTATION_COLOR_READ_FORMAT_OES, Kind::Token, 1, 0},
    {RC_POINT_SIZE_ARRAY_OES, Kind::Switch, 1, 0},
    {RC_POINT_SIZE_ARRAY_TYPE_OES, Kind::Token, 1, 0},
    {RC_POINT_SIZE_ARRAY_STRIDE_OES, Kind::Number, 1, 0},
    {RC_POINT_SIZE_ARRAY_BUFFER_BINDING_OES, Kind::Number, 1, 0},
};

// What can be enabled can be asked for by the same name.
constexpr RCenum kSwitches[] = {
    RC_LIGHTING,          RC_TEXTURE_2D,
    RC_TEXTURE_2D_NORMAL, RC_USE_SHADOW,
    RC_USE_COLOR_SHADOW,  RC_USE_TRANSMITTANCE_SHADOW,
    RC_USE_TEXTURE_ONLY,  RC_USE_TEXTURE_ALPHA_SHADOW,
    RC_LARGE_TEXTURES,    RC_MATRIX_PALETTE_OES,
};

bool isSwitch(const Context &context, RCenum name) {
  if (name >= RC_LIGHT0 && name - RC_LIGHT0 < context.state.light.lights.size()) return true;
  return findArrayTokens(name) || std::find(std::begin(kSwitches), std::end(kSwitches), name) != std::end(kSwitches);
}

QueryResult single(Kind kind, double value) { return {kind, 1, {value}}; }

QueryResult queryRasterState(RCenum name) {
  if (name == RC_CURRENT_NORMAL) return {Kind::Number, 3, {0, 0, 1}};
  for (const FixedRow &row : kRasterState) {
    if (row.name != name) continue;
    QueryResult result{row.kind, row.count, {}};
    std::fill_n(result.values.begin(), row.count, row.value);
    return result;
  }
  return isInertCap(name) ? single(Kind::Switch, 0) : QueryResult{};
}

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

}  // namespace

QueryResult query(Context &context, RCenum pname) {
  for (const QueryRow &row : kRows) {
    if (row.name != pname) continue;
    QueryResult result{row.kind, row.count, {}};
    row.read(context, result.values.data());
    return result;
  }
  if (isSwitch(context, pname)) return single(Kind::Switch, rcIsEnabled(pname));
  const QueryResult array = queryArray(context.state.arrays, pname);
  return array.count > 0 ? array : queryRasterState(pname);
}

}  // namespace rc::api
