// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Chapter 3.2 d: first turned by 90 degrees, then moved by 1 along x: calls act in the reverse of their order.
#include "common/triangle_program.h"

class Tutorial : public TriangleProgram {
 public:
  Tutorial() : TriangleProgram("Chapter 3.2 d: rotate, then translate") {}

 protected:
  void placeTriangle() override {
    rcTranslatef(1, 0, 0);
    rcRotatef(90, 0, 0, 1);
  }
};

Tutorial g_Tutorial;
