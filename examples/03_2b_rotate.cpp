// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Chapter 3.2 b: the triangle turns by 45 degrees about z.
#include "common/triangle_program.h"

class Tutorial : public TriangleProgram {
 public:
  Tutorial() : TriangleProgram("Chapter 3.2 b: rotate") {}

 protected:
  void placeTriangle() override { rcRotatef(45, 0, 0, 1); }
};

Tutorial g_Tutorial;
