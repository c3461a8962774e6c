// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "api/functions.h"

#include <algorithm>

namespace rc::api {
namespace {

constexpr FunctionRow kFunctions[] = {
#define RC_FUNCTION(result, name, parameters, effect, source, errors, note) \
  {#result, #name, #parameters, Effect::effect, source, errors, note},
#include "api/functions.inc"
#undef RC_FUNCTION
};

}  // namespace

std::span<const FunctionRow> functions() { return kFunctions; }

const FunctionRow *findFunction(std::string_view name) {
  const auto *found = std::find_if(std::begin(kFunctions), std::end(kFunctions),
                                   [&](const FunctionRow &row) { return row.name == name; });
  return found == std::end(kFunctions) ? nullptr : found;
}

}  // namespace rc::api
