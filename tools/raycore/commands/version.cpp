// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// raycore version, raycore devices.
#include <RC/rc.h>
#include <fmt/format.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <thread>

#include "commands/commands.h"
#include "draw/target.h"

namespace rc::tool {
namespace {

constexpr const char *kVersion = RAYCORE_VERSION;

using Json = nlohmann::ordered_json;

std::string stringOf(RCenum name) { return reinterpret_cast<const char *>(rcGetString(name)); }

std::string environment(const char *name, const std::string &missing) {
  const char *value = std::getenv(name);
  return value && *value ? value : missing;
}

int integerOf(RCenum name) {
  RCint value = 0;
  rcGetIntegerv(name, &value);
  return value;
}

Json aboutVersion() {
  const Target target(16, 16);
  return {{"raycore", kVersion},
          {"library", stringOf(RC_VERSION)},
          {"vendor", stringOf(RC_VENDOR)},
          {"egl", eglQueryString(eglGetDisplay(EGL_DEFAULT_DISPLAY), EGL_VERSION)}};
}

// The API names one renderer; which device of the library stands behind it is the environment's choice.
Json aboutDevice() {
  const Target target(16, 16);
  return {{"renderer", stringOf(RC_RENDERER)},
          {"device", environment("RAYCORE_DEVICE", "default")},
          {"threads", environment("RAYCORE_THREADS", std::to_string(std::thread::hardware_concurrency()))},
          {"structure", environment("RAYCORE_ACCEL", "default")},
          {"profile", environment("RAYCORE_PROFILE", "guide")},
          {"lights", integerOf(RC_MAX_LIGHTS)},
          {"materials", integerOf(RC_MAX_MATERIALS)},
          {"palette matrices", integerOf(RC_MAX_PALETTE_MATRICES_OES)}};
}

int show(const Json &json, bool asJson) {
  if (asJson) {
    fmt::print("{}\n", json.dump(2));
    return 0;
  }
  for (const auto &[key, value] : json.items()) {
    fmt::print("{:<17} {}\n", key, value.is_string() ? value.get<std::string>() : value.dump());
  }
  return 0;
}

Command add(CLI::App &app, const char *name, const char *what, Json (*about)()) {
  CLI::App *command = app.add_subcommand(name, what);
  auto asJson = std::make_shared<bool>(false);
  command->add_flag("--json", *asJson, "Print JSON");
  command->footer(fmt::format("Example:\n  raycore {} --json", name));
  return {command, [=] { return show(about(), *asJson); }};
}

}  // namespace

const char *versionText() { return "raycore " RAYCORE_VERSION; }

Command addVersion(CLI::App &app) { return add(app, "version", "Versions of the tool and the library", aboutVersion); }

Command addDevices(CLI::App &app) { return add(app, "devices", "What traces, and its limits", aboutDevice); }

}  // namespace rc::tool
