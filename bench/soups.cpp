// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// soups [soup | millions ...]: how much time of processors, all threads together, builds of hard soups take, and how
// much memory they need at most, for each structure; by default all soups of 1, 2 and 4 million triangles. Each build
// has a process of its own.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "common/hard_soups.h"

namespace {

using namespace rc;

struct Structure {
  const char *name;
  AccelKind kind;
  ddk::Lifetime lifetime;
};
constexpr Structure kStructures[] = {{"KD-tree", AccelKind::KdTree, ddk::Lifetime::Scene},
                                     {"BVH", AccelKind::Bvh, ddk::Lifetime::Scene},
                                     {"BVH of a frame", AccelKind::Bvh, ddk::Lifetime::Frame}};

// Of all threads, whatever else the machine does.
struct Usage {
  double seconds;
  long peakMebibytes;
};
Usage usageNow() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval &time) { return double(time.tv_sec) + 1e-6 * double(time.tv_usec); };
  return {seconds(usage.ru_utime) + seconds(usage.ru_stime), usage.ru_maxrss / 1024};
}

void measure(const test::HardSoup &soup, const Structure &structure, size_t count) {
  const test::Triangles triangles = test::makeSoup(soup, count);
  const Workers workers(0);
  const Usage before = usageNow();
  const ddk::Accel accel = ddk::buildAccel(structure.kind, triangles, workers, structure.lifetime);
  const Usage after = usageNow();
  std::printf("| %s | %s | %.1f M | %.2f s | %ld MiB | %zu MiB |\n", soup.name, structure.name, double(count) * 1e-6,
              after.seconds - before.seconds, after.peakMebibytes - before.peakMebibytes, accel.bytes() >> 20);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char **argv) {
  std::vector<double> millions;
  std::vector<std::string> names;
  for (int i = 1; i < argc; ++i) {
    if (std::atof(argv[i]) > 0) {
      millions.push_back(std::atof(argv[i]));
    } else if (std::ranges::find(test::kHardSoups, std::string(argv[i]), &test::HardSoup::name) ==
               std::end(test::kHardSoups)) {
      return std::fprintf(stderr, "%s is neither a soup nor a number of millions\n", argv[i]), 1;
    } else {
      names.emplace_back(argv[i]);
    }
  }
  if (millions.empty()) millions = {1, 2, 4};
  std::printf(
      "| soup | structure | triangles | processors | memory while building | structure |\n|---|---|---|---|---|---|\n");
  std::fflush(stdout);
  for (const test::HardSoup &soup : test::kHardSoups) {
    if (!names.empty() && std::ranges::find(names, soup.name) == names.end()) continue;
    for (const Structure &structure : kStructures) {
      for (const double million : millions) {
        const pid_t child = fork();
        if (child == 0) {
          measure(soup, structure, size_t(million * 1e6));
          _exit(0);
        }
        int status = 0;
        waitpid(child, &status, 0);
        if (status != 0) return std::printf("%s, %s: it fails\n", soup.name, structure.name), 1;
      }
    }
  }
}
