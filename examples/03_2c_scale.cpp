// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Chapter 3.2 c: the triangle grows to twice its size along x and y.
#include "common/triangle_program.h"

class Tutorial : public TriangleProgram {
 public:
  Tutorial() : TriangleProgram("Chapter 3.2 c: scale") {}

 protected:
  void placeTriangle() override { rcScalef(2, 2, 1); }
};

Tutorial g_Tutorial;
