// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// load_options.h: how much is said of a model, for every command that loads one.
#pragma once

#include <CLI/CLI.hpp>

#include "load/named_load.h"

namespace rc::tool {

void addLoadOptions(CLI::App &command, LoadOptions &options);

}  // namespace rc::tool
