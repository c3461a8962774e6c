// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "base/settings.h"

#include <strings.h>

#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>

namespace rc {
namespace {

template <class Value>
struct Choice {
  const char *name;
  Value value;
};

constexpr Choice<AccelKind> kAccelKinds[] = {
    {"kdtree", AccelKind::KdTree}, {"bvh", AccelKind::Bvh}, {"none", AccelKind::Exhaustive}};
constexpr Choice<LogLevel> kLogLevels[] = {{"off", LogLevel::Off},
                                           {"warning", LogLevel::Warning},
                                           {"error", LogLevel::Error},
                                           {"frame", LogLevel::Frame},
                                           {"debug", LogLevel::Debug}};
constexpr Choice<const char *> kProfiles[] = {{"guide", "guide"}, {"1000", "1000"}, {"mc", "mc"}};
constexpr Choice<const char *> kDevices[] = {{"cpu", "cpu"}, {"ref", "ref"}, {"null", "null"}};
constexpr Choice<const char *> kInstructionSetChoices[] = {
    {"baseline", "baseline"}, {"ssse3", "ssse3"}, {"sse4", "sse4"}, {"avx2", "avx2"}, {"avx512", "avx512"}};
constexpr Choice<bool> kSwitch[] = {{"0", false}, {"1", true}};

constexpr Choice<int> kByteUnits[] = {{"", 0}, {"K", 10}, {"M", 20}, {"G", 30}, {"T", 40}};

std::optional<uint64_t> parseBytes(const char *text) {
  if (!std::strcmp(text, "none")) return UINT64_MAX;
  double number = 0;
  const auto [rest, error] = std::from_chars(text, text + std::strlen(text), number, std::chars_format::fixed);
  if (error != std::errc()) return std::nullopt;
  for (const Choice<int> &unit : kByteUnits) {
    if (strcasecmp(unit.name, rest) != 0) continue;
    const double bytes = std::ldexp(number, unit.value);
    if (bytes >= 1 && bytes < 0x1p63) return static_cast<uint64_t>(bytes);
  }
  return std::nullopt;
}

class Reader {
 public:
  Reader(EnvironmentLookup lookup, std::string &report) : mLookup(lookup), mReport(report) {}

  template <class Target, class Value, size_t N>
  void choice(const char *name, const Choice<Value> (&choices)[N], Target &target) const {
    const char *text = mLookup(name);
    if (!text || !*text) return;
    std::string allowed;
    for (const Choice<Value> &choice : choices) {
      if (!std::strcmp(choice.name, text)) {
        target = choice.value;
        return;
      }
      allowed += allowed.empty() ? choice.name : std::string(", ") + choice.name;
    }
    complain(name, text, "it is one of " + allowed);
  }

  void number(const char *name, int lowest, int highest, int &target) const {
    const char *text = mLookup(name);
    if (!text || !*text) return;
    int value = 0;
    const char *end = text + std::strlen(text);
    const auto [rest, error] = std::from_chars(text, end, value);
    if (error != std::errc() || rest != end || value < lowest || value > highest) {
      complain(name, text, "it is a number from " + std::to_string(lowest) + " to " + std::to_string(highest));
      return;
    }
    target = value;
  }

  // Bytes, also as "512M" or "1.5G"; "none" is as good as everything.
  void bytes(const char *name, uint64_t &target) const {
    const char *text = mLookup(name);
    if (!text || !*text) return;
    if (const std::optional<uint64_t> value = parseBytes(text)) {
      target = *value;
    } else {
      complain(name, text, "it is a number of bytes above 0, as 512M or 1.5G, or none");
    }
  }

  void text(const char *name, std::string &target) const {
    if (const char *text = mLookup(name)) target = text;
  }

 private:
  void complain(const char *name, const char *text, const std::string &rule) const {
    mReport += std::string("raycore: ") + name + "=" + text + " is ignored: " + rule + "\n";
  }

  EnvironmentLookup mLookup;
  std::string &mReport;
};

}  // namespace

Settings readSettings(EnvironmentLookup lookup, std::string &report) {
  Settings settings;
  const Reader reader(lookup, report);
  reader.choice("RAYCORE_DEVICE", kDevices, settings.device);
  reader.number("RAYCORE_THREADS", 1, 1024, settings.threads);
  reader.choice("RAYCORE_ACCEL", kAccelKinds, settings.accel);
  reader.choice("RAYCORE_PROFILE", kProfiles, settings.profile);
  reader.choice("RAYCORE_INSTRUCTION_SET", kInstructionSetChoices, settings.instructionSet);
  reader.bytes("RAYCORE_MEMORY_LIMIT", settings.memoryLimit);
  reader.number("RAYCORE_SAMPLES", 1, 64, settings.samples);
  reader.choice("RAYCORE_PIPELINE", kSwitch, settings.pipeline);
  reader.number("RAYCORE_FRAMES", 1, 1000000000, settings.frames);
  reader.text("RAYCORE_CAPTURE", settings.capture);
  reader.choice("RAYCORE_LOG", kLogLevels, settings.log);
  reader.text("RAYCORE_TRACE", settings.trace);
  reader.choice("RAYCORE_TEST", kSwitch, settings.test);
  return settings;
}

const Settings &settings() {
  // Never destroyed: programs draw in destructors of globals.
  static const Settings &settings = *new Settings([] {
    std::string report;
    Settings read = readSettings([](const char *name) -> const char * { return std::getenv(name); }, report);
    std::fputs(report.c_str(), stderr);
    return read;
  }());
  return settings;
}

}  // namespace rc
