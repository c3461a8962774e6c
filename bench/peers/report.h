// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// report.h: arguments and results of the measurements: JSON for machines, a Markdown table for people.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace rc::bench {

struct Arguments {
  std::string scenes = "../shared/scenes";
  std::string json;              // written if not empty
  std::string peer;              // a program that frames are compared with
  std::string povRay;            // POV-Ray, likewise
  std::string pictures;          // the folder that frames are written to, if not empty
  std::string kind;              // only kinds whose names contain this
  std::vector<std::string> who;  // only those whose names contain one of these
  std::vector<std::string> names = {"cornell", "bunny", "sponza", "dragon203k", "dragon871k"};
  std::vector<std::pair<int, int>> sizes = {{800, 480}, {1920, 1080}};
  std::vector<int> threads = {1, 2};
  bool chosen = false;  // names were given
  int rounds = 9;
  bool processorTime = false;
};

// --scenes DIR --json FILE --only NAME[,NAME] --who PART[,PART] --kind PART --size WxH[,WxH] --threads N[,N] --rounds N
// --clock wall|cpu --peer PROGRAM --povray PROGRAM --pictures DIR. Ends the program on others.
Arguments readArguments(int argc, char **argv);

// Seconds from here to seconds(). On a machine that is busy with other work, what one thread does is better measured by
// the time it had a processor: --clock cpu. Several threads are always measured by the wall clock.
class Stopwatch {
 public:
  Stopwatch(const Arguments &arguments, int threads)
      : mProcessor(arguments.processorTime && threads == 1), mStart(now()) {}
  double seconds() const { return now() - mStart; }

 private:
  double now() const;

  bool mProcessor;
  double mStart;
};

// A line of a result: who did what how fast. Values are better when larger (Mrays/s) or smaller (ms), as said.
struct Result {
  std::string scene, what, who;
  int threads = 1;
  double median = 0, spread = 0;  // spread: half the distance between the quartiles
  size_t mismatches = 0;
};

double medianOf(std::vector<double> values);
Result summary(const std::vector<double> &values);

// One row for each scene, task and thread count: ours, the best other, and the ratio which is above 1 where we lead.
std::string markdownTable(std::span<const Result> results, bool largerIsBetter);
void writeJson(const std::string &path, std::span<const Result> results, const char *unit);

}  // namespace rc::bench
