// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// raycore bench: the standard scenes in numbers that can be compared between versions and machines.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "bench/scenes.h"
#include "commands/commands.h"
#include "commands/show_options.h"
#include "doctor/machine.h"
#include "input/error.h"
#include "input/file.h"
#include "load/named_load.h"
#include "measure/measurement.h"
#include "output/picture_file.h"
#include "output/progress.h"

namespace rc::tool {
namespace {

namespace fs = std::filesystem;

constexpr int kFormat = 1;  // of the JSON

struct BenchOptions {
  ShowSettings show;
  std::string scenes, compare, pictures;
  std::vector<std::string> only;
  int repeat = 5;
  bool json = false, quiet = false;
};

struct Task {
  std::string name;
  Scene (*make)() = nullptr;  // built in
  std::string file;           // or read
  ShowSettings settings;
};

ShowSettings withCommon(ShowSettings settings, const ShowSettings &common) {
  settings.width = common.width;
  settings.height = common.height;
  settings.samples = common.samples;
  settings.bounces = common.bounces;
  return settings;
}

bool isWanted(const BenchOptions &options, const std::string &name) {
  return options.only.empty() || std::find(options.only.begin(), options.only.end(), name) != options.only.end();
}

std::vector<Task> tasksOf(const BenchOptions &options) {
  std::vector<Task> tasks;
  for (const BenchScene &scene : builtInScenes()) {
    tasks.push_back({scene.name, scene.make, "", withCommon(scene.settings(), options.show)});
  }
  const size_t builtIn = tasks.size();
  for (const char *file : filesOfTheSet()) {
    const fs::path path = fs::path(options.scenes) / file;
    if (options.scenes.empty() || !fs::exists(path)) continue;
    tasks.push_back({path.stem().string(), nullptr, path.string(), withCommon({}, options.show)});
  }
  if (!options.scenes.empty() && tasks.size() == builtIn) {
    reject("--scenes {}: none of the bench's files is there, such as {}", options.scenes, filesOfTheSet()[0]);
  }
  std::erase_if(tasks, [&](const Task &task) { return !isWanted(options, task.name); });
  if (tasks.empty()) refuseOption("--only {}: there is no such scene; --help lists them", fmt::join(options.only, ","));
  return tasks;
}

Json run(const BenchOptions &options, const Task &task, Scene scene) {
  Show show(std::move(scene), task.settings);
  const Measurement measurement = measure(show, options.repeat);
  if (!options.pictures.empty())
    writePicture(show.picture(0), (fs::path(options.pictures) / (task.name + ".png")).string());
  Json json{{"name", task.name}};
  json.update(jsonOf(measurement));
  return json;
}

// What must be the same for numbers to be compared.
Json settingsOf(const BenchOptions &options) {
  return {{"size", {options.show.width, options.show.height}},
          {"samples", options.show.samples},
          {"bounces", options.show.bounces}};
}

// Everything is read first: the reader is a fork, and this process must have no threads then.
Json runAll(const BenchOptions &options) {
  const std::vector<Task> tasks = tasksOf(options);
  std::vector<Scene> scenes;
  scenes.reserve(tasks.size());
  for (const Task &task : tasks) scenes.push_back(task.make ? task.make() : loadNamed(task.file));
  Json results = Json::array();
  Progress progress("scene", int(tasks.size()), options.quiet);
  for (size_t i = 0; i < tasks.size(); ++i) {
    results.push_back(run(options, tasks[i], std::move(scenes[i])));
    progress.done(int(i) + 1);
  }
  Json all{{"format", kFormat}, {"raycore", versionText()}, {"machine", aboutMachine()}};
  all.update(settingsOf(options));
  all["repeat"] = options.repeat;
  all["scenes"] = results;
  return all;
}

std::string numberOf(const Json &value, int digits) {
  return value.is_number() ? fmt::format("{:.{}f}", value.get<double>(), digits) : "-";
}

void printTable(const Json &all) {
  fmt::print("{}, {}\n\n", all["raycore"].get<std::string>(), describe(all["machine"]));
  fmt::print("{:<22}{:>10}{:>10}{:>10}{:>9}{:>9}{:>9}{:>9}{:>8}{:>8}{:>8}\n", "scene", "triangles", "build ms",
             "trace ms", "Mrays/s", "primary", "shadow", "others", "boxes", "tests", "MiB");
  for (const Json &s : all["scenes"]) {
    const Json &bytes = s["memory_bytes"];
    const double memory =
        bytes["triangles"].get<double>() + bytes["structure"].get<double>() + bytes["textures"].get<double>();
    const double build = s["static_build_ms"].get<double>() + s["frame_build_ms"].get<double>();
    fmt::print("{:<22}{:>10.0f}{:>10.2f}{:>10}{:>9}{:>9}{:>9}{:>9}{:>8}{:>8}{:>8.1f}\n", s["name"].get<std::string>(),
               s["triangles"].get<double>(), build, numberOf(s["trace_ms"], 1), numberOf(s["mrays_per_s"], 2),
               numberOf(s["mrays_per_s_primary"], 2), numberOf(s["mrays_per_s_shadow"], 2),
               numberOf(s["mrays_per_s_secondary"], 2), numberOf(s["boxes_per_ray"], 1),
               numberOf(s["triangles_per_ray"], 1), memory / kMiB);
  }
}

Json readResults(const std::string &file) {
  try {
    Json json = Json::parse(readFile(file));
    if (json.at("format") != kFormat) reject("its format is not {}", kFormat);
    for (const Json &scene : json.at("scenes")) scene.at("name").get<std::string>(), scene.at("trace_ms").get<double>();
    return json;
  } catch (const Json::exception &) {
    reject("--compare {}: is no result of raycore bench --json", file);
  } catch (const InputError &error) {
    reject("--compare {}: {}", file, error.what());
  }
}

void checkComparable(const Json &before, const BenchOptions &options) {
  const Json now = settingsOf(options);
  for (const char *key : {"size", "samples", "bounces"}) {
    const std::string then = before.contains(key) ? before.at(key).dump() : "not said";
    if (then != now.at(key).dump()) {
      reject("--compare {}: its {} is {}, not {}", options.compare, key, then, now.at(key).dump());
    }
  }
}

// Above 1: the new one is faster.
void printComparison(const Json &before, const Json &now) {
  fmt::print("\n{:<22}{:>12}{:>12}{:>9}  {}\n", "scene", "before ms", "now ms", "ratio", "picture");
  for (const Json &s : now["scenes"]) {
    const auto found = std::find_if(before["scenes"].begin(), before["scenes"].end(),
                                    [&](const Json &old) { return old["name"] == s["name"]; });
    if (found == before["scenes"].end()) continue;
    const double old = (*found)["trace_ms"].get<double>(), fresh = s["trace_ms"].get<double>();
    fmt::print("{:<22}{:>12.1f}{:>12.1f}{:>9.2f}  {}\n", s["name"].get<std::string>(), old, fresh, old / fresh,
               found->value("picture", "") == s["picture"] ? "the same" : "another");
  }
}

int bench(const BenchOptions &options) {
  const Json before = options.compare.empty() ? Json() : readResults(options.compare);
  if (!options.pictures.empty()) checkFolder(options.pictures);
  if (!before.is_null()) checkComparable(before, options);
  const Json now = runAll(options);
  if (options.json) {
    fmt::print("{}\n", now.dump(2));
    return 0;
  }
  printTable(now);
  if (!before.is_null()) printComparison(before, now);
  return 0;
}

}  // namespace

Command addBench(CLI::App &app) {
  CLI::App *command = app.add_subcommand("bench", "The standard scenes in numbers");
  auto options = std::make_shared<BenchOptions>();
  options->show.samples = 1;
  options->show.bounces = 4;  // glass in glass doubles its rays at each
  addPictureSize(*command, options->show);
  command->add_option("--scenes", options->scenes, "Folder of the test set: some of its models too")
      ->type_name("FOLDER");
  command->add_option("--only", options->only, "Names of scenes")->delimiter(',')->type_name("NAME,...");
  command->add_option("--repeat", options->repeat, "Pictures traced for each number; the median counts")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_option("--compare", options->compare, "An earlier --json: ratios to it")->type_name("FILE");
  command->add_option("--pictures", options->pictures, "Folder for a picture of each scene")->type_name("FOLDER");
  command->add_flag("--json", options->json, "Print JSON");
  command->add_flag("-q,--quiet", options->quiet, "No line of progress");
  std::string footer = "Scenes:\n";
  for (const BenchScene &scene : builtInScenes()) footer += fmt::format("  {:<10} {}\n", scene.name, scene.what);
  command->footer(footer +
                  "Mrays/s of shadow and other rays are what they add to a picture without them, shading included.\n"
                  "Examples:\n  raycore bench\n  raycore bench --json > before.json\n"
                  "  raycore bench --compare before.json");
  return {command, [options] { return bench(*options); }};
}

}  // namespace rc::tool
