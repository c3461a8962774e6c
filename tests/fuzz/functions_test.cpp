// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// The table of fuzz_api: every function that leaves the library is in it, and each has a code of its own.
#include "calls/functions.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <set>
#include <sstream>
#include <string>

namespace rc::fuzz {
namespace {

std::set<std::string> exportedNames() {
  std::set<std::string> names;
  std::FILE *output = popen(RAYCORE_NM " -D --defined-only " RAYCORE_LIBRARY, "r");
  if (!output) return names;
  char line[512];
  while (std::fgets(line, sizeof line, output)) {
    std::istringstream words(line);
    std::string address, kind, name;
    words >> address >> kind >> name;
    names.insert(name.substr(0, name.find('@')));
  }
  pclose(output);
  return names;
}

std::set<std::string> namesInTable() {
  std::set<std::string> names;
  for (const Function &function : functions()) names.insert(function.name);
  return names;
}

TEST(FuzzApi, CallsEveryFunctionThatTheLibraryExports) {
  const std::set<std::string> exported = exportedNames(), called = namesInTable();
  EXPECT_GT(exported.size(), 300u);
  for (const std::string &name : exported) EXPECT_TRUE(called.contains(name)) << name;
}

TEST(FuzzApi, EachFunctionHasACodeOfItsOwn) {
  for (const Function &function : functions()) EXPECT_STREQ(functionOf(codeOf(function.name)).name, function.name);
}

TEST(FuzzApi, CallsOfItsOwnStandForFunctionsThatThereAre) {
  const std::set<std::string> called = namesInTable();
  for (const std::span<const Function> own : {sizedCalls(), eglCalls()}) {
    for (const Function &function : own) EXPECT_TRUE(called.contains(function.name)) << function.name;
  }
}

}  // namespace
}  // namespace rc::fuzz
