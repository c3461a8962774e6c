// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Chapter 2.5 a: a frustum from an angle and the proportions of the window: nothing is distorted.
#include "common/triangle_program.h"

class Tutorial : public TriangleProgram {
 public:
  Tutorial() : TriangleProgram("Chapter 2.5 a: perspective") {}

 protected:
  void setCamera() override {
    rcuPerspective(60.0f, 800.0f / 480.0f, 0.1f, 100.0f);
    rcuLookAt(0, 0, 1, 0, 0, 0, 0, 1, 0);
  }

  void placeTriangle() override { rcTranslatef(0, 0, -3); }
};

Tutorial g_Tutorial;
