// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Draws frames of a scene when it is told to: scripts/in_turns.py lets builds of the library take turns in this way,
// frame by frame, on one core, so that what else the machine does meets all of them.
// turns [--scenes DIR] [--only NAME] [--size WxH]; for each number N on its input N frames, and a line: milliseconds a
// frame, the process's own.
#include <cstdio>

#include "frames/stage.h"
#include "peers/report.h"

int main(int argc, char **argv) {
  using namespace rc::bench;
  Arguments arguments = readArguments(argc, argv);
  arguments.processorTime = true;
  useThreads(1);
  const std::string &name = arguments.names.front();
  const auto scene = loadFrameScene(name, arguments.scenes);
  if (!scene) {
    std::fprintf(stderr, "turns: there is no scene %s in %s\n", name.c_str(), arguments.scenes.c_str());
    return 1;
  }
  const auto [width, height] = arguments.sizes.front();
  Stage stage(*scene, width, height);
  int frame = 0, frames = 0;
  while (std::scanf("%d", &frames) == 1 && frames > 0) {
    const Stopwatch watch(arguments, 1);
    for (int i = 0; i < frames; ++i) stage.draw(frame++);
    std::printf("%.4f\n", 1e3 * watch.seconds() / frames);
    std::fflush(stdout);
  }
}
