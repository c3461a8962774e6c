// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "peers/report.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <sstream>

namespace rc::bench {
namespace {

[[noreturn]] void usage(const char *program) {
  std::fprintf(stderr,
               "usage: %s [--scenes DIR] [--json FILE] [--only NAME[,NAME]] [--who PART[,PART]] [--kind PART] [--size "
               "WxH[,WxH]] [--threads N[,N]] "
               "[--rounds N] [--clock wall|cpu] [--peer PROGRAM] [--povray PROGRAM] [--pictures DIR]\n",
               program);
  std::exit(2);
}

std::vector<std::string> split(const std::string &text) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
  return parts;
}

bool sameTask(const Result &a, const Result &b) {
  return a.scene == b.scene && a.what == b.what && a.threads == b.threads;
}

bool isOurs(const Result &result) { return result.who.rfind("raycore", 0) == 0; }

// The best line of a task, ours or the others'; null if there is none.
const Result *best(std::span<const Result> results, const Result &task, bool ours, bool largerIsBetter) {
  const Result *found = nullptr;
  for (const Result &result : results) {
    if (!sameTask(result, task) || isOurs(result) != ours) continue;
    if (!found || (result.median > found->median) == largerIsBetter) found = &result;
  }
  return found;
}

}  // namespace

Arguments readArguments(int argc, char **argv) {
  Arguments arguments;
  for (int i = 1; i < argc; i += 2) {
    const std::string option = argv[i];
    if (i + 1 >= argc) usage(argv[0]);
    const char *value = argv[i + 1];
    if (option == "--scenes") {
      arguments.scenes = value;
    } else if (option == "--json") {
      arguments.json = value;
    } else if (option == "--who") {
      arguments.who = split(value);
    } else if (option == "--kind") {
      arguments.kind = value;
    } else if (option == "--only") {
      arguments.names = split(value);
      arguments.chosen = true;
    } else if (option == "--peer") {
      arguments.peer = value;
    } else if (option == "--povray") {
      arguments.povRay = value;
    } else if (option == "--pictures") {
      arguments.pictures = value;
    } else if (option == "--size") {
      arguments.sizes.clear();
      for (const std::string &part : split(value)) {
        auto &[width, height] = arguments.sizes.emplace_back();
        if (std::sscanf(part.c_str(), "%dx%d", &width, &height) != 2 || width < 1 || height < 1) usage(argv[0]);
      }
    } else if (option == "--threads") {
      arguments.threads.clear();
      for (const std::string &part : split(value)) arguments.threads.push_back(std::max(1, std::atoi(part.c_str())));
    } else if (option == "--rounds") {
      arguments.rounds = std::max(1, std::atoi(value));
    } else if (option == "--clock") {
      if (std::string(value) != "wall" && std::string(value) != "cpu") usage(argv[0]);
      arguments.processorTime = std::string(value) == "cpu";
    } else {
      usage(argv[0]);
    }
  }
  return arguments;
}

double Stopwatch::now() const {
  std::timespec time;
  clock_gettime(mProcessor ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

double medianOf(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

Result summary(const std::vector<double> &values) {
  std::vector<double> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  Result result;
  result.median = sorted[sorted.size() / 2];
  result.spread = (sorted[sorted.size() * 3 / 4] - sorted[sorted.size() / 4]) / 2;
  return result;
}

std::string markdownTable(std::span<const Result> results, bool largerIsBetter) {
  std::string table =
      "| scene | task | threads | ours | | best peer | | ratio |\n|---|---|---:|---|---:|---|---:|---:|\n";
  for (size_t i = 0; i < results.size(); ++i) {
    const Result &task = results[i];
    const auto isFirst = std::none_of(results.begin(), results.begin() + long(i),
                                      [&](const Result &earlier) { return sameTask(earlier, task); });
    if (!isFirst) continue;
    const Result *ours = best(results, task, true, largerIsBetter);
    const Result *peer = best(results, task, false, largerIsBetter);
    char line[256];
    if (ours && peer) {
      const double ratio = largerIsBetter ? ours->median / peer->median : peer->median / ours->median;
      std::snprintf(line, sizeof line, "| %s | %s | %d | %s | %.2f | %s | %.2f | **%.2f** |\n", task.scene.c_str(),
                    task.what.c_str(), task.threads, ours->who.c_str(), ours->median, peer->who.c_str(), peer->median,
                    ratio);
    } else {
      std::snprintf(line, sizeof line, "| %s | %s | %d | %s | %.2f | | | |\n", task.scene.c_str(), task.what.c_str(),
                    task.threads, task.who.c_str(), task.median);
    }
    table += line;
  }
  return table;
}

void writeJson(const std::string &path, std::span<const Result> results, const char *unit) {
  std::FILE *file = std::fopen(path.c_str(), "w");
  if (!file) {
    std::fprintf(stderr, "cannot write %s\n", path.c_str());
    std::exit(1);
  }
  std::fprintf(file, "{\"unit\": \"%s\", \"results\": [\n", unit);
  for (size_t i = 0; i < results.size(); ++i) {
    const Result &r = results[i];
    std::fprintf(file,
                 "  {\"scene\": \"%s\", \"task\": \"%s\", \"who\": \"%s\", \"threads\": %d, \"median\": %.4f, "
                 "\"spread\": %.4f, \"mismatches\": %zu}%s\n",
                 r.scene.c_str(), r.what.c_str(), r.who.c_str(), r.threads, r.median, r.spread, r.mismatches,
                 i + 1 < results.size() ? "," : "");
  }
  std::fprintf(file, "]}\n");
  std::fclose(file);
}

}  // namespace rc::bench
