// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// switches.h: the table of what rcEnable and rcDisable switch. [reference 4.3]
#pragma once

#include "api/context.h"

namespace rc::api {

// Null for names that are no switch.
bool *findSwitch(Context &context, RCenum cap);

}  // namespace rc::api
