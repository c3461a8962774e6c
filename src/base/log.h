// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// log.h: messages on stderr, one line each, "raycore: ...".
// RAYCORE_LOG=off|warning|error|frame|debug says how much; each level contains those before it.
//   warning (the default)  what a user must know: a bad setting, a file that cannot be written
//   error                  each failing API call with its reason
//   frame                  one line for each traced frame
//   debug                  everything else
#pragma once

namespace rc {

enum class LogLevel { Off, Warning, Error, Frame, Debug };

bool logEnabled(LogLevel level);

[[gnu::format(printf, 2, 3)]] void log(LogLevel level, const char *format, ...);

}  // namespace rc
