// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// run_example.h: runs a program of examples/ without a display and hands over its last picture.
#pragma once

#include <string>

#include "images/picture.h"

namespace rc::test {

struct ExampleRun {
  int exitCode = -1;
  std::string output;  // stdout and stderr
  Picture picture;     // empty if none was written
};

// environment: "NAME=value ..." for the shell, on top of RAYCORE_FRAMES=frames.
ExampleRun runExample(const std::string &name, int frames, const std::string &environment = {},
                      const std::string &arguments = {});

}  // namespace rc::test
