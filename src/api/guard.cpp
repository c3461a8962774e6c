// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "api/guard.h"

#include <utility>

namespace rc::api {
namespace {
constinit thread_local bool tMissingContext = false;
}

void noteMissingContext() { tMissingContext = true; }

RCenum takeMissingContext() { return std::exchange(tMissingContext, false) ? RC_INVALID_OPERATION : RC_NO_ERROR; }

}  // namespace rc::api
