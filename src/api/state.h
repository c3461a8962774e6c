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
};

// A buffer object: client arrays and indices in memory of ours. [reference 4.7]
struct Buffer {
  std::vector<std::byte> bytes;
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
  BufferBinding arrayBuffer, elementBuffer;
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
  RCenum perspective = RC_DONT_CARE, pointSmooth = RC_DONT_CARE;
};

// Of the second generation: stored, without effect on the picture. [spec 7; reference 4.12]
struct PathTracingState {
  RCfloat lightRadius = 100;
  RCuint diffuseRate = 10;  // tenths of the probability of a diffuse ray
  RCuint sampleCount = 8;   // a pixel
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
  ddk::Material material0;   // the state without a material object
  RCuint boundMaterial = 0;  // a name of the share group's MaterialTable, or 0
  Vec4 currentColor{1};
  bool textureOnly = false;  // captured by a draw
  int depthBounce = 10;      // the profile's
};

}  // namespace rc::api
