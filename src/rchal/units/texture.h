// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// texture.h: the texture mapping unit: wrapping, mip level, bilinear filter. [spec 3.4; G 5.2]
// In: TextureView, uv, level of detail.  Out: a texel, 0 ... 1 each channel.  Next: units/shading.h
#pragma once

#include "rchal/scene_view.h"

namespace rc::hal {

inline Vec4 unpackTexel(uint32_t rgba) {
  return Vec4(rgba & 255, rgba >> 8 & 255, rgba >> 16 & 255, rgba >> 24) * (1.0f / 255);
}

// Texel index for any integer position; size is a power of two.
inline int wrapIndex(int i, int size, Wrap wrap) {
  switch (wrap) {
    case Wrap::ClampToEdge:
      return std::clamp(i, 0, size - 1);
    case Wrap::MirroredRepeat: {
      const int inPair = i & (2 * size - 1);
      return inPair < size ? inPair : 2 * size - 1 - inPair;
    }
    case Wrap::Repeat:
      break;
  }
  return i & (size - 1);
}

// Position in texels; coordinates so large that they have no fraction left, or that are not numbers, count as 0.
inline float texelPosition(float coordinate, int size) {
  const float position = coordinate * static_cast<float>(size) - 0.5f;
  return std::abs(position) < 1e9f ? position : -0.5f;
}

inline Vec4 sampleBilinear(const TextureView &texture, int level, Vec2 uv, Wraps wraps) {
  const int width = std::max(texture.width >> level, 1), height = std::max(texture.height >> level, 1);
  const float x = texelPosition(uv.x, width), y = texelPosition(uv.y, height);
  const float x0 = std::floor(x), y0 = std::floor(y);
  const int columns[2] = {wrapIndex(int(x0), width, wraps.s), wrapIndex(int(x0) + 1, width, wraps.s)};
  const int rows[2] = {wrapIndex(int(y0), height, wraps.t), wrapIndex(int(y0) + 1, height, wraps.t)};
  const uint32_t *texels = texture.levels[level];
  const auto texel = [&](int row, int column) { return unpackTexel(texels[size_t(row) * size_t(width) + column]); };
  const float fx = x - x0, fy = y - y0;
  const Vec4 lower = glm::mix(texel(rows[0], columns[0]), texel(rows[0], columns[1]), fx);
  const Vec4 upper = glm::mix(texel(rows[1], columns[0]), texel(rows[1], columns[1]), fx);
  const Vec4 mixed = glm::mix(lower, upper, fy);
  return texture.hasAlpha ? mixed : Vec4(Vec3(mixed), unpackTexel(*texels).w);
}

// lod: logarithm to base 2 of the footprint in texels of level 0; below 0 the texture is magnified.
inline Vec4 sampleTexture(const TextureView &texture, Vec2 uv, Wraps wraps, float lod) {
  const float last = static_cast<float>(texture.levelCount - 1);
  const float level = lod > 0 ? std::min(lod, last) : 0.0f;  // also where lod is not a number
  if (!texture.trilinear) return sampleBilinear(texture, int(std::floor(level + 0.5f)), uv, wraps);
  const int coarse = std::min(int(level) + 1, texture.levelCount - 1);
  const Vec4 fine = sampleBilinear(texture, int(level), uv, wraps);
  return glm::mix(fine, sampleBilinear(texture, coarse, uv, wraps), level - std::floor(level));
}

// Share of a texel that is there; the rest lets the ray go straight on. A decal lies on its surface, which is there.
// [spec 3.4; OpenGL ES 1.1, 3.7.12]
inline float opacityOf(const MaterialRow &material, const TextureView &texture, float alpha) {
  if (material.textureEnv == TextureEnv::Decal) return 1;
  return std::min(alpha * 255.0f / texture.opaqueAlpha, 1.0f);
}

}  // namespace rc::hal
