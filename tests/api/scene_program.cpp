// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// scene_program FRAMES_BEFORE: the pixels of all scenes on the standard output. Processes of it differ in environment.
#include <cstdio>
#include <cstdlib>

#include "api/thirty_scenes.h"

int main(int argc, char **argv) {
  const int framesBefore = argc > 1 ? std::atoi(argv[1]) : 0;
  for (int scene = 0; scene < rc::test::kScenes; ++scene) {
    const std::vector<uint32_t> pixels = rc::test::pictureOfScene(scene, framesBefore);
    if (std::fwrite(pixels.data(), sizeof(uint32_t), pixels.size(), stdout) != pixels.size()) return 1;
  }
  return 0;
}
