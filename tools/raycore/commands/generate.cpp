// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// raycore generate: completions for shells and the manual page, from the options themselves.
#include <fmt/format.h>

#include <map>
#include <memory>

#include "commands/commands.h"
#include "commands/completions.h"

namespace rc::tool {
namespace {

using Generator = std::string (*)(const Outline &outline);

const std::map<std::string, Generator> kGenerators{
    {"bash", bashCompletion}, {"zsh", zshCompletion}, {"fish", fishCompletion}, {"man", manualPage}};

}  // namespace

Command addGenerate(CLI::App &app) {
  CLI::App *command = app.add_subcommand("generate", "Completions for a shell, or the manual page");
  auto kind = std::make_shared<std::string>();
  std::vector<std::string> kinds;
  kinds.reserve(kGenerators.size());
  for (const auto &[name, generator] : kGenerators) kinds.push_back(name);
  command->add_option("kind", *kind, "bash, zsh, fish or man")->required()->check(CLI::IsMember(kinds));
  command->footer(
      "Examples:\n  source <(raycore generate bash)\n  raycore generate man | man -l -\n"
      "An installation has them in their places.");
  return {command, [&app, kind] {
            fmt::print("{}", kGenerators.at(*kind)(outlineOf(app)));
            return 0;
          }};
}

}  // namespace rc::tool
