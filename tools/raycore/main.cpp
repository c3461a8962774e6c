// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// raycore: renders and inspects models. Exit codes: 0 done, 1 bad input or output, 2 wrong usage.
#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <iterator>
#include <new>

#include "commands/commands.h"
#include "input/error.h"

namespace {

using namespace rc::tool;

constexpr int kBadInput = 1, kWrongUsage = 2;

constexpr const char *kFooter =
    "Examples:\n"
    "  raycore render duck.glb -o duck.png\n"
    "  raycore render fox.glb -o walk.mp4 --animation Walk --fps 30\n"
    "  raycore view fox.glb --play\n"
    "  raycore info scene.gltf --json\n"
    "Exit codes: 0 done, 1 bad input or output, 2 wrong usage, 130 interrupted.\n"
    "RAYCORE_DEVICE, RAYCORE_THREADS, RAYCORE_ACCEL and RAYCORE_LOG choose how the library traces.";

// Whatever goes wrong is said in one line.
template <class Action>
int guarded(Action &&action) {
  try {
    return action();
  } catch (const UsageError &error) {
    std::fprintf(stderr, "raycore: %s\n", error.what());
    return kWrongUsage;
  } catch (const std::bad_alloc &) {
    std::fprintf(stderr, "raycore: there is not enough memory\n");
  } catch (const std::exception &error) {
    std::fprintf(stderr, "raycore: %s\n", error.what());
  }
  return kBadInput;
}

// One line that says which command was meant and what is wrong, and one that helps.
int refuse(const CLI::App &app, const CLI::Error &error, const std::string &first) {
  const std::vector<CLI::App *> chosen = app.get_subcommands();
  const std::string command = chosen.empty() ? "raycore" : "raycore " + chosen.front()->get_name();
  std::string wrong = error.what();
  std::vector<std::string> rest = app.remaining();  // before the command
  if (!chosen.empty()) std::ranges::copy(chosen.front()->remaining(), std::back_inserter(rest));
  // CLI11 names them from behind: a value before the option it was meant for. What is missing may be misspelt.
  const bool missing = dynamic_cast<const CLI::RequiredError *>(&error);
  if (!rest.empty() && (missing || dynamic_cast<const CLI::ExtrasError *>(&error))) {
    wrong = fmt::format("not understood: {}{}", fmt::join(rest, " "), missing ? "; " + wrong : "");
  }
  if (chosen.empty() && !first.empty() && first[0] != '-') wrong = "there is no command \"" + first + "\"";
  std::fprintf(stderr, "%s: %s\n%s --help tells more\n", command.c_str(), wrong.c_str(), command.c_str());
  return kWrongUsage;
}

int parseAndRun(int argc, char **argv) {
  CLI::App app{"Renders and inspects 3D models with the RayCore ray tracing API.", "raycore"};
  app.require_subcommand(1);
  app.footer(kFooter);
  app.set_version_flag("--version", versionText());
  const Command commands[] = {addRender(app), addView(app),    addInfo(app),    addStats(app),   addBench(app),
                              addDoctor(app), addDevices(app), addVersion(app), addGenerate(app)};
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError &error) {
    return error.get_exit_code() == 0 ? app.exit(error) : refuse(app, error, argc > 1 ? argv[1] : "");
  }
  for (const Command &command : commands) {
    if (command.app->parsed()) return command.run();
  }
  return kWrongUsage;
}

}  // namespace

int main(int argc, char **argv) {
  std::signal(SIGPIPE, SIG_IGN);  // a reader that has gone is an error of writing
  const int code = guarded([&] { return parseAndRun(argc, argv); });
  if (std::fflush(stdout) == 0 && !std::ferror(stdout)) return code;
  if (code == 0) std::fputs("raycore: standard output cannot be written\n", stderr);
  return code == 0 ? kBadInput : code;
}
