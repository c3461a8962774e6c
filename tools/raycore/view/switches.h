// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// switches.h: what a person changes about how the model is traced.
#pragma once

#include <string>

#include "draw/show.h"

namespace rc::tool {

class Switches {
 public:
  explicit Switches(int bounces) : mBounces(bounces) {}

  void changeBounces(int by);
  void toggleShadows() { mShadows = !mShadows; }
  void nextFilter();
  void nextStructure();
  // Into RayCore's state; a new structure is built.
  void apply(Show &show) const;
  // "10 bounces, shadows on, trilinear, BVH"
  std::string text() const;

 private:
  int mBounces;
  bool mShadows = true;
  size_t mFilter = 0, mStructure = 0;
};

}  // namespace rc::tool
