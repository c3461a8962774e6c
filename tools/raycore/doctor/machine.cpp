// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "doctor/machine.h"

#include <OpenImageIO/oiioversion.h>
#include <assimp/version.h>
#include <fmt/format.h>
#include <hwy/targets.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <fstream>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <thread>

namespace rc::tool {
namespace {

std::string environment(const char *name, const std::string &missing) {
  const char *value = std::getenv(name);
  return value && *value ? value : missing;
}

std::string processorName() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != line.npos) return line.substr(colon + 2);
  }
  return "unknown";
}

// What Highway chooses, of the sets it is compiled for here: the library asks it too. The better a set, the lower its
// bit.
std::string instructionSet() {
  const auto usable = hwy::SupportedTargets() & int64_t(HWY_TARGETS);
  const std::string name = hwy::TargetName(usable & -usable);
  return name.starts_with("AVX3") ? "AVX-512" : name;
}

constexpr int kMostThreads = 1024;  // what the library takes [docs/environment.md]

int threads() {
  const int asked = std::atoi(environment("RAYCORE_THREADS", "0").c_str());
  const bool taken = asked >= 1 && asked <= kMostThreads;
  return taken ? asked : static_cast<int>(std::thread::hardware_concurrency());
}

}  // namespace

Json aboutMachine() {
  return {{"processor", processorName()},
          {"instruction_set", instructionSet()},
          {"threads", threads()},
          {"device", environment("RAYCORE_DEVICE", "cpu")},
          {"structure", environment("RAYCORE_ACCEL", "bvh")}};
}

std::string describe(const Json &machine) {
  return fmt::format("{}, {}, {} threads, device {}, {}", machine["processor"].get<std::string>(),
                     machine["instruction_set"].get<std::string>(), machine["threads"].get<int>(),
                     machine["device"].get<std::string>(), machine["structure"].get<std::string>());
}

Json aboutLibraries() {
  return {{"assimp", fmt::format("{}.{}.{}", aiGetVersionMajor(), aiGetVersionMinor(), aiGetVersionPatch())},
          {"openimageio", OIIO_VERSION_STRING},
          {"cli11", CLI11_VERSION},
          {"fmt", fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
          {"nlohmann_json", fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                                        NLOHMANN_JSON_VERSION_PATCH)},
          {"glm", fmt::format("{}.{}.{}", GLM_VERSION_MAJOR, GLM_VERSION_MINOR, GLM_VERSION_PATCH)}};
}

}  // namespace rc::tool
