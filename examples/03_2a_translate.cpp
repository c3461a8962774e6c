// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Chapter 3.2 a: the triangle moves by 1 along x and y.
#include "common/triangle_program.h"

class Tutorial : public TriangleProgram {
 public:
  Tutorial() : TriangleProgram("Chapter 3.2 a: translate") {}

 protected:
  void placeTriangle() override { rcTranslatef(1, 1, 0); }
};

Tutorial g_Tutorial;
