// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// tokens.h: names of tokens, for messages and the call tracer.
#pragma once

#include <string>
#include <string_view>

#include "RC/rctokens.h"
#include "RC/rctypes.h"

namespace rc::api {

// "RC_INVALID_ENUM"; never null.
const char *errorName(RCenum error);

// "RC_LIGHT3"; values that are no token in hexadecimal. The values below 8 have several names: `parameter`, the
// name of the parameter that carries the value, says which is meant.
std::string tokenName(RCenum value, std::string_view parameter);

// The text with its tokens in hexadecimal replaced by their names: "0x1208" becomes "RC_SPOT_CUTOFF".
std::string withTokenNames(std::string_view text);

}  // namespace rc::api
