// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Calls that take and return plain numbers: a row each. Of the twins of a call (f, x, d) there is the one of floats.
#include "core.h"

namespace raycore {
namespace {

using namespace py::literals;

void addCamera(py::module_ &m) {
  define(m, "viewport", rcViewport, "x"_a, "y"_a, "width"_a, "height"_a);
  define(m, "frustum", rcFrustum, "left"_a, "right"_a, "bottom"_a, "top"_a, "z_near"_a, "z_far"_a);
  define(m, "ortho", rcOrtho, "left"_a, "right"_a, "bottom"_a, "top"_a, "z_near"_a, "z_far"_a);
  define(m, "perspective", rcuPerspective, "fovy"_a, "aspect"_a, "z_near"_a = 0.1f, "z_far"_a = 100.0f);
  define(m, "clear_color", rcClearColor, "red"_a, "green"_a, "blue"_a, "alpha"_a = 1.0f);
  define(m, "clear", rcClear, "mask"_a);
}

void addMatrices(py::module_ &m) {
  define(m, "matrix_mode", rcMatrixMode, "mode"_a);
  define(m, "load_identity", rcLoadIdentity);
  define(m, "translate", rcTranslatef, "x"_a, "y"_a, "z"_a);
  define(m, "rotate", rcRotatef, "angle"_a, "x"_a, "y"_a, "z"_a);
  define(m, "scale", rcScalef, "x"_a, "y"_a, "z"_a);
  define(m, "push_matrix", rcPushMatrix);
  define(m, "pop_matrix", rcPopMatrix);
  define(m, "current_palette_matrix", rcCurrentPaletteMatrixOES, "index"_a);
  define(m, "load_palette_from_model_view_matrix", rcLoadPaletteFromModelViewMatrixOES);
}

void addFrames(py::module_ &m) {
  const auto trace = [] {
    {
      const py::gil_scoped_release released;  // other threads of Python go on
      rcFinish();
    }
    throwIfFailed();
  };
  m.def("finish", trace, "Traces the frame into the context's picture.");
  m.def("flush", trace, "The same as finish.");
  define(m, "scene_all_init", rcSceneAllInit);
  define(m, "static_scene_begin", rcStaticSceneBegin);
  define(m, "static_scene_end", rcStaticSceneEnd);
  define(m, "depth_bounce", rcDepthBounce, "value"_a);
  define(m, "set_light_radius", rcSetLightRadius, "radius"_a);
  define(m, "set_diffuse_rate", rcSetDiffuseRate, "rate"_a);
  define(m, "set_spp_count", rcSetSPPCount, "count"_a);
}

void addState(py::module_ &m) {
  define(m, "enable", rcEnable, "cap"_a);
  define(m, "disable", rcDisable, "cap"_a);
  m.def(
      "is_enabled",
      [](RCenum cap) {
        const bool enabled = rcIsEnabled(cap);
        throwIfFailed();
        return enabled;
      },
      "cap"_a);
  define(m, "enable_client_state", rcEnableClientState, "array"_a);
  define(m, "disable_client_state", rcDisableClientState, "array"_a);
  define(m, "hint", rcHint, "target"_a, "mode"_a);
  m.def("get_error", rcGetError, "What a call raised that did not go through this module.");
}

void addSurfaces(py::module_ &m) {
  define(m, "color", rcColor4f, "red"_a, "green"_a, "blue"_a, "alpha"_a = 1.0f);
  define(m, "bind_material", rcBindMaterial, "material"_a);
  define(m, "bind_texture", rcBindTexture, "target"_a, "texture"_a);
  define(m, "bind_buffer", rcBindBuffer, "target"_a, "buffer"_a);
  define(m, "texture_alpha", rcTextureAlpha, "value"_a);
  define(m, "active_texture", rcActiveTexture, "texture"_a);
  define(m, "client_active_texture", rcClientActiveTexture, "texture"_a);
  define(m, "multi_tex_coord", rcMultiTexCoord4f, "target"_a, "s"_a, "t"_a, "r"_a = 0.0f, "q"_a = 1.0f);
  define(m, "normal", rcNormal3f, "nx"_a, "ny"_a, "nz"_a);
  define(m, "cull_face", rcCullFace, "mode"_a);
  define(m, "front_face", rcFrontFace, "mode"_a);
  define(m, "alpha_func", rcAlphaFunc, "func"_a, "ref"_a);
  define(m, "shade_model", rcShadeModel, "mode"_a);
}

void addRasterState(py::module_ &m) {
  define(m, "scissor", rcScissor, "x"_a, "y"_a, "width"_a, "height"_a);
  define(m, "color_mask", rcColorMask, "red"_a, "green"_a, "blue"_a, "alpha"_a);
  define(m, "pixel_store", rcPixelStorei, "pname"_a, "param"_a);
  define(m, "blend_func", rcBlendFunc, "sfactor"_a, "dfactor"_a);
  define(m, "clear_depth", rcClearDepthf, "depth"_a);
  define(m, "clear_stencil", rcClearStencil, "s"_a);
  define(m, "depth_func", rcDepthFunc, "func"_a);
  define(m, "depth_mask", rcDepthMask, "flag"_a);
  define(m, "depth_range", rcDepthRangef, "z_near"_a, "z_far"_a);
  define(m, "line_width", rcLineWidth, "width"_a);
  define(m, "logic_op", rcLogicOp, "opcode"_a);
  define(m, "point_size", rcPointSize, "size"_a);
  define(m, "polygon_offset", rcPolygonOffset, "factor"_a, "units"_a);
  define(m, "sample_coverage", rcSampleCoverage, "value"_a, "invert"_a);
  define(m, "stencil_func", rcStencilFunc, "func"_a, "ref"_a, "mask"_a);
  define(m, "stencil_mask", rcStencilMask, "mask"_a);
  define(m, "stencil_op", rcStencilOp, "fail"_a, "zfail"_a, "zpass"_a);
}

}  // namespace

void addCalls(py::module_ &module) {
  addCamera(module);
  addMatrices(module);
  addFrames(module);
  addState(module);
  addSurfaces(module);
  addRasterState(module);
}

}  // namespace raycore
