// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// tokens.h: names of the error codes, for messages.
#pragma once

#include "RC/rctokens.h"
#include "RC/rctypes.h"

namespace rc::api {

inline const char *errorName(RCenum error) {
  struct Row {
    RCenum value;
    const char *name;
  };
  static constexpr Row kErrors[] = {
      {RC_NO_ERROR, "RC_NO_ERROR"},
      {RC_INVALID_ENUM, "RC_INVALID_ENUM"},
      {RC_INVALID_VALUE, "RC_INVALID_VALUE"},
      {RC_INVALID_OPERATION, "RC_INVALID_OPERATION"},
      {RC_STACK_OVERFLOW, "RC_STACK_OVERFLOW"},
      {RC_STACK_UNDERFLOW, "RC_STACK_UNDERFLOW"},
      {RC_OUT_OF_MEMORY, "RC_OUT_OF_MEMORY"},
  };
  for (const Row &row : kErrors) {
    if (row.value == error) return row.name;
  }
  return "an unknown error";
}

}  // namespace rc::api
