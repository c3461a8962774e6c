// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// planet.h: pictures of an invented planet and of a starry sky, for the programs about light.
#pragma once

#include "common/pictures.h"

// Continents, oceans and ice on a cylindrical map: u runs east, v north.
inline Picture planet(int width, int height) {
  return Picture(width, height, [](float u, float v, float *out) {
    const float ground = cloudNoise(u, v, 5), latitude = std::fabs(2 * v - 1);
    const float land = std::clamp((ground - 0.5f) * 12 + 0.3f, 0.0f, 1.0f);
    const float ice = std::clamp((latitude + 0.3f * ground - 0.98f) * 15, 0.0f, 1.0f);
    const float dry = cloudNoise(u + 0.37f, v, 9);
    const float ocean[3] = {0.01f, 0.07f + 0.06f * ground, 0.25f + 0.2f * ground};
    const float soil[3] = {0.15f + 0.45f * dry, 0.3f + 0.2f * dry, 0.1f + 0.15f * dry};
    for (int i = 0; i < 3; ++i) {
      const float surface = ocean[i] + (soil[i] - ocean[i]) * land;
      out[i] = surface + (0.95f - surface) * ice;
    }
  });
}

// Stars over a faint band of light.
inline Picture starField(int width, int height) {
  return Picture(width, height, [=](float u, float v, float *out) {
    const float distance = (v - 0.5f) - 0.5f * (u - 0.5f);
    const float band = std::exp(-30 * distance * distance) * cloudNoise(u, v, 6);
    const float chance = gridNoise(int(u * float(width)), int(v * float(height)));
    const float star = chance > 0.995f - 0.01f * band ? (chance - 0.98f) * 40 : 0;
    out[0] = 0.02f + 0.35f * band + star, out[1] = 0.02f + 0.3f * band + star, out[2] = 0.05f + 0.4f * band + star;
  });
}
