// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// thirty_scenes.h: pictures that must not depend on anything but their scene: twenty-four of rcddi/random_scenes.h, and
// six through the C API whose structures are built by many threads, in every way there is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rc::test {

#ifdef RAYCORE_FEW_TARGETS  // sanitizers are slow: every sixth of the random ones
inline constexpr int kRandomStep = 6;
#else
inline constexpr int kRandomStep = 1;
#endif
inline constexpr int kRandomScenes = 24 / kRandomStep, kApiScenes = 6, kScenes = kRandomScenes + kApiScenes;
inline constexpr int kSceneWidth = 64, kSceneHeight = 48;
inline constexpr std::size_t kScenePixels = std::size_t(kSceneWidth) * kSceneHeight;

// The pixels of scene 0 ... kScenes - 1, with the settings of the process; framesBefore: other frames that the same
// device or context draws first.
std::vector<uint32_t> pictureOfScene(int scene, int framesBefore);

}  // namespace rc::test
