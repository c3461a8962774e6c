// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// All headers as C++11, RCFramework.h included: a program of the framework's kind compiles.
#include <RC/rc.h>
#include <RC/rcu.h>
#include <RC1/rc1.h>

#include <type_traits>

#include "RCFramework.h"
#include "STDInterface.h"

static_assert(__cplusplus == 201103L, "this file tests C++11");

#define RC_TOKEN(name, value) static_assert((name) == (value), #name);
#include "headers/token_values.inc"
#undef RC_TOKEN

#define RC_PROTOTYPE(name, result, arguments) \
  static_assert(std::is_same<decltype(&name), result(RC_APIENTRY *) arguments>::value, #name);
#include "headers/prototypes.inc"
#undef RC_PROTOTYPE

namespace {

// Overrides what a program may override; never made, so that no window opens.
class Program : public RCFramework {
 public:
  Program() : RCFramework("Title", 800, 480) {}

 protected:
  BOOL OnIntialize() override { return TRUE; }
  void OnRelease() override {}
  BOOL OnDraw() override { return FALSE; }
  BOOL OnPostDraw() override { return TRUE; }
  void OnKeyDown(char) override {}
  void OnMouseEvent(float, float, DWORD) override {}
};

static_assert(std::is_base_of<RCFramework, Program>::value && !std::is_abstract<Program>::value,
              "a program need not define more");

}  // namespace

int main() { return rcGetError() == RC_NO_ERROR ? 0 : 1; }
