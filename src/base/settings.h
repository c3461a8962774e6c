// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// settings.h: the environment variables RAYCORE_*, read once and checked. [spec 6]
// A value that makes no sense is reported on stderr and the default is used.
#pragma once

#include <cstdint>
#include <string>

#include "base/log.h"

namespace rc {

enum class AccelKind { KdTree, Bvh, Exhaustive };  // Exhaustive: no structure, every triangle is tried

struct Settings {
  std::string device = "cpu";        // RAYCORE_DEVICE: a name of rcddi/registry.cpp
  int threads = 0;                   // RAYCORE_THREADS: 1 ... 1024; 0 = as many as the machine has
  AccelKind accel = AccelKind::Bvh;  // RAYCORE_ACCEL=kdtree|bvh|none
  std::string profile = "guide";     // RAYCORE_PROFILE=guide|1000|mc
  std::string instructionSet;        // RAYCORE_INSTRUCTION_SET: none better; empty = the best one there is
  uint64_t memoryLimit = 0;          // RAYCORE_MEMORY_LIMIT, bytes; 0 = memory.h decides
  int samples = 1;                   // RAYCORE_SAMPLES: samples a pixel, 1 ... 64
  bool pipeline = true;              // RAYCORE_PIPELINE=0: swaps return when the picture is shown
  int frames = 0;                    // RAYCORE_FRAMES: the process ends after n swaps; 0 = never
  std::string capture;               // RAYCORE_CAPTURE: file.png, file.ppm, frame-%04d.png
  LogLevel log = LogLevel::Warning;  // RAYCORE_LOG
  std::string trace;                 // RAYCORE_TRACE: a file for every rc* call; "-" is stderr
  bool test = false;                 // RAYCORE_TEST=1: RCFramework's test mode

  bool operator==(const Settings &) const = default;
};

// Looks a variable up by name; null where it is not set.
using EnvironmentLookup = const char *(*)(const char *name);

// Pure, for tests: complaints go to `report`, one line each.
Settings readSettings(EnvironmentLookup lookup, std::string &report);

// The settings of this process.
const Settings &settings();

}  // namespace rc
