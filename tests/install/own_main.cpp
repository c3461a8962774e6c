// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// A program that links the framework and has a main of its own.
#include "RCFramework.h"

class Program : public RCFramework {
 public:
  Program() : RCFramework("Consumer", 800, 480) {}
};

int main(int argc, char **argv) {
  static Program program;
  if (program.Initialize(argc, argv)) {
    while (program.DrawScene()) {
    }
  }
  program.Release();
  return program.Failed();
}
