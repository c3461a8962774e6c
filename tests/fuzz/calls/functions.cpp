// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "calls/functions.h"

#include <algorithm>
#include <map>

#include "egl/vendor_calls.h"

using Text = const RCubyte *;
extern "C" {
#define GL_FUNCTION(result, name, parameters, arguments) result name parameters;
#include "gl/functions.inc"
#undef GL_FUNCTION
}

namespace rc::fuzz {
namespace {

// Functions are found by name, as programs find those of extensions.
template <class Pointer>
void callNamed(const Site &site) {
  const auto function = reinterpret_cast<Pointer>(eglGetProcAddress(site.function.data()));
  callWith(site, function);
}

#define RC_ENTRY(name) {#name, callNamed<decltype(&name)>},
#define RC_FUNCTION(result, name, ...) RC_ENTRY(name)
#define RC_EXTENSION(name, implementation) RC_ENTRY(name)
#define GL_FUNCTION(result, name, parameters, arguments) RC_ENTRY(name)
constexpr Function kGeneric[] = {
#include "api/functions.inc"
#include "egl/entry_points.inc"
#include "egl/extension_points.inc"
#include "gl/functions.inc"
};

std::vector<Function> makeTable() {
  std::vector<Function> all(std::begin(kGeneric), std::end(kGeneric));
  for (const std::span<const Function> own : {sizedCalls(), eglCalls()}) {
    for (const Function &row : own) {
      const auto same = [&](const Function &other) { return std::string_view(other.name) == row.name; };
      const auto place = std::find_if(all.begin(), all.end(), same);
      if (place != all.end()) place->call = row.call;
    }
  }
  return all;
}

constexpr std::string_view kSixteen[] = {"rcLoadMatrixf", "rcLoadMatrixx", "rcMultMatrixf", "rcMultMatrixx",
                                         "rcGetBooleanv", "rcGetFixedv",   "rcGetFloatv",   "rcGetIntegerv"};

}  // namespace

size_t Site::valuesBehindPointer() const {
  if (std::find(std::begin(kSixteen), std::end(kSixteen), function) != std::end(kSixteen)) return 16;
  const bool single = isEgl() || function.find("TexParameter") != function.npos || function == "rcGetBufferParameteriv";
  return single ? 1 : 4;
}

std::span<const Function> functions() {
  static const std::vector<Function> table = makeTable();
  return table;
}

// FNV-1a, the upper half: no two names have the same.
uint16_t codeOf(std::string_view name) {
  uint32_t hash = 2166136261u;
  for (const char c : name) hash = (hash ^ uint8_t(c)) * 16777619u;
  return uint16_t(hash >> 16);
}

// Other numbers mean some function too.
const Function &functionOf(uint16_t code) {
  static const auto byCode = [] {
    std::map<uint16_t, const Function *> map;
    for (const Function &row : functions()) map.emplace(codeOf(row.name), &row);
    return map;
  }();
  const auto found = byCode.find(code);
  return found != byCode.end() ? *found->second : functions()[code % functions().size()];
}

}  // namespace rc::fuzz
