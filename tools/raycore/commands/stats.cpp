// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// raycore stats: what tracing a model costs.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "commands/commands.h"
#include "commands/load_options.h"
#include "commands/show_options.h"
#include "input/error.h"
#include "measure/measurement.h"
#include "measure/ray_cost.h"
#include "output/picture_file.h"

namespace rc::tool {
namespace {

struct StatsOptions {
  std::string input, heatMap;
  ShowSettings show;
  int repeat = 3;
  bool json = false;
  LoadOptions load;
};

std::string rateText(const std::optional<double> &rate) { return rate ? fmt::format("{:.2f}", *rate) : "-"; }

void print(const StatsOptions &options, const Measurement &m) {
  const auto row = [](const char *name, const std::string &text) { fmt::print("{:<24} {}\n", name, text); };
  row("model", options.input);
  row("picture", fmt::format("{} x {}, {} sample{}, {} bounces", options.show.width, options.show.height,
                             options.show.samples, options.show.samples == 1 ? "" : "s", options.show.bounces));
  row("triangles", fmt::format("{:.0f}, {:.0f} skipped", m.triangles, m.skipped));
  row("draw calls and build", fmt::format("{:.1f} ms, of which the structure {:.1f} ms", m.submitMilliseconds,
                                          m.staticBuildMilliseconds + m.frameBuildMilliseconds));
  row("memory", fmt::format("triangles {:.2f} MiB, structure {:.2f} MiB, textures {:.2f} MiB", m.triangleBytes / kMiB,
                            m.structureBytes / kMiB, m.textureBytes / kMiB));
  row("structure", fmt::format("{:.0f} nodes, {:.0f} leaves, depth {:.0f}, cost {:.2f} boxes a random line", m.nodes,
                               m.leaves, m.depth, m.cost));
  for (size_t kind = 0; kind < kRayKinds.size(); ++kind) {
    row(fmt::format("rays, {}", kRayKinds[kind]).c_str(), fmt::format("{:.0f}", m.rays[kind]));
  }
  row("trace", fmt::format("{:.1f} ms (median), {:.1f} ms (least)", m.traceMilliseconds, m.leastTraceMilliseconds));
  row("Mrays/s", fmt::format("{:.2f}; primary {}, shadow {}, reflected and refracted {}", m.raysPerSecond() / 1e6,
                             rateText(m.primaryRate), rateText(m.shadowRate), rateText(m.secondaryRate)));
  row("tests for a primary ray", fmt::format("{:.1f} boxes, {:.1f} triangles", m.boxesPerRay, m.trianglesPerRay));
}

int stats(const StatsOptions &options) {
  if (!options.heatMap.empty()) checkPictureName(options.heatMap);
  if (options.heatMap == "-") refuseOption("--heatmap: the numbers go to standard output, the picture needs a file");
  Show show(loadNamed(options.input), options.show);
  printNotes(options.input, show.scene(), options.load);
  const Measurement measurement = measure(show, options.repeat);
  if (!options.heatMap.empty()) writePicture(heatMap(rayCosts(show)), options.heatMap);
  if (!options.json) {
    print(options, measurement);
    return 0;
  }
  Json json{{"file", options.input},
            {"size", {options.show.width, options.show.height}},
            {"samples", options.show.samples},
            {"bounces", options.show.bounces}};
  json.update(jsonOf(measurement));
  fmt::print("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace));
  return 0;
}

}  // namespace

Command addStats(CLI::App &app) {
  CLI::App *command = app.add_subcommand("stats", "What tracing a model costs");
  auto options = std::make_shared<StatsOptions>();
  command->add_option("model", options->input, "File of the model; - reads glTF from standard input")->required();
  addShowOptions(*command, options->show);
  command->add_option("--repeat", options->repeat, "Pictures traced for each number; the median counts")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_option("--heatmap", options->heatMap, "A picture of the traversal cost, with a legend: png, jpg, ...")
      ->type_name("FILE");
  command->add_flag("--json", options->json, "Print JSON");
  addLoadOptions(*command, options->load);
  command->footer(
      "Mrays/s of shadow, reflected and refracted rays are what they add to a picture without them, shading included.\n"
      "Tests of boxes and triangles are those of each primary ray by itself; the device shares some among neighbours.\n"
      "Examples:\n  raycore stats dragon.glb --samples 1 --heatmap cost.png\n"
      "  RAYCORE_ACCEL=kdtree raycore stats dragon.glb --json");
  return {command, [options] { return stats(*options); }};
}

}  // namespace rc::tool
