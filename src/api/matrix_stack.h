// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// matrix_stack.h: one of the matrix stacks; there is always a current matrix. [spec 3.2]
#pragma once

#include <vector>

#include "base/vec.h"

namespace rc::api {

class MatrixStack {
 public:
  static constexpr int kDepth = 32;

  const Mat4 &current() const { return mMatrices.back(); }
  Mat4 &current() { return mMatrices.back(); }
  int depth() const { return static_cast<int>(mMatrices.size()); }  // 1 where nothing is saved

  bool push() {
    if (depth() == kDepth) return false;
    mMatrices.push_back(Mat4(mMatrices.back()));
    return true;
  }
  bool pop() {
    if (depth() == 1) return false;
    mMatrices.pop_back();
    return true;
  }

 private:
  std::vector<Mat4> mMatrices = std::vector<Mat4>(1, Mat4(1));  // a list of one upsets GCC 12 with 512-bit vectors
};

}  // namespace rc::api
