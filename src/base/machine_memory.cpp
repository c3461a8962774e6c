// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "base/machine_memory.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace rc {
namespace {

constexpr uint64_t kNone = UINT64_MAX;

std::string textOf(const std::string &path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

// "max", as an unlimited group says, and files that are not there are no number.
uint64_t numberIn(const std::string &path) {
  std::ifstream file(path);
  uint64_t value = 0;
  return file >> value ? value : kNone;
}

// The group's own limit and those of the groups around it.
uint64_t leastUpwards(const std::string &mount, std::string group, const char *file) {
  uint64_t least = kNone;
  for (;;) {
    least = std::min(least, numberIn(mount + group + "/" + file));
    const size_t slash = group.rfind('/');
    if (group.empty() || slash == std::string::npos) return least;
    group.resize(slash);
  }
}

}  // namespace

// Lines "0::/path" of version 2, "5:memory:/path" of version 1. [Linux, cgroups(7)]
uint64_t groupMemoryLimit(const std::string &root, const std::string &membership) {
  uint64_t least = kNone;
  std::istringstream lines(membership);
  for (std::string line; std::getline(lines, line);) {
    const size_t first = line.find(':'), second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos) continue;
    std::string controllers(1, ',');
    controllers.append(line, first + 1, second - first - 1).push_back(',');
    const std::string group = line.substr(second + 1) == "/" ? "" : line.substr(second + 1);
    if (controllers == ",,") least = std::min(least, leastUpwards(root, group, "memory.max"));
    if (controllers.find(",memory,") != std::string::npos) {
      least = std::min(least, leastUpwards(root + "/memory", group, "memory.limit_in_bytes"));
    }
  }
  return least;
}

uint64_t defaultMemoryLimit() {
  const long pages = sysconf(_SC_PHYS_PAGES), pageSize = sysconf(_SC_PAGESIZE);
  const uint64_t machine = pages > 0 && pageSize > 0 ? uint64_t(pages) * uint64_t(pageSize) : kNone;
  const uint64_t least = std::min(machine, groupMemoryLimit("/sys/fs/cgroup", textOf("/proc/self/cgroup")));
  return least == kNone ? kNone : least / 4 * 3;
}

}  // namespace rc
