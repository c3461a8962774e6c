// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// show_options.h: the options of a picture, for every command that makes one.
#pragma once

#include <CLI/CLI.hpp>

#include "draw/show.h"

namespace rc::tool {

// A number, not an infinity, and none that is no number.
CLI::Validator finite();
// Size, samples, bounces.
void addPictureSize(CLI::App &command, ShowSettings &settings);
void addShowOptions(CLI::App &command, ShowSettings &settings);

}  // namespace rc::tool
