// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Milliseconds a frame through the public API, beside a Whitted renderer on Embree which traces the same scenes: the
// program that --peer names; and beside POV-Ray, which --povray names, where nothing moves: tracing alone, without
// antialiasing. They take turns; medians. Where things move also as a film, moving included: each frame finished before
// the next one is begun, and traced beside it. On the first of --threads if that is one number, else on two.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "frames/povray.h"
#include "frames/program.h"
#include "frames/stage.h"
#include "peers/report.h"

namespace {

using namespace rc::bench;

constexpr int kFrames = 6;  // a round

// What all measurements of a run share.
struct Run {
  const Arguments &arguments;
  std::string folder;  // for the files that peers read
  int threads;
};

// Runs the peer for a few frames: milliseconds of its fastest way, building included where it does that each frame.
double peerMilliseconds(const Run &run, const FrameScene &scene, const std::string &size) {
  double best = 0;
  for (const char *how : {":flat", ":inst"}) {
    const bool moves = !scene.moving.empty();
    if (!moves && std::strcmp(how, ":flat") != 0) break;
    std::string command = "RES=" + size;
    command.append(" SCENES='")
        .append(run.folder)
        .append("' '")
        .append(run.arguments.peer)
        .append("' ")
        .append(scene.peer);
    command.append(moves ? how : "").append(" ").append(std::to_string(kFrames));
    double fastest = 0, build = 0;
    forEachLineOf(command, [&](const char *line) {
      int ofThreads = 0;
      double value = 0;
      const char *place = std::strstr(line, " thr: median");
      if (place && std::sscanf(place - 2, "%d thr: median %lf", &ofThreads, &value) == 2 && ofThreads == run.threads) {
        if (fastest == 0 || value < fastest) fastest = value;
      }
      if (std::sscanf(line, " dynamic rebuild: median %lf", &value) == 1) build = value;
    });
    if (fastest > 0 && (best == 0 || fastest + build < best)) best = fastest + build;
  }
  return best;
}

Result named(Result result, const FrameScene &scene, const std::string &what, const char *who, int threads) {
  result.scene = scene.name;
  result.what = what;
  result.who = who;
  result.threads = threads;
  std::printf("%-13s %-10s %d threads  %-16s %8.2f +- %5.2f ms\n", scene.name.c_str(), what.c_str(), threads, who,
              result.median, result.spread);
  std::fflush(stdout);
  return result;
}

// Times are empty where nobody was asked, 0 where a peer has told none.
void report(const std::vector<double> &times, const FrameScene &scene, const std::string &size, const char *who,
            const Run &run, std::vector<Result> &results) {
  if (times.empty()) return;
  if (medianOf(times) == 0) {
    std::printf("%-13s %-10s %s told no time: does the program run by itself?\n", scene.name.c_str(), size.c_str(),
                who);
    return;
  }
  results.push_back(named(summary(times), scene, size, who, run.threads));
}

void measure(const FrameScene &scene, int width, int height, const Run &run, std::vector<Result> &results) {
  const Arguments &arguments = run.arguments;
  const std::string size = std::to_string(width) + "x" + std::to_string(height);
  const std::string picture = arguments.pictures.empty() ? "" : arguments.pictures + "/" + scene.name;
  const std::string pov = arguments.povRay.empty() || !scene.moving.empty() ? "" : run.folder + "/scene.pov";
  if (!pov.empty()) writePovRay(pov, scene, width, height);
  std::vector<double> ours, theirs, povRays, submits, finished, swapped;
  int frame = 0;
  for (int round = 0; round < arguments.rounds; ++round) {
    Stage stage(scene, width, height);
    stage.draw(frame++);
    for (int i = 0; i < kFrames; ++i) {
      const FrameTimes times = stage.draw(frame++);
      ours.push_back(times.whole());
      submits.push_back(times.submit);
    }
    if (round == 0) {
      std::printf("%-13s %-10s %.0f rays a frame\n", scene.name.c_str(), size.c_str(), stage.rays());
      if (!picture.empty()) stage.save(picture + ".ppm");
    }
    if (!scene.moving.empty()) {
      finished.push_back(stage.film(frame, kFrames, true));
      swapped.push_back(stage.film(frame, kFrames, false));
      frame += kFrames;
    }
    if (!arguments.peer.empty() && !scene.peer.empty()) theirs.push_back(peerMilliseconds(run, scene, size));
    if (pov.empty()) continue;
    const PovRayTimes times =
        runPovRay(arguments.povRay, pov, picture.empty() ? "" : picture + "-povray.png", width, height, run.threads);
    povRays.push_back(times.milliseconds);
    if (round == 0) std::printf("%-13s %-10s %.0f rays by POV-Ray, shadows not counted\n", "", "", times.rays);
  }
  report(ours, scene, size, "raycore", run, results);
  if (!scene.moving.empty()) {
    std::printf("%-13s of which submitting %.2f ms\n", "", medianOf(submits));
    named(summary(finished), scene, "film", "finished, swapped", run.threads);
    named(summary(swapped), scene, "film", "swapped alone", run.threads);
  }
  report(theirs, scene, size, "embree whitted", run, results);
  report(povRays, scene, size, "POV-Ray", run, results);
}

}  // namespace

int main(int argc, char **argv) {
  Arguments arguments = readArguments(argc, argv);
  const std::string folder = std::filesystem::temp_directory_path() / "raycore-bench-frame";
  std::filesystem::create_directories(folder);
  if (arguments.peer.empty()) {
    std::printf("no peer: name the Whitted renderer on Embree with --peer\n");
  } else {
    writeSoups(folder, arguments.scenes);
  }
  const int threads = arguments.threads.size() == 1 ? arguments.threads[0] : 2;
  useThreads(threads);
  const Run run{arguments, folder, threads};
  if (!arguments.chosen)
    arguments.names = {"cornell", "bunny", "sponza", "sponzamirror", "dyn70k", "dyn10k", "spheres", "balls", "panes"};
  std::vector<Result> results;
  for (const std::string &name : arguments.names) {
    const std::optional<FrameScene> scene = loadFrameScene(name, arguments.scenes);
    if (!scene) {
      std::printf("%s: skipped, its file is not in %s\n", name.c_str(), arguments.scenes.c_str());
      continue;
    }
    for (const auto &[width, height] : arguments.sizes) {
      if (threads == 1 && !scene->moving.empty()) continue;  // the peer rebuilds on two
      measure(*scene, width, height, run, results);
    }
  }
  std::printf("\n%s", markdownTable(results, false).c_str());
  if (!arguments.json.empty()) writeJson(arguments.json, results, "ms");
  std::filesystem::remove_all(folder);
}
