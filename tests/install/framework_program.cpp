// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// The smallest program of the framework: main comes from the library.
#include "RCFramework.h"

class Program : public RCFramework {
 public:
  Program() : RCFramework("Consumer", 800, 480) {}

 protected:
  BOOL OnIntialize() {
    rcClearColor(0.2f, 0.4f, 0.6f, 1);
    return TRUE;
  }
};

Program g_program;
