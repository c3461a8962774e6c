// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// commands.h: the subcommands. Each adds its options to the application; what it returns is run when it was chosen, and
// gives the exit code.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace rc::tool {

using Action = std::function<int()>;

struct Command {
  CLI::App *app;
  Action run;
};

Command addRender(CLI::App &app);
Command addView(CLI::App &app);
Command addInfo(CLI::App &app);
Command addStats(CLI::App &app);
Command addBench(CLI::App &app);
Command addGenerate(CLI::App &app);
Command addDoctor(CLI::App &app);
Command addDevices(CLI::App &app);
Command addVersion(CLI::App &app);

// What `version` says first.
const char *versionText();

}  // namespace rc::tool
