// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// named_load.h: loading as commands do it: complaints begin with the file's name, notes go to stderr.
#pragma once

#include <string>

#include "scene/scene.h"

namespace rc::tool {

struct LoadOptions {
  bool quiet = false, verbose = false;
};

Scene loadNamed(const std::string &file);
// What was dropped or approximated: one thing, or how many; all where verbose.
void printNotes(const std::string &file, const Scene &scene, const LoadOptions &options);

}  // namespace rc::tool
