// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Chapter 2.5 c: the viewer moves 0.3 to the right and keeps looking at the origin.
#include "common/triangle_program.h"

class Tutorial : public TriangleProgram {
 public:
  Tutorial() : TriangleProgram("Chapter 2.5 c: look at") {}

 protected:
  void setCamera() override {
    rcuPerspective(60.0f, 800.0f / 480.0f, 0.1f, 100.0f);
    rcuLookAt(0.3f, 0, 1, 0, 0, 0, 0, 1, 0);
  }

  void placeTriangle() override { rcTranslatef(0, 0, -3); }
};

Tutorial g_Tutorial;
