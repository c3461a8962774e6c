// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// program.h: what another program prints, line by line.
#pragma once

#include <cstdio>
#include <string>

namespace rc::bench {

// visit(line), with its end, for each that the command writes to either output; none if it cannot be run.
template <class Visit>
void forEachLineOf(const std::string &command, Visit &&visit) {
  std::FILE *output = popen((command + " 2>&1").c_str(), "r");
  if (!output) return;
  char line[256];
  while (std::fgets(line, sizeof line, output)) visit(line);
  pclose(output);
}

}  // namespace rc::bench
