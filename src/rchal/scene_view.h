// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// scene_view.h: all a device needs to trace one frame, read-only. Everything is in world space.
// rcddk/driver.cpp fills it; it is valid while the device traces.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "base/vec.h"
#include "rchal/node_formats.h"

namespace rc::hal {

// What a draw call fixed for its triangles.
enum TriangleFlag : uint32_t {
  kHasNormals = 1,           // interpolate TriangleAttributes::normal; else the flat normal
  kTextureOnly = 2,          // RC_USE_TEXTURE_ONLY
  kTransmittanceShadow = 4,  // RC_USE_TRANSMITTANCE_SHADOW
  kAlphaShadow = 8,          // RC_USE_TEXTURE_ALPHA_SHADOW
  kHasColors = 16,           // TriangleAttributes::color multiplies ambient and diffuse
  kTangentFrame = 32,        // TriangleAttributes::normal is the frame of a normal map: tangent, bitangent, normal
  kClockwiseFront = 64,      // the front is where the vertices run clockwise
  kCullFront = 128,          // rays do not see the front side
  kCullBack = 256,           // nor the back side
  // Bits 12-14: the alpha test, bits 16-23 its reference value; units/coverage.h
};
inline constexpr int kAlphaTestShift = 12, kAlphaReferenceShift = 16;
inline constexpr uint32_t kAlphaTestMask = 7u << kAlphaTestShift;

// A triangle with one of these may let a ray through.
inline constexpr uint32_t kFiltersShadow =
    kTransmittanceShadow | kAlphaShadow | kCullFront | kCullBack | kAlphaTestMask;

// Hot: what intersection reads, and every hit. One cache line.
struct alignas(64) HotTriangle {
  Vec3 v0, v1, v2;    // 36
  uint32_t material;  //  4  below kNamedMaterials: a name; else kNamedMaterials + index into captured
  uint32_t flags;     //  4  TriangleFlag
  float safeOffset;   //  4  how far off its plane new rays start, so that they cannot meet it again
  Vec3 flatNormal;    // 12  unit length, on the counter-clockwise side
  float doubleArea;   //  4
};
static_assert(sizeof(HotTriangle) == 64);

// Cold: what hits interpolate between the corners. Without colours that is one cache line.
struct alignas(64) TriangleAttributes {
  Vec3 normal[3];  // 36  unit length (between such where a clip plane cut), valid with kHasNormals
  Vec2 uv[3];      // 24
  Rgb color[3];    // 36  valid with kHasColors
};
static_assert(sizeof(TriangleAttributes) == 128);

// Rounding error of interpolating a position (Pharr et al., "Physically Based Rendering", 6.8.4), four times over for
// that of the intersection which follows. By the largest coordinate, since that one is rounded by the next ray's own
// axes: a wall in a coordinate plane needs its distance too.
inline constexpr float kPositionError = 4 * 7 * 0x1p-24f;

// Distances to a triangle are rounded by as much as its longest edge squared over its height: beside this the rounding
// of positions is nothing where it is many times longer than high.
inline constexpr float kSliver = 8;  // times longer than high
inline constexpr float kSliverError = 8 * 0x1p-24f;
inline constexpr float kMostOfEdge = 1.0f / 64;  // of what is thinner nobody sees more than specks

// What coordinates of a triangle are rounded by grows with it.
inline float largestCoordinate(const Vec3 &v0, const Vec3 &v1, const Vec3 &v2) {
  return maxComponent(glm::max(glm::abs(v0), glm::max(glm::abs(v1), glm::abs(v2))));
}

// What else is known of a triangle. Without an area it has no normal.
struct TrianglePlane {
  Vec3 flatNormal;
  float doubleArea, safeOffset;
};
inline TrianglePlane planeOf(const Vec3 &v0, const Vec3 &v1, const Vec3 &v2) {
  const Vec3 a = v1 - v0, b = v2 - v0, c = v2 - v1;
  const Vec3 edges = glm::cross(a, b);
  const float doubleArea = lengthOf(edges);
  const float longest = std::max(glm::dot(a, a), std::max(glm::dot(b, b), glm::dot(c, c)));
  const float slenderness = longest / doubleArea;
  const bool sliver = slenderness > kSliver && longest < kInfinity;
  const float sliverOffset = sliver ? std::sqrt(longest) * std::min(kSliverError * slenderness, kMostOfEdge) : 0;
  return {edges / doubleArea, doubleArea, std::max(kPositionError * largestCoordinate(v0, v1, v2), sliverOffset)};
}

inline void setPlane(const TrianglePlane &plane, HotTriangle &triangle) {
  triangle.safeOffset = plane.safeOffset;
  triangle.flatNormal = plane.flatNormal;
  triangle.doubleArea = plane.doubleArea;
}
inline void setPlane(HotTriangle &triangle) { setPlane(planeOf(triangle.v0, triangle.v1, triangle.v2), triangle); }

inline constexpr uint32_t kNamedMaterials = 512;
inline constexpr int32_t kNoTexture = -1;

enum class Wrap : uint8_t { Repeat, ClampToEdge, MirroredRepeat };
struct Wraps {
  Wrap s = Wrap::Repeat, t = Wrap::Repeat;
};

// How a texel changes the colours of the material.
enum class TextureEnv : uint8_t { Replace, Modulate, Decal, Blend, Add };

// Cosines up to here are nothing that could be seen, to the power of shininess.
inline float leastShineOf(float shininess) { return shininess > 0 ? std::exp2(-30 / shininess) : -kInfinity; }

struct MaterialRow {
  Rgb ambient{0.2f}, diffuse{0.8f};
  Rgb specular{0};  // level included
  Rgb emission{0};
  Rgb reflection{0}, transmittance{0};  // sum at most 1 in each channel
  Rgb shadowTint{0};                    // what a shadow ray keeps; transmittance after the tint law
  float shininess = 0;
  float leastShine = -kInfinity;  // leastShineOf(shininess)
  float refractionIndex = 1;
  int32_t texture = kNoTexture, normalMap = kNoTexture;  // into SceneView::textures
  Wraps textureWrap, normalWrap;
  TextureEnv textureEnv = TextureEnv::Replace;
  Rgb textureEnvColor{0};
};

inline constexpr int kMaxTextureLevels = 15;  // 16384 ... 1

struct TextureView {
  std::array<const uint32_t *, kMaxTextureLevels> levels{};  // RGBA8, R in the low byte, rows from v = 0
  int width = 0, height = 0;                                 // of level 0
  int levelCount = 0;
  bool trilinear = false;
  int anisotropy = 1;      // most samples side by side where a footprint is stretched
  bool hasAlpha = true;    // it was loaded with alpha; else all texels have one alpha, which decides opacity alone
  float opaqueAlpha = 16;  // the alpha, 0 ... 255, from which on a texel is opaque
};

struct LightRow {
  Vec3 position{0, 0, 1};  // or, directional, the unit direction towards the light
  bool directional = true;
  bool castsShadow = true;
  bool sendsShadowRays = false;  // they start at the light: units/shadow_ray.h
  bool spot = false;
  Rgb ambient{1}, diffuse{0.1f}, specular{0};
  Vec3 spotDirection{0, 0, -1};       // unit
  float cosInner = 1, cosOuter = -1;  // of the half angles
  float spotExponent = 0;
  float constant = 1, linear = 0, quadratic = 0;
  float rangeStart = 0, rangeEnd = 0;  // world units; off while end <= start

  bool fades() const { return linear != 0 || quadratic != 0; }  // range apart
};

// Colour that surfaces fade to, by the length of the ray's way from the eye.
enum class FogMode : uint8_t { Off, Linear, Exp, Exp2 };
struct Fog {
  FogMode mode = FogMode::Off;
  float density = 1, start = 0, end = 1;
  Rgb color{0};
};

// A rectangle of the picture, in pixels from the lower left.
struct PixelRect {
  int column = 0, row = 0, columns = 0, rows = 0;
};

// Primary rays leave `eye` through the window, which lies at distance `near` against `back`. Parallel ones leave
// the window itself, against `back`; `near` may then be negative.
struct CameraView {
  Vec3 eye{0}, right{1, 0, 0}, up{0, 1, 0}, back{0, 0, 1};
  float left = -1, bottom = -1, width = 2, height = 2, near = 1;
  int columns = 0, rows = 0;  // of the viewport: pixels the window is divided into
  bool parallel = false;
};

// One set of triangles with its structure: the static scene, or the frame's dynamic geometry.
struct GeometryView {
  std::span<const HotTriangle> triangles;
  std::span<const TriangleAttributes> attributes;  // one for each triangle
  std::span<const MaterialRow> captured;           // rows of draws without a material object
  AccelView accel;
  bool filtersShadow = false;  // some triangle has a flag of kFiltersShadow
  bool interpolates = false;   // some triangle has normals or colours at its corners
};

struct SceneView {
  // Primitive numbers run through both sets: 0 ... n-1 static, then dynamic.
  std::array<GeometryView, 2> geometry;
  std::span<const MaterialRow> materials;  // by name
  std::span<const TextureView> textures;
  std::span<const LightRow> lights;
  CameraView camera;
  Rgb clearColor{0};
  int maxBounces = 10;
  int samples = 1;        // a pixel
  bool adaptive = false;  // several samples only where the corners of a pixel differ
  float minWeight = 0;    // secondary rays whose weight is below are dropped
  float ignorable = 0;    // rays of a pixel that together weigh no more are left out: at most a step of a byte
  bool measure = false;   // RayCounts::times are wanted
  bool shadows = true;
  bool mipmaps = true;
  Rgb globalAmbient{0};  // light without a source, for the ambient colour
  Fog fog;
  std::optional<PixelRect> scissor;  // pixels outside keep what they are
  uint32_t writeMask = ~0u;          // bits of a pixel that are written

  bool filtersShadow() const { return geometry[0].filtersShadow || geometry[1].filtersShadow; }
};

// A primitive number as a set and a place in it.
struct PrimitivePlace {
  const GeometryView &geometry;
  uint32_t index;
};
inline PrimitivePlace placeOf(const SceneView &scene, uint32_t primitive) {
  const auto firstDynamic = static_cast<uint32_t>(scene.geometry[0].triangles.size());
  return primitive < firstDynamic ? PrimitivePlace{scene.geometry[0], primitive}
                                  : PrimitivePlace{scene.geometry[1], primitive - firstDynamic};
}

inline const MaterialRow &materialOf(const SceneView &scene, const GeometryView &geometry,
                                     const HotTriangle &triangle) {
  return triangle.material < kNamedMaterials ? scene.materials[triangle.material]
                                             : geometry.captured[triangle.material - kNamedMaterials];
}

}  // namespace rc::hal
