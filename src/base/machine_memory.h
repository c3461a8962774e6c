// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// machine_memory.h: how much memory this process may have at all.
#pragma once

#include <cstdint>
#include <string>

namespace rc {

// The least limit of a control group and those it lies in. root: where groups are mounted; membership: the text of
// /proc/self/cgroup. UINT64_MAX where there is none. Pure but for the files below root, for tests.
uint64_t groupMemoryLimit(const std::string &root, const std::string &membership);

// Three quarters of what the machine has, or of what the process's control group allows if that is less.
uint64_t defaultMemoryLimit();

}  // namespace rc
