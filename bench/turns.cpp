// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Draws frames of a scene when it is told to: scripts/in_turns.py lets builds of the library take turns in this way,
// frame by frame, on one core, so that what else the machine does meets all of them.
// turns SCENES NAME WIDTH HEIGHT; for each number N on its input N frames, and a line: milliseconds a frame, the
// process's own.
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "frames/stage.h"

namespace {

double ownMilliseconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return double(now.tv_sec) * 1e3 + double(now.tv_nsec) * 1e-6;
}

}  // namespace

int main(int argc, char **argv) {
  if (argc != 5) {
    std::fprintf(stderr, "turns SCENES NAME WIDTH HEIGHT: see scripts/in_turns.py\n");
    return 2;
  }
  rc::bench::useThreads(1);
  const auto scene = rc::bench::loadFrameScene(argv[2], argv[1]);
  if (!scene) {
    std::fprintf(stderr, "turns: there is no scene %s in %s\n", argv[2], argv[1]);
    return 1;
  }
  rc::bench::Stage stage(*scene, std::atoi(argv[3]), std::atoi(argv[4]));
  int frame = 0, frames = 0;
  while (std::scanf("%d", &frames) == 1 && frames > 0) {
    const double start = ownMilliseconds();
    for (int i = 0; i < frames; ++i) stage.draw(frame++);
    std::printf("%.4f\n", (ownMilliseconds() - start) / frames);
    std::fflush(stdout);
  }
}
