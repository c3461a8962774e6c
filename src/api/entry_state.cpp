// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: enables, hints, errors, strings. [spec 3.8; reference 4.3, 4.6]
#include "RC/rc.h"
#include "api/arrays.h"
#include "api/guard.h"
#include "api/switches.h"

using namespace rc;
using namespace rc::api;

namespace {

void setSwitch(Context &context, RCenum cap, bool on) {
  bool *found = findSwitch(context, cap);
  if (!found) return context.fail(RC_INVALID_ENUM, "cap 0x%04X is nothing that is switched", cap);
  if (cap == RC_MATRIX_PALETTE_OES) context.state.palette.current = 0;  // either way [reference 4.3]
  if (*found == on) return;
  *found = on;
  context.touch();
}

struct HintRow {
  RCenum target;
  RCenum HintState::*member;
  bool (*valid)(RCenum mode);
};

bool any(RCenum) { return true; }
bool isQuality(RCenum mode) { return mode >= RC_DONT_CARE && mode <= RC_NICEST; }
bool isRendering(RCenum mode) { return mode >= RC_DONT_CARE && mode <= RC_FASTEST_AND_NICEST; }
bool isThreshold(RCenum mode) {
  return mode == RC_DONT_CARE || (mode >= RC_THRESHOLD_LEVEL0 && mode <= RC_THRESHOLD_LEVEL9);
}

bool isStructure(RCenum mode) {
  return mode == RC_DONT_CARE || (mode >= RC_STRUCTURE_KD_TREE && mode <= RC_STRUCTURE_NONE);
}

constexpr HintRow kHints[] = {
    {RC_MIPMAP_HINT, &HintState::mipmap, isQuality},
    {RC_RENDERING_HINT, &HintState::rendering, isRendering},
    {RC_RAYBOUNCE_THRESHOLD_HINT, &HintState::rayBounceThreshold, isThreshold},
    {RC_FOG_HINT, &HintState::fog, any},
    {RC_GENERATE_MIPMAP_HINT, &HintState::generateMipmap, any},
    {RC_LINE_SMOOTH_HINT, &HintState::lineSmooth, any},
    {RC_PERSPECTIVE_CORRECTION_HINT, &HintState::perspective, any},
    {RC_POINT_SMOOTH_HINT, &HintState::pointSmooth, any},
    {RC_STRUCTURE_HINT, &HintState::structure, isStructure},
};

void setHint(Context &context, RCenum target, RCenum mode) {
  for (const HintRow &row : kHints) {
    if (row.target != target) continue;
    if (!row.valid(mode))
      return context.fail(RC_INVALID_ENUM,
                          "mode 0x%04X is none of target 0x%04X (RC_DONT_CARE, RC_FASTEST, RC_NICEST ...)", mode,
                          target);
    context.state.hints.*row.member = mode;
    return context.touch();
  }
  context.fail(RC_INVALID_ENUM, "target 0x%04X is no hint", target);
}

// What goes beyond the vendor's API, by name; docs/extensions/ has a document for each.
constexpr const char *kExtensions =
    "RC_RCX_anisotropy RC_RCX_debug_messages RC_RCX_es11_functions RC_RCX_frame_queries RC_RCX_frame_statistics "
    "RC_RCX_large_textures RC_RCX_material_emission RC_RCX_opaque_alpha RC_RCX_packed_textures RC_RCX_ray_queries "
    "RC_RCX_structure_hint RC_RCX_trilinear RC_RCX_vertex_colors";

struct StringRow {
  RCenum name;
  const char *text;
};
constexpr StringRow kStrings[] = {{RC_VENDOR, "Siliconarts Inc."},
                                  {RC_RENDERER, "RayCore"},
                                  {RC_VERSION, "RayCore API 1.0"},
                                  {RC_EXTENSIONS, kExtensions}};

}  // namespace

extern "C" {

RCenum rcGetError(void) {
  if (!currentContext()) return takeMissingContext();
  return enter(Call("rcGetError"), [](Context &context) { return context.takeError(); });
}

void rcEnable(RCenum cap) {
  enter(Call("rcEnable", cap), [&](Context &context) { setSwitch(context, cap, true); });
}

void rcDisable(RCenum cap) {
  enter(Call("rcDisable", cap), [&](Context &context) { setSwitch(context, cap, false); });
}

RCboolean rcIsEnabled(RCenum cap) {
  return enter(Call("rcIsEnabled", cap), [&](Context &context) -> RCboolean {
    if (const ClientArray *array = findArray(context.state.arrays, cap)) return array->enabled;
    if (const bool *found = findSwitch(context, cap)) return *found;
    context.fail(RC_INVALID_ENUM, "cap 0x%04X is nothing that is switched", cap);
    return RC_FALSE;
  });
}

void rcDebugMessageCallbackRCX(RCDEBUGPROCRCX callback, const RCvoid *userParam) {
  enter(Call("rcDebugMessageCallbackRCX", reinterpret_cast<const void *>(callback), userParam), [&](Context &context) {
    context.setDebugCallback({callback, userParam});
  });
}

void rcHint(RCenum target, RCenum mode) {
  enter(Call("rcHint", target, mode), [&](Context &context) { setHint(context, target, mode); });
}

const RCubyte *rcGetString(RCenum name) {
  return enter(Call("rcGetString", name), [&](Context &context) -> const RCubyte * {
    for (const StringRow &row : kStrings) {
      if (row.name == name) return reinterpret_cast<const RCubyte *>(row.text);
    }
    context.fail(RC_INVALID_ENUM, "name 0x%04X is not RC_VENDOR, RC_RENDERER, RC_VERSION or RC_EXTENSIONS", name);
    return nullptr;
  });
}

}  // extern "C"
