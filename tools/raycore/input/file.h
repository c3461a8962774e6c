// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// file.h: bytes of files.
#pragma once

#include <string>

namespace rc::tool {

// Throws InputError: missing, a folder, not readable.
std::string readFile(const std::string &name);

// Lower case, with its dot; empty if there is none.
std::string extensionOf(const std::string &name);

}  // namespace rc::tool
