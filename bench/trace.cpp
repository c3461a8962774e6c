// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Millions of rays a second: ours beside the peers that were found when this was built. All in one process, on the
// same rays, in turns; the median of the rounds. Rays are checked against the first tracer of the list.
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "peers/report.h"
#include "peers/tracer.h"

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace {

using namespace rc::bench;

// What Embree asks its callers for; the same for everybody.
void flushDenormals() {
#if defined(__SSE__)
  _mm_setcsr(_mm_getcsr() | 0x8040);
#endif
}

constexpr size_t kChunk = 1024;

// One thread's share of the rays. A function by itself, so that scripts/instructions.py can count what it does.
[[gnu::noinline]] void traceShare(const Tracer &tracer, Kind kind, const RayBatch &rays, std::atomic<size_t> &next,
                                  FirstHit *hits) {
  flushDenormals();
  for (size_t begin; (begin = next.fetch_add(kChunk)) < rays.size();) {
    tracer.trace(kind, rays, begin, std::min(begin + kChunk, rays.size()), hits);
  }
}

double megaraysPerSecond(const Tracer &tracer, Kind kind, const RayBatch &rays, const Arguments &arguments, int threads,
                         FirstHit *hits) {
  std::atomic<size_t> next{0};
  std::atomic<int> ready{0};
  std::atomic<bool> go{false};
  const auto work = [&] { traceShare(tracer, kind, rays, next, hits); };
  std::vector<std::thread> helpers;
  for (int i = 1; i < threads; ++i) {
    helpers.emplace_back([&] {
      ++ready;
      while (!go) std::this_thread::yield();
      work();
    });
  }
  while (ready < threads - 1) std::this_thread::yield();
  const Stopwatch watch(arguments, threads);
  go = true;
  work();
  for (std::thread &helper : helpers) helper.join();
  return double(rays.size()) / watch.seconds() * 1e-6;
}

size_t mismatches(Kind kind, const std::vector<FirstHit> &found, const std::vector<FirstHit> &truth) {
  size_t count = 0;
  for (size_t i = 0; i < truth.size(); ++i) {
    const bool hit = truth[i].primitive != kMiss;
    const bool same = (found[i].primitive != kMiss) == hit &&
                      (!hit || asksBlocked(kind) || std::abs(found[i].t - truth[i].t) <= 1e-3f * (1e-3f + truth[i].t));
    count += !same;
  }
  return count;
}

void measure(const Soup &soup, const std::string &size, Kind kind, const RayBatch &rays, const Tracers &tracers,
             const Arguments &arguments, std::vector<Result> &results) {
  if (std::string(kKindNames[kind]).find(arguments.kind) == std::string::npos) return;
  std::vector<FirstHit> truth(rays.size()), hits(rays.size());
  std::vector<size_t> wrong(tracers.size());
  for (size_t i = 0; i < tracers.size(); ++i) {
    megaraysPerSecond(*tracers[i], kind, rays, arguments, 1, i == 0 ? truth.data() : hits.data());
    if (i > 0) wrong[i] = mismatches(kind, hits, truth);
  }
  for (const int threads : arguments.threads) {
    std::vector<std::vector<double>> speeds(tracers.size());
    for (int round = 0; round < arguments.rounds; ++round) {
      for (size_t i = 0; i < tracers.size(); ++i) {
        speeds[i].push_back(megaraysPerSecond(*tracers[i], kind, rays, arguments, threads, hits.data()));
      }
    }
    for (size_t i = 0; i < tracers.size(); ++i) {
      Result result = summary(speeds[i]);
      result.scene = soup.name;
      result.what = std::string(kKindNames[kind]) + " " + size;
      result.who = tracers[i]->name();
      result.threads = threads;
      result.mismatches = wrong[i];
      std::printf("%-11s %-18s %d threads  %-28s %8.2f +- %5.2f Mrays/s, %zu of %zu rays differ\n", soup.name.c_str(),
                  result.what.c_str(), threads, result.who.c_str(), result.median, result.spread, wrong[i],
                  rays.size());
      results.push_back(result);
    }
    std::fflush(stdout);
  }
}

void measureScene(const Soup &soup, const Arguments &arguments, std::vector<Result> &results) {
  Tracers tracers;
  addRaycore(soup, 2, arguments.who, tracers);
#ifdef RAYCORE_EMBREE
  addEmbree(soup, 2, arguments.who, tracers);
#endif
  if (tracers.empty()) {
    std::fprintf(stderr,
                 "nobody is left to be measured: --who names none of ours or of the peers found at build time\n");
    std::exit(2);
  }
  bool first = true;
  for (const auto &[width, height] : arguments.sizes) {
    const std::string size = std::to_string(width) + "x" + std::to_string(height);
    const RayBatch primary = primaryRays(soup, width, height);
    measure(soup, size, kPrimary, primary, tracers, arguments, results);
    if (!first) continue;
    first = false;
    std::vector<FirstHit> hits(primary.size());
    megaraysPerSecond(*tracers[0], kPrimary, primary, arguments, 1, hits.data());
    for (const Kind kind : {kShadow, kFromLight, kMirror, kDiffuse}) {
      measure(soup, size, kind, secondaryRays(soup, kind, primary, hits), tracers, arguments, results);
    }
  }
}

}  // namespace

int main(int argc, char **argv) {
  const Arguments arguments = readArguments(argc, argv);
  flushDenormals();
  std::vector<Result> results;
  for (const std::string &name : arguments.names) {
    const std::optional<Soup> soup = loadSoup(name, arguments.scenes);
    if (soup) {
      measureScene(*soup, arguments, results);
    } else {
      std::printf("%s: skipped, its file is not in %s\n", name.c_str(), arguments.scenes.c_str());
    }
  }
  std::printf("\n%s", markdownTable(results, true).c_str());
  if (!arguments.json.empty()) writeJson(arguments.json, results, "Mrays/s");
}
