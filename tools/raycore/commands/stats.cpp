// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// raycore stats: what tracing a model costs, as far as the API tells.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "commands/commands.h"
#include "commands/named_load.h"
#include "commands/show_options.h"

namespace rc::tool {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string input;
  ShowSettings show;
  int repeat = 3;
  bool json = false;
  LoadOptions load;
};

// What RayCore keeps to itself today; named so that nobody takes its absence for a zero.
constexpr const char *kNotTold[] = {"memory by kind", "depth and cost of the tree", "rays by kind",
                                    "boxes and triangles tested per ray"};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

Json measure(const Options &options) {
  Show show(loadNamed(options.input, options.load), options.show);
  std::vector<double> traced;
  double submitted = 0;
  for (int i = 0; i < options.repeat; ++i) {
    show.touch();  // an unchanged frame is not traced again
    show.picture(0);
    if (i == 0) submitted = show.statistics().buildSeconds;
    traced.push_back(show.statistics().traceSeconds);
  }
  const Statistics &s = show.statistics();
  const double seconds = median(traced);
  return {{"file", options.input},
          {"size", {options.show.width, options.show.height}},
          {"samples", options.show.samples},
          {"triangles", s.triangles},
          {"triangles_skipped", s.skipped},
          {"submit_and_build_s", submitted},
          {"trace_s", seconds},
          {"trace_s_least", *std::min_element(traced.begin(), traced.end())},
          {"rays", s.rays},
          {"rays_per_pixel", double(s.rays) / (double(options.show.width) * options.show.height)},
          {"mrays_per_s", double(s.rays) / seconds / 1e6},
          {"not_available", kNotTold}};
}

int stats(const Options &options) {
  const Json json = measure(options);
  if (options.json) {
    fmt::print("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace));
    return 0;
  }
  for (const auto &[key, value] : json.items()) {
    if (key == "not_available") continue;
    fmt::print("{:<20} {}\n", key, value.is_string() ? value.get<std::string>() : value.dump());
  }
  for (const char *name : kNotTold) fmt::print("not available: {}\n", name);
  return 0;
}

}  // namespace

Command addStats(CLI::App &app) {
  CLI::App *command = app.add_subcommand("stats", "What tracing a model costs");
  auto options = std::make_shared<Options>();
  command->add_option("model", options->input, "File of the model; - reads glTF from standard input")->required();
  addShowOptions(*command, options->show);
  command->add_option("--repeat", options->repeat, "Pictures traced; the median counts")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_flag("--json", options->json, "Print JSON");
  addLoadOptions(*command, options->load);
  command->footer(
      "Times are taken outside the library, with the clock on the wall.\n"
      "Examples:\n  raycore stats dragon.glb --samples 1\n  RAYCORE_ACCEL=bvh raycore stats dragon.glb --json");
  return {command, [options] { return stats(*options); }};
}

}  // namespace rc::tool
