// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "api/switches.h"

namespace rc::api {
namespace {

struct SwitchRow {
  RCenum cap;
  bool *(*find)(Context &context);
};

constexpr SwitchRow kSwitches[] = {
    // of the frame
    {RC_LIGHTING, [](Context &c) { return &c.state.light.lighting; }},
    {RC_USE_SHADOW, [](Context &c) { return &c.state.shadow.shadow; }},
    {RC_USE_COLOR_SHADOW, [](Context &c) { return &c.state.shadow.colour; }},
    {RC_FOG, [](Context &c) { return &c.state.fog.enabled; }},
    {RC_SCISSOR_TEST, [](Context &c) { return &c.state.picture.scissorTest; }},
    {RC_MULTISAMPLE, [](Context &c) { return &c.state.picture.multisample; }},
    // of the bound material
    {RC_TEXTURE_2D, [](Context &c) { return &c.boundMaterial().textures[ddk::kColourMap].enabled; }},
    {RC_TEXTURE_2D_NORMAL, [](Context &c) { return &c.boundMaterial().textures[ddk::kNormalMap].enabled; }},
    // captured by each draw
    {RC_USE_TRANSMITTANCE_SHADOW, [](Context &c) { return &c.state.shadow.transmittance; }},
    {RC_USE_TEXTURE_ALPHA_SHADOW, [](Context &c) { return &c.state.shadow.textureAlpha; }},
    {RC_USE_TEXTURE_ONLY, [](Context &c) { return &c.state.textureOnly; }},
    {RC_MATRIX_PALETTE_OES, [](Context &c) { return &c.state.palette.enabled; }},
    {RC_CULL_FACE, [](Context &c) { return &c.state.surface.cullFace; }},
    {RC_ALPHA_TEST, [](Context &c) { return &c.state.surface.alphaTest; }},
    {RC_CLIP_PLANE0, [](Context &c) { return &c.state.clip.enabled[0]; }},
    {RC_CLIP_PLANE1, [](Context &c) { return &c.state.clip.enabled[1]; }},
    {RC_CLIP_PLANE2, [](Context &c) { return &c.state.clip.enabled[2]; }},
    {RC_CLIP_PLANE3, [](Context &c) { return &c.state.clip.enabled[3]; }},
    {RC_CLIP_PLANE4, [](Context &c) { return &c.state.clip.enabled[4]; }},
    {RC_CLIP_PLANE5, [](Context &c) { return &c.state.clip.enabled[5]; }},
    // of the context
    {RC_LARGE_TEXTURES, [](Context &c) { return &c.state.texture.large; }},
    // kept without effect
    {RC_BLEND, [](Context &c) { return &c.state.raster.blend; }},
    {RC_COLOR_LOGIC_OP, [](Context &c) { return &c.state.raster.colorLogicOp; }},
    {RC_COLOR_MATERIAL, [](Context &c) { return &c.state.raster.colorMaterial; }},
    {RC_DEPTH_TEST, [](Context &c) { return &c.state.raster.depthTest; }},
    {RC_DITHER, [](Context &c) { return &c.state.raster.dither; }},
    {RC_LINE_SMOOTH, [](Context &c) { return &c.state.raster.lineSmooth; }},
    {RC_NORMALIZE, [](Context &c) { return &c.state.raster.normalize; }},
    {RC_POINT_SMOOTH, [](Context &c) { return &c.state.raster.pointSmooth; }},
    {RC_POINT_SPRITE_OES, [](Context &c) { return &c.state.raster.pointSprite; }},
    {RC_POLYGON_OFFSET_FILL, [](Context &c) { return &c.state.raster.polygonOffsetFill; }},
    {RC_RESCALE_NORMAL, [](Context &c) { return &c.state.raster.rescaleNormal; }},
    {RC_SAMPLE_ALPHA_TO_COVERAGE, [](Context &c) { return &c.state.raster.sampleAlphaToCoverage; }},
    {RC_SAMPLE_ALPHA_TO_ONE, [](Context &c) { return &c.state.raster.sampleAlphaToOne; }},
    {RC_SAMPLE_COVERAGE, [](Context &c) { return &c.state.raster.sampleCoverage; }},
    {RC_STENCIL_TEST, [](Context &c) { return &c.state.raster.stencilTest; }},
};

}  // namespace

bool *findSwitch(Context &context, RCenum cap) {
  std::vector<ddk::Light> &lights = context.state.light.lights;
  if (cap >= RC_LIGHT0 && cap - RC_LIGHT0 < lights.size()) return &lights[cap - RC_LIGHT0].enabled;
  for (const SwitchRow &row : kSwitches) {
    if (row.cap == cap) return row.find(context);
  }
  return nullptr;
}

}  // namespace rc::api
