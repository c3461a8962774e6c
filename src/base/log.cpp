// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "base/log.h"

#include <cstdarg>
#include <cstdio>

#include "base/settings.h"

namespace rc {

bool logEnabled(LogLevel level) { return level <= settings().log; }

void log(LogLevel level, const char *format, ...) {
  if (!logEnabled(level)) return;
  char line[1024];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(line, sizeof line, format, arguments);
  va_end(arguments);
  std::fprintf(stderr, "raycore: %s\n", line);  // one call, so that lines of several threads do not mix
}

}  // namespace rc
