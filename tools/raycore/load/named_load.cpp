// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "load/named_load.h"

#include "input/error.h"
#include "load/load.h"

namespace rc::tool {

Scene loadNamed(const std::string &file) {
  try {
    return loadModel(file);
  } catch (const InputError &error) {
    reject("{}: {}", file, error.what());
  }
}

void printNotes(const std::string &file, const Scene &scene, const LoadOptions &options) {
  if (options.quiet || scene.notes.empty()) return;
  if (!options.verbose && scene.notes.size() > 1) {
    fmt::print(stderr, "raycore: {}: {} things dropped or approximated (-v lists them)\n", file, scene.notes.size());
    return;
  }
  for (const std::string &note : scene.notes) fmt::print(stderr, "raycore: {}: {}\n", file, note);
}

}  // namespace rc::tool
