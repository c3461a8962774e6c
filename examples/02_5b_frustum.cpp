// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Chapter 2.5 b: a square frustum on a window that is wider than high: the picture is stretched.
#include "common/triangle_program.h"

class Tutorial : public TriangleProgram {
 public:
  Tutorial() : TriangleProgram("Chapter 2.5 b: frustum") {}

 protected:
  void setCamera() override {
    rcFrustumf(-0.1f, 0.1f, -0.1f, 0.1f, 0.1f, 100);
    rcuLookAt(0, 0, 1, 0, 0, 0, 0, 1, 0);
  }

  void placeTriangle() override { rcTranslatef(0, 0, -3); }
};

Tutorial g_Tutorial;
