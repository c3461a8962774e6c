// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Answers for the state of OpenGL ES 1.1 beyond RayCore's own. [reference 4.11; OpenGL ES 1.1, 6.2]
#include "api/query.h"
#include "rcddk/paletted.h"

namespace rc::api {
namespace {

using Kind = QueryResult::Kind;

// A row for one number, switch or token of a struct of the state.
template <auto Group, auto Member>
constexpr QueryRow row(RCenum name, Kind kind) {
  return {name, kind, 1, [](const Context &c, double *v) { v[0] = double((c.state.*Group).*Member); }};
}
template <auto Member>
constexpr QueryRow raster(RCenum name, Kind kind) {
  return row<&State::raster, Member>(name, kind);
}

using Raster = RasterState;
constexpr QueryRow kRows[] = {
    // what acts
    row<&State::surface, &SurfaceState::cullMode>(RC_CULL_FACE_MODE, Kind::Token),
    row<&State::surface, &SurfaceState::frontFace>(RC_FRONT_FACE, Kind::Token),
    row<&State::surface, &SurfaceState::shadeModel>(RC_SHADE_MODEL, Kind::Token),
    row<&State::surface, &SurfaceState::alphaFunc>(RC_ALPHA_TEST_FUNC, Kind::Token),
    row<&State::surface, &SurfaceState::alphaRef>(RC_ALPHA_TEST_REF, Kind::Clamped),
    row<&State::fog, &FogState::mode>(RC_FOG_MODE, Kind::Token),
    row<&State::fog, &FogState::density>(RC_FOG_DENSITY, Kind::Number),
    row<&State::fog, &FogState::start>(RC_FOG_START, Kind::Number),
    row<&State::fog, &FogState::end>(RC_FOG_END, Kind::Number),
    {RC_FOG_COLOR, Kind::Colour, 4, [](const Context &c, double *v) { writeColour(c.state.fog.color, v); }},
    {RC_LIGHT_MODEL_AMBIENT, Kind::Colour, 4,
     [](const Context &c, double *v) { writeColour(c.state.light.modelAmbient, v); }},
    row<&State::light, &LightState::twoSide>(RC_LIGHT_MODEL_TWO_SIDE, Kind::Switch),
    {RC_SCISSOR_BOX, Kind::Number, 4,
     [](const Context &c, double *v) {
       const PictureState &p = c.state.picture;
       v[0] = p.scissorX, v[1] = p.scissorY, v[2] = p.scissorWidth, v[3] = p.scissorHeight;
     }},
    {RC_COLOR_WRITEMASK, Kind::Switch, 4,
     [](const Context &c, double *v) {
       for (size_t i = 0; i < 4; ++i) v[i] = c.state.picture.colorMask[i];
     }},
    {RC_MAX_CLIP_PLANES, Kind::Number, 1, constant<int(ClipState::kPlanes)>},
    row<&State::pixelStore, &PixelStoreState::packAlignment>(RC_PACK_ALIGNMENT, Kind::Number),
    row<&State::pixelStore, &PixelStoreState::unpackAlignment>(RC_UNPACK_ALIGNMENT, Kind::Number),
    row<&State::texture, &TextureState::activeUnit>(RC_ACTIVE_TEXTURE, Kind::Token),
    row<&State::texture, &TextureState::clientActiveUnit>(RC_CLIENT_ACTIVE_TEXTURE, Kind::Token),
    {RC_CURRENT_TEXTURE_COORDS, Kind::Number, 4,
     [](const Context &c, double *v) { writeColour(c.state.arrays.currentTexCoord, v); }},
    {RC_CURRENT_NORMAL, Kind::Number, 3,
     [](const Context &c, double *v) {
       for (int i = 0; i < 3; ++i) v[i] = double(c.state.arrays.currentNormal[i]);
     }},
    {RC_NUM_COMPRESSED_TEXTURE_FORMATS, Kind::Number, 1,
     [](const Context &, double *v) { v[0] = double(ddk::palettedFormats().size()); }},
    {RC_COMPRESSED_TEXTURE_FORMATS, Kind::Token, 10,
     [](const Context &, double *v) {
       for (const ddk::PalettedFormat &format : ddk::palettedFormats()) *v++ = format.format;
     }},
    {RC_IMPLEMENTATION_COLOR_READ_FORMAT_OES, Kind::Token, 1, constant<RC_RGB>},
    {RC_IMPLEMENTATION_COLOR_READ_TYPE_OES, Kind::Token, 1, constant<RC_UNSIGNED_BYTE>},
    // what is kept
    raster<&Raster::blendSource>(RC_BLEND_SRC, Kind::Token),
    raster<&Raster::blendDestination>(RC_BLEND_DST, Kind::Token),
    raster<&Raster::logicOp>(RC_LOGIC_OP_MODE, Kind::Token),
    raster<&Raster::depthFunc>(RC_DEPTH_FUNC, Kind::Token),
    raster<&Raster::depthMask>(RC_DEPTH_WRITEMASK, Kind::Switch),
    raster<&Raster::clearDepth>(RC_DEPTH_CLEAR_VALUE, Kind::Clamped),
    {RC_DEPTH_RANGE, Kind::Clamped, 2,
     [](const Context &c, double *v) {
       v[0] = double(c.state.raster.depthNear);
       v[1] = double(c.state.raster.depthFar);
     }},
    raster<&Raster::stencilFunc>(RC_STENCIL_FUNC, Kind::Token),
    raster<&Raster::stencilRef>(RC_STENCIL_REF, Kind::Number),
    // all bits are -1 as an integer
    {RC_STENCIL_VALUE_MASK, Kind::Number, 1,
     [](const Context &c, double *v) { v[0] = static_cast<RCint>(c.state.raster.stencilValueMask); }},
    {RC_STENCIL_WRITEMASK, Kind::Number, 1,
     [](const Context &c, double *v) { v[0] = static_cast<RCint>(c.state.raster.stencilWriteMask); }},
    raster<&Raster::stencilFail>(RC_STENCIL_FAIL, Kind::Token),
    raster<&Raster::stencilDepthFail>(RC_STENCIL_PASS_DEPTH_FAIL, Kind::Token),
    raster<&Raster::stencilDepthPass>(RC_STENCIL_PASS_DEPTH_PASS, Kind::Token),
    raster<&Raster::clearStencil>(RC_STENCIL_CLEAR_VALUE, Kind::Number),
    raster<&Raster::pointSize>(RC_POINT_SIZE, Kind::Number),
    raster<&Raster::pointSizeMin>(RC_POINT_SIZE_MIN, Kind::Number),
    raster<&Raster::pointSizeMax>(RC_POINT_SIZE_MAX, Kind::Number),
    raster<&Raster::pointFadeThreshold>(RC_POINT_FADE_THRESHOLD_SIZE, Kind::Number),
    {RC_POINT_DISTANCE_ATTENUATION, Kind::Number, 3,
     [](const Context &c, double *v) {
       for (int i = 0; i < 3; ++i) v[i] = double(c.state.raster.pointAttenuation[i]);
     }},
    raster<&Raster::lineWidth>(RC_LINE_WIDTH, Kind::Number),
    raster<&Raster::polygonOffsetFactor>(RC_POLYGON_OFFSET_FACTOR, Kind::Number),
    raster<&Raster::polygonOffsetUnits>(RC_POLYGON_OFFSET_UNITS, Kind::Number),
    raster<&Raster::coverageValue>(RC_SAMPLE_COVERAGE_VALUE, Kind::Clamped),
    raster<&Raster::coverageInvert>(RC_SAMPLE_COVERAGE_INVERT, Kind::Switch),
    // what pictures are made of
    {RC_RED_BITS, Kind::Number, 1, constant<8>},
    {RC_GREEN_BITS, Kind::Number, 1, constant<8>},
    {RC_BLUE_BITS, Kind::Number, 1, constant<8>},
    {RC_ALPHA_BITS, Kind::Number, 1, constant<8>},
    {RC_DEPTH_BITS, Kind::Number, 1, constant<0>},
    {RC_STENCIL_BITS, Kind::Number, 1, constant<0>},
    {RC_SUBPIXEL_BITS, Kind::Number, 1, constant<8>},
    {RC_SAMPLE_BUFFERS, Kind::Number, 1, [](const Context &c, double *v) { v[0] = c.samples() > 1; }},
    {RC_SAMPLES, Kind::Number, 1, [](const Context &c, double *v) { v[0] = c.samples() > 1 ? c.samples() : 0; }},
    {RC_SMOOTH_POINT_SIZE_RANGE, Kind::Number, 2, [](const Context &, double *v) { v[0] = v[1] = 1; }},
    {RC_ALIASED_POINT_SIZE_RANGE, Kind::Number, 2, [](const Context &, double *v) { v[0] = v[1] = 1; }},
    {RC_SMOOTH_LINE_WIDTH_RANGE, Kind::Number, 2, [](const Context &, double *v) { v[0] = v[1] = 1; }},
    {RC_ALIASED_LINE_WIDTH_RANGE, Kind::Number, 2, [](const Context &, double *v) { v[0] = v[1] = 1; }},
};

}  // namespace

std::span<const QueryRow> rasterQueries() { return kRows; }

}  // namespace rc::api
