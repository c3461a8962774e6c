// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Milliseconds of a build whose buffers are in place, as a frame with moving geometry pays them: ours beside the
// peers', in one process, in turns; the median of the rounds. The vertices move a little before each.
#include <cstdio>

#include "peers/report.h"
#include "peers/tracer.h"

namespace {

using namespace rc::bench;

void measureScene(Soup &soup, int threads, const Arguments &arguments, std::vector<Result> &results) {
  Builders builders;
  addRaycoreBuilders(soup, threads, builders);
#ifdef RAYCORE_EMBREE
  addEmbreeBuilders(soup, threads, builders);
#endif
  std::erase_if(builders, [&](const auto &builder) { return !isWanted(builder->name(), arguments.who); });
  std::vector<std::vector<double>> times(builders.size());
  for (int round = 0; round <= arguments.rounds; ++round) {
    for (rc::Vec3 &v : soup.vertices) v.y += round % 2 ? -1e-4f : 1e-4f;
    for (size_t i = 0; i < builders.size(); ++i) {
      const Stopwatch watch(arguments, threads);
      builders[i]->build();
      if (round > 0) times[i].push_back(1e3 * watch.seconds());  // the first one warms up
    }
  }
  for (size_t i = 0; i < builders.size(); ++i) {
    Result result = summary(times[i]);
    result.scene = soup.name;
    result.what = builders[i]->task() + ", " + std::to_string(soup.triangles()) + " triangles";
    result.who = builders[i]->name();
    result.threads = threads;
    std::printf("%-11s %7zu triangles %d threads  %-20s %9.2f +- %5.2f ms\n", soup.name.c_str(), soup.triangles(),
                threads, result.who.c_str(), result.median, result.spread);
    results.push_back(result);
  }
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char **argv) {
  const Arguments arguments = readArguments(argc, argv);
  std::vector<Result> results;
  for (const std::string &name : arguments.names) {
    std::optional<Soup> soup = loadSoup(name, arguments.scenes);
    if (!soup) {
      std::printf("%s: skipped, its file is not in %s\n", name.c_str(), arguments.scenes.c_str());
      continue;
    }
    for (const int threads : arguments.threads) measureScene(*soup, threads, arguments, results);
  }
  std::printf("\n%s", markdownTable(results, false).c_str());
  if (!arguments.json.empty()) writeJson(arguments.json, results, "ms");
}
