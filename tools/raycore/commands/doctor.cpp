// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// raycore doctor: one line for each thing that programs need, with what helps where something is wrong.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "commands/commands.h"
#include "doctor/checks.h"

namespace rc::tool {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char *kWords[] = {"ok", "note", "problem"};

const char *wordOf(const Check &check) { return kWords[static_cast<int>(check.finding)]; }

void print(const std::vector<Check> &checks) {
  for (const Check &check : checks) {
    fmt::print("{:<8} {:<14} {}{}{}\n", wordOf(check), check.name, check.found, check.advice.empty() ? "" : ": ",
               check.advice);
  }
}

Json jsonOf(const std::vector<Check> &checks, bool well) {
  Json list = Json::array();
  for (const Check &check : checks) {
    list.push_back({{"name", check.name}, {"state", wordOf(check)}, {"found", check.found}, {"advice", check.advice}});
  }
  return {{"ok", well}, {"checks", list}};
}

int doctor(bool asJson) {
  const std::vector<Check> checks = examine();
  const bool well =
      std::none_of(checks.begin(), checks.end(), [](const Check &check) { return check.finding == Finding::Problem; });
  if (asJson) {
    fmt::print("{}\n", jsonOf(checks, well).dump(2, ' ', false, Json::error_handler_t::replace));
  } else {
    print(checks);
  }
  return well ? 0 : 1;
}

}  // namespace

Command addDoctor(CLI::App &app) {
  CLI::App *command = app.add_subcommand("doctor", "What works on this machine, and what to do where it does not");
  auto asJson = std::make_shared<bool>(false);
  command->add_flag("--json", *asJson, "Print JSON");
  command->footer(
      "Examples:\n  raycore doctor\n  raycore doctor --json\n"
      "A note is something that works with less than there could be. Exit code 1: there is a problem.");
  return {command, [asJson] { return doctor(*asJson); }};
}

}  // namespace rc::tool
