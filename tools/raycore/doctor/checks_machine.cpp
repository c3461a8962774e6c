// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// The machine and what is installed: processor, threads, folders, programs.
#include <fmt/format.h>
#include <sched.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "codec/codec.h"
#include "doctor/checks.h"
#include "doctor/machine.h"
#include "input/error.h"
#include "output/video.h"

namespace rc::tool {
namespace {

constexpr double kLittleRoom = 64 << 20;  // bytes: a film's pictures take more

// Processors that this process may use at a time: those it is tied to, and its group's share of time.
int allowedProcessors() {
  cpu_set_t tied;
  int allowed = static_cast<int>(sysconf(_SC_NPROCESSORS_ONLN));
  if (sched_getaffinity(0, sizeof tied, &tied) == 0) allowed = CPU_COUNT(&tied);
  double quota = 0, period = 0;
  if (std::ifstream file("/sys/fs/cgroup/cpu.max"); file >> quota >> period && period > 0) {
    allowed = std::min(allowed, std::max(1, static_cast<int>(std::ceil(quota / period))));
  }
  return allowed;
}

// What is wrong with a folder; empty: nothing.
std::string trouble(const std::filesystem::path &folder, const char *remedy) {
  if (access(folder.c_str(), W_OK) != 0) {
    return fmt::format("{} cannot be written: {}", folder.string(), remedy);
  }
  struct statvfs room {};
  if (statvfs(folder.c_str(), &room) == 0 && double(room.f_bavail) * double(room.f_frsize) < kLittleRoom) {
    return fmt::format("{} is nearly full: {}", folder.string(), remedy);
  }
  return {};
}

}  // namespace

Check checkDevice() {
  const Json machine = aboutMachine();
  const auto device = machine["device"].get<std::string>(), structure = machine["structure"].get<std::string>();
  Check check{"device",
              Finding::Ok,
              fmt::format("{}, structure {}, {}", device, structure, machine["processor"].get<std::string>()),
              {}};
  const bool slow = device == "ref" || structure == "none";
  if (!slow && device != "null") return check;
  check.finding = Finding::Note;
  check.advice = slow ? "every ray tries every triangle: unset RAYCORE_DEVICE and RAYCORE_ACCEL for speed"
                      : "pictures have the clear colour only: unset RAYCORE_DEVICE";
  return check;
}

Check checkInstructions() {
  const auto set = aboutMachine()["instruction_set"].get<std::string>();
  if (set != "SSE2" && set != "scalar") return {"instructions", Finding::Ok, set, {}};
  return {"instructions", Finding::Note, set, "AVX2 or more would trace several times as fast"};
}

Check checkThreads() {
  const int threads = aboutMachine()["threads"].get<int>(), allowed = allowedProcessors();
  Check check{"threads", Finding::Ok, fmt::format("{}, processors allowed: {}", threads, allowed), {}};
  if (threads == allowed) return check;
  check.finding = Finding::Note;
  check.advice = fmt::format("RAYCORE_THREADS={} would use them as they are", allowed);
  return check;
}

Check checkFolders() {
  std::error_code error;
  const std::filesystem::path here = std::filesystem::current_path(error);
  const std::filesystem::path temporary = std::filesystem::temp_directory_path(error);
  const std::string wrongHere = trouble(here, "name a picture elsewhere, -o FOLDER/picture.png");
  const std::string wrongThere =
      error ? "TMPDIR names no folder: unset it" : trouble(temporary, "TMPDIR may name another folder");
  const std::string both = wrongHere + (wrongHere.empty() || wrongThere.empty() ? "" : "; ") + wrongThere;
  return {"folders", both.empty() ? Finding::Ok : Finding::Problem,
          fmt::format("this one and {}", temporary.empty() ? "none" : temporary.string()), both};
}

Check checkFilms() {
  try {
    checkFfmpeg();
    return {"films", Finding::Ok, "ffmpeg is installed", {}};
  } catch (const InputError &error) {
    return {"films", Finding::Note, "no ffmpeg", error.what()};
  }
}

Check checkLibraries() {
  const Json libraries = aboutLibraries();
  std::vector<std::string> texts;
  for (const auto &[name, version] : libraries.items()) texts.push_back(name + " " + version.get<std::string>());
  const std::string versions = fmt::format("{}", fmt::join(texts, ", "));
  try {
    codec();
    return {"libraries", Finding::Ok, versions, {}};
  } catch (const InputError &error) {
    return {"libraries", Finding::Problem, versions, error.what()};
  }
}

}  // namespace rc::tool
