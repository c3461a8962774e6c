// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "images/run_example.h"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

namespace rc::test {
namespace {

// A folder of this process, removed at its end.
const std::filesystem::path &scratch() {
  struct Folder {
    std::filesystem::path path = std::filesystem::temp_directory_path() / ("raycore-" + std::to_string(getpid()));
    Folder() { std::filesystem::create_directories(path); }
    ~Folder() {
      std::error_code ignored;
      std::filesystem::remove_all(path, ignored);
    }
  };
  static const Folder folder;
  return folder.path;
}

}  // namespace

ExampleRun runExample(const std::string &name, int frames, const std::string &environment,
                      const std::string &arguments) {
  const std::string file = (scratch() / (name + ".png")).string();
  std::remove(file.c_str());
  const std::string command = "env -u DISPLAY RAYCORE_FRAMES=" + std::to_string(frames) + " RAYCORE_CAPTURE='" + file +
                              "' " + environment + " " + RAYCORE_EXAMPLES_DIR + "/" + name + " " + arguments + " 2>&1";
  ExampleRun run;
  std::FILE *pipe = popen(command.c_str(), "r");
  if (!pipe) return run;
  std::array<char, 4096> block;
  for (size_t n; (n = std::fread(block.data(), 1, block.size(), pipe)) > 0;) run.output.append(block.data(), n);
  const int status = pclose(pipe);
  run.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : 128;
  run.picture = readPng(file);
  return run;
}

}  // namespace rc::test
