// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// raycore version, raycore devices.
#include <RC/rc.h>
#include <fmt/format.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "commands/commands.h"
#include "doctor/machine.h"
#include "draw/target.h"

namespace rc::tool {
namespace {

constexpr const char *kVersion = RAYCORE_VERSION;

std::string stringOf(RCenum name) { return reinterpret_cast<const char *>(rcGetString(name)); }

std::string profile() {
  const char *value = std::getenv("RAYCORE_PROFILE");
  return value && *value ? value : "guide";
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
          {"egl", eglQueryString(eglGetDisplay(EGL_DEFAULT_DISPLAY), EGL_VERSION)},
          {"libraries", aboutLibraries()}};
}

// The API names one renderer; which device of the library stands behind it is the environment's choice.
Json aboutDevice() {
  const Target target(16, 16);
  Json json{{"renderer", stringOf(RC_RENDERER)}};
  json.update(aboutMachine());
  json.update(Json{{"profile", profile()},
                   {"lights", integerOf(RC_MAX_LIGHTS)},
                   {"materials", integerOf(RC_MAX_MATERIALS)},
                   {"palette_matrices", integerOf(RC_MAX_PALETTE_MATRICES_OES)}});
  return json;
}

void print(const Json &json, const std::string &before = "") {
  for (const auto &[key, value] : json.items()) {
    if (value.is_object()) {
      print(value, key + " ");
    } else {
      fmt::print("{:<24} {}\n", before + key, value.is_string() ? value.get<std::string>() : value.dump());
    }
  }
}

int show(const Json &json, bool asJson) {
  if (asJson) {
    fmt::print("{}\n", json.dump(2));
  } else {
    print(json);
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
