// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// The main of programs that have none of their own. [spec 6]
#include "RCFramework.h"

int main(int argc, char **argv) {
  RCFramework *program = RCFramework::Instance();
  if (!program) {
    fprintf(stderr, "RCFramework: the program has no global object of a class derived from RCFramework\n");
    return EXIT_FAILURE;
  }
  if (program->Initialize(argc, argv)) {
    while (program->DrawScene()) {
    }
  }
  program->Release();
  return program->Failed() ? EXIT_FAILURE : EXIT_SUCCESS;
}
