// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// How the time of a frame grows with triangles, lights, bounces and pixels: all, or those that --only names.
// scripts/growth.py draws the JSON.
#include <algorithm>
#include <cstdio>

#include "frames/stage.h"
#include "peers/report.h"

namespace {

using namespace rc::bench;

struct Size {
  int width, height;
};
constexpr Size kUsual{800, 480};

struct Point {
  std::string scene;
  double x;
  Size size = kUsual;
};
struct Series {
  const char *name;
  std::vector<Point> points;
};

std::vector<Series> allSeries() {
  std::vector<Series> all{{"triangles", {}}, {"lights", {}}, {"bounces", {}}, {"pixels", {}}};
  for (const int n : {1000, 4000, 16000, 64000, 250000, 1000000, 4000000}) {
    all[0].points.push_back({"hills" + std::to_string(n), double(n)});
  }
  for (int n = 1; n <= 8; ++n) all[1].points.push_back({"lights" + std::to_string(n), double(n)});
  for (int n = 0; n <= 14; n += 2) all[2].points.push_back({"bounces" + std::to_string(n), double(n)});
  for (const Size size : {Size{200, 120}, {400, 240}, {800, 480}, {1200, 720}, {1600, 960}, {1920, 1080}}) {
    all[3].points.push_back({"bunny", double(size.width) * size.height, size});
  }
  return all;
}

// Frames of one point: a first one that builds, then some that are measured.
Result measure(const Series &series, const Point &point, int threads, int frames, const std::string &folder) {
  const std::optional<FrameScene> scene = loadFrameScene(point.scene, folder);
  if (!scene) {
    std::printf("%s: skipped, its file is not in %s\n", point.scene.c_str(), folder.c_str());
    return {};
  }
  Stage stage(*scene, point.size.width, point.size.height);
  stage.draw(0);
  std::vector<double> times;
  for (int i = 1; i <= frames; ++i) times.push_back(stage.draw(i).whole());
  Result result = summary(times);
  result.scene = series.name;
  char x[32];
  std::snprintf(x, sizeof x, "%.0f", point.x);
  result.what = x;
  result.who = "raycore";
  result.threads = threads;
  std::printf("| %s | %s | %.2f | %.2f | %.0f | %.1f |\n", series.name, x, result.median, result.spread, stage.rays(),
              1e6 * result.median / stage.rays());
  std::fflush(stdout);
  return result;
}

}  // namespace

int main(int argc, char **argv) {
  const Arguments arguments = readArguments(argc, argv);
  const int threads = arguments.threads.size() == 1 ? arguments.threads[0] : 2;
  useThreads(threads);
  std::printf("| growth with | | ms a frame | +- | rays | ns a ray |\n|---|---:|---:|---:|---:|---:|\n");
  std::vector<Result> results;
  for (const Series &series : allSeries()) {
    const auto &names = arguments.names;
    if (arguments.chosen && std::find(names.begin(), names.end(), series.name) == names.end()) continue;
    for (const Point &point : series.points) {
      const Result result = measure(series, point, threads, 3 * arguments.rounds, arguments.scenes);
      if (!result.scene.empty()) results.push_back(result);
    }
  }
  if (!arguments.json.empty()) writeJson(arguments.json, results, "ms");
}
