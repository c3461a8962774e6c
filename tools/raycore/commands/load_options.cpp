// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "commands/load_options.h"

namespace rc::tool {

void addLoadOptions(CLI::App &command, LoadOptions &options) {
  CLI::Option *quiet = command.add_flag("-q,--quiet", options.quiet, "Errors alone");
  command.add_flag("-v,--verbose", options.verbose, "What was dropped or approximated, and times")->excludes(quiet);
}

}  // namespace rc::tool
