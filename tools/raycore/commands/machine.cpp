// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "commands/machine.h"

#include <OpenImageIO/oiioversion.h>
#include <assimp/version.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <fstream>
#include <glm/glm.hpp>
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

// The widest of those the kernels are compiled for that the processor has: what they take.
std::string instructionSet() {
#if defined(__x86_64__)
  const bool avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw");
  if (avx512) return "AVX-512";
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return "AVX2";
  return __builtin_cpu_supports("sse4.2") ? "SSE4" : "SSE2";
#elif defined(__aarch64__)
  return "NEON";
#else
  return "scalar";
#endif
}

int threads() {
  const int asked = std::atoi(environment("RAYCORE_THREADS", "0").c_str());
  return asked > 0 ? asked : static_cast<int>(std::thread::hardware_concurrency());
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
