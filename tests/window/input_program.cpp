// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Shows in the colour of its picture what the framework told it: the mouse as (x, y, buttons), a key as (code,
// rendering hint, 1).
#include "RCFramework.h"

namespace {

class Input : public RCFramework {
 public:
  Input() : RCFramework("Input", 200, 100) {}

 protected:
  BOOL OnDraw() override { return TRUE; }
  void OnMouseEvent(float x, float y, DWORD buttons) override { rcClearColor(x, y, float(buttons) / 16, 1); }
  void OnKeyDown(char key) override {
    RCint hint = 0;
    rcGetIntegerv(RC_RENDERING_HINT, &hint);
    rcClearColor((float(key) + 0.5f) / 256, float(hint - RC_DONT_CARE) / 16, 1, 1);
  }
};

Input gInput;

}  // namespace
