// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// completions.h: what shells need to complete the command, and its manual page.
#pragma once

#include <string>

#include "commands/outline.h"

namespace rc::tool {

std::string bashCompletion(const Outline &outline);
std::string zshCompletion(const Outline &outline);
std::string fishCompletion(const Outline &outline);
std::string manualPage(const Outline &outline);

}  // namespace rc::tool
