// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Chapter 3.2 e: first moved by 1 along x, then turned by 90 degrees: it ends up above the origin.
#include "common/triangle_program.h"

class Tutorial : public TriangleProgram {
 public:
  Tutorial() : TriangleProgram("Chapter 3.2 e: translate, then rotate") {}

 protected:
  void placeTriangle() override {
    rcRotatef(90, 0, 0, 1);
    rcTranslatef(1, 0, 0);
  }
};

Tutorial g_Tutorial;
