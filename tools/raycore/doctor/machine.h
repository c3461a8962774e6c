// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// machine.h: what traces: processor, instruction set, threads, device, versions of libraries.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace rc::tool {

using Json = nlohmann::ordered_json;

Json aboutMachine();
// "AMD EPYC, 2 threads, cpu, bvh"
std::string describe(const Json &machine);

// Versions of what the tool and the library are made of.
Json aboutLibraries();

}  // namespace rc::tool
