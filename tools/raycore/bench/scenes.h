// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// scenes.h: the standard scenes of `raycore bench`. They must not change: numbers of different versions are compared.
#pragma once

#include <span>
#include <string>

#include "draw/show.h"

namespace rc::tool {

struct BenchScene {
  const char *name, *what;
  Scene (*make)();
  ShowSettings (*settings)();  // what differs from the usual view
};

std::span<const BenchScene> builtInScenes();

// Files of the test set that belong to the bench, as places in its folder.
std::span<const char *const> filesOfTheSet();

}  // namespace rc::tool
