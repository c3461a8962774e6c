// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// state.h: the state of a context, a struct for each family, with its initial values. [reference 3.2]
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "RC/rctokens.h"
#include "RC/rctypes.h"
#include "api/matrix_stack.h"
#include "base/memory.h"
#include "rcddk/camera.h"
#include "rcddk/light.h"
#include "rcddk/material.h"

namespace rc::api {

struct ViewState {
  RCint x = 0, y = 0;
  RCsizei width = 800, height = 480;
  Vec4 clearColor{0};
  ddk::Camera camera;
};

struct MatrixState {
  RCenum mode = RC_MODELVIEW;
  MatrixStack modelview, projection, texture;

  MatrixStack &current() { return mode == RC_PROJECTION ? projection : mode == RC_TEXTURE ? texture : modelview; }
};

struct LightState {
  bool lighting = false;
  std::vector<ddk::Light> lights;  // as many as the profile has
  Vec4 modelAmbient{0, 0, 0, 1};   // unlike GL's 0.2: there is no ambient light unless it is asked for [spec 3.3]
  bool twoSide = false;            // kept; surfaces are always two-sided
};

// The current texture of a target. A material may hold another one.
struct TextureBinding {
  RCuint name = 0;
  std::shared_ptr<ddk::Texture> texture;
};

struct TextureState {
  std::array<TextureBinding, ddk::kTextureSlots> bound;
  ddk::TextureSlot last = ddk::kColourMap;  // what rcTexImage2D loads: the slot bound last
  RCubyte alpha = 16;
  bool generateMipmap = true;
  bool large = false;
  RCenum activeUnit = RC_TEXTURE0, clientActiveUnit = RC_TEXTURE0;  // the only one there is
};

// A buffer object: client arrays and indices in memory of ours. [reference 4.7]
struct Buffer {
  Array<std::byte> bytes;
  RCenum usage = RC_STATIC_DRAW;
};

struct BufferBinding {
  RCuint name = 0;
  std::shared_ptr<Buffer> buffer;  // null for name 0
};

struct ClientArray {
  bool enabled = false;
  RCint size;
  RCenum type = RC_FLOAT;
  RCsizei stride = 0;               // as given; 0 = packed
  const RCvoid *pointer = nullptr;  // an offset in bytes where there is a buffer
  RCuint bufferName = 0;
  std::shared_ptr<Buffer> buffer;  // what was bound when the pointer was set
};

struct ArrayState {
  ClientArray vertex{.size = 3}, normal{.size = 3}, texCoord{.size = 2}, color{.size = 4};
  ClientArray matrixIndex{.size = 1, .type = RC_UNSIGNED_BYTE}, weight{.size = 1};
  ClientArray pointSize{.size = 1};  // kept: there are no points
  BufferBinding arrayBuffer, elementBuffer;
  Vec4 currentTexCoord{0, 0, 0, 1};  // of vertices without an array
  Vec3 currentNormal{0, 0, 1};       // kept; vertices without an array have the flat normal
};

// Rows of images in client memory begin at multiples of these. [spec 3.4]
struct PixelStoreState {
  RCint packAlignment = 4, unpackAlignment = 1;
};

// What a draw call fixes for its triangles: which sides, and which texels, are there.
struct SurfaceState {
  bool cullFace = false, alphaTest = false;
  RCenum cullMode = RC_BACK, frontFace = RC_CCW, shadeModel = RC_SMOOTH;
  RCenum alphaFunc = RC_ALWAYS;
  float alphaRef = 0;
};

// Planes through the world: what lies on their negative side is cut off when it is drawn.
struct ClipState {
  static constexpr size_t kPlanes = 6;

  std::array<bool, kPlanes> enabled{};
  std::array<Vec4, kPlanes> planes{};  // a x + b y + c z + d in world space
};

struct FogState {
  bool enabled = false;
  RCenum mode = RC_EXP;
  float density = 1, start = 0, end = 1;
  Vec4 color{0};
};

// Which pixels and channels of the picture are written, and how many rays make one.
struct PictureState {
  bool scissorTest = false, multisample = true;
  RCint scissorX = 0, scissorY = 0;
  RCsizei scissorWidth = 0, scissorHeight = 0;  // of the first surface
  std::array<bool, 4> colorMask{true, true, true, true};
};

// The matrix palette, by which vertices follow several bones. [spec 3.6; reference 4.7]
struct PaletteState {
  static constexpr RCuint kMatrices = 128;

  bool enabled = false;
  RCuint current = 0;
  std::vector<Mat4> matrices = std::vector<Mat4>(kMatrices, Mat4(0));
};

struct ShadowState {
  bool shadow = true, colour = true;                 // of the frame
  bool transmittance = false, textureAlpha = false;  // captured by a draw
};

struct HintState {
  RCenum mipmap = RC_DONT_CARE, rendering = RC_DONT_CARE, rayBounceThreshold = RC_DONT_CARE;
  RCenum fog = RC_DONT_CARE, generateMipmap = RC_DONT_CARE, lineSmooth = RC_DONT_CARE;
  RCenum perspective = RC_DONT_CARE, pointSmooth = RC_DONT_CARE, structure = RC_DONT_CARE;
};

// Of the second generation: stored, without effect on the picture. [spec 7; reference 4.12]
struct PathTracingState {
  RCfloat lightRadius = 100;
  RCuint diffuseRate = 10;  // tenths of the probability of a diffuse ray
  RCuint sampleCount = 8;   // a pixel
};

// State of rasterisation: checked, kept, returned, and without effect on rays. Initial values are GL's.
struct RasterState {
  bool blend = false, colorLogicOp = false, colorMaterial = false, depthTest = false, dither = false;
  bool lineSmooth = false, normalize = false, pointSmooth = false, pointSprite = false, polygonOffsetFill = false;
  bool rescaleNormal = false, sampleAlphaToCoverage = false, sampleAlphaToOne = false, sampleCoverage = false;
  bool stencilTest = false;

  RCenum blendSource = RC_ONE, blendDestination = RC_ZERO, logicOp = RC_COPY;
  RCenum depthFunc = RC_LESS;
  bool depthMask = true;
  float depthNear = 0, depthFar = 1, clearDepth = 1;
  RCenum stencilFunc = RC_ALWAYS, stencilFail = RC_KEEP, stencilDepthFail = RC_KEEP, stencilDepthPass = RC_KEEP;
  RCint stencilRef = 0, clearStencil = 0;
  RCuint stencilValueMask = ~0u, stencilWriteMask = ~0u;
  float pointSize = 1, pointSizeMin = 0, pointSizeMax = 1, pointFadeThreshold = 1;
  Vec3 pointAttenuation{1, 0, 0};
  float lineWidth = 1, polygonOffsetFactor = 0, polygonOffsetUnits = 0;
  float coverageValue = 1;
  bool coverageInvert = false;
};

// The combiner of the texture environment: kept. Its mode and colour belong to the bound material, as the texture does.
struct CombineState {
  RCenum rgb = RC_MODULATE, alpha = RC_MODULATE;
  std::array<RCenum, 3> sourceRgb{RC_TEXTURE, RC_PREVIOUS, RC_CONSTANT};
  std::array<RCenum, 3> sourceAlpha{RC_TEXTURE, RC_PREVIOUS, RC_CONSTANT};
  std::array<RCenum, 3> operandRgb{RC_SRC_COLOR, RC_SRC_COLOR, RC_SRC_ALPHA};
  std::array<RCenum, 3> operandAlpha{RC_SRC_ALPHA, RC_SRC_ALPHA, RC_SRC_ALPHA};
  float rgbScale = 1, alphaScale = 1;
  bool coordReplace = false;  // of point sprites
};

struct State {
  ViewState view;
  MatrixState matrices;
  LightState light;
  TextureState texture;
  ArrayState arrays;
  PaletteState palette;
  ShadowState shadow;
  HintState hints;
  PathTracingState pathTracing;
  PixelStoreState pixelStore;
  SurfaceState surface;
  ClipState clip;
  FogState fog;
  PictureState picture;
  RasterState raster;
  CombineState combine;
  ddk::Material material0;   // the state without a material object
  RCuint boundMaterial = 0;  // a name of the share group's MaterialTable, or 0
  Vec4 currentColor{1};
  bool textureOnly = false;  // captured by a draw
  int depthBounce = 10;      // the profile's
};

}  // namespace rc::api
