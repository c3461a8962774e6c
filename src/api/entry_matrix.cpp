// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: transforms. [spec 3.2; G 3]
#include "RC/rc.h"
#include "api/convert.h"
#include "api/guard.h"

using namespace rc;
using namespace rc::api;

namespace {

Mat4 loadMatrix(const float *columns) {
  Mat4 matrix;
  for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = columns[i];
  return matrix;
}

// Axes of this length or less turn nothing. [reference 1.3]
constexpr double kShortestAxis = 1e-4;

// Counter-clockwise by `angle` degrees about the axis; in double, so that quarter turns are exact to float.
Mat4 rotation(double angle, double x, double y, double z) {
  const double length = std::sqrt(x * x + y * y + z * z);
  if (!(length > kShortestAxis)) return Mat4(1);
  return Mat4(glm::rotate(glm::dmat4(1), glm::radians(angle), glm::dvec3(x, y, z) / length));
}

template <class MakeMatrix>
void multiply(const char *function, MakeMatrix &&makeMatrix) {
  enter(function, [&](Context &context) {
    Mat4 &current = context.state.matrices.current().current();
    current = current * makeMatrix();
  });
}

template <class MakeMatrix>
void load(const char *function, MakeMatrix &&makeMatrix) {
  enter(function, [&](Context &context) { context.state.matrices.current().current() = makeMatrix(); });
}

}  // namespace

extern "C" {

void rcMatrixMode(RCenum mode) {
  enter("rcMatrixMode", [&](Context &context) {
    if (mode == RC_MATRIX_PALETTE_OES) return context.fail(RC_INVALID_OPERATION, "the matrix palette is not enabled");
    if (mode != RC_MODELVIEW && mode != RC_PROJECTION && mode != RC_TEXTURE) {
      return context.fail(RC_INVALID_ENUM, "mode 0x%04X is not a matrix mode", mode);
    }
    context.state.matrices.mode = mode;
  });
}

void rcLoadIdentity(void) {
  load("rcLoadIdentity", [] { return Mat4(1); });
}

void rcLoadMatrixf(const RCfloat *m) {
  if (m) load("rcLoadMatrixf", [&] { return loadMatrix(m); });
}

void rcLoadMatrixx(const RCfixed *m) {
  if (m) load("rcLoadMatrixx", [&] { return loadMatrix(fromFixed<16>(m).data()); });
}

void rcMultMatrixf(const RCfloat *m) {
  if (m) multiply("rcMultMatrixf", [&] { return loadMatrix(m); });
}

void rcMultMatrixx(const RCfixed *m) {
  if (m) multiply("rcMultMatrixx", [&] { return loadMatrix(fromFixed<16>(m).data()); });
}

void rcTranslatef(RCfloat x, RCfloat y, RCfloat z) {
  multiply("rcTranslatef", [&] { return glm::translate(Mat4(1), Vec3(x, y, z)); });
}

void rcTranslatex(RCfixed x, RCfixed y, RCfixed z) {
  multiply("rcTranslatex", [&] { return glm::translate(Mat4(1), Vec3(fromFixed(x), fromFixed(y), fromFixed(z))); });
}

void rcRotatef(RCfloat angle, RCfloat x, RCfloat y, RCfloat z) {
  multiply("rcRotatef", [&] { return rotation(angle, x, y, z); });
}

void rcRotatex(RCfixed angle, RCfixed x, RCfixed y, RCfixed z) {
  multiply("rcRotatex", [&] { return rotation(fromFixed(angle), fromFixed(x), fromFixed(y), fromFixed(z)); });
}

void rcScalef(RCfloat x, RCfloat y, RCfloat z) {
  multiply("rcScalef", [&] { return glm::scale(Mat4(1), Vec3(x, y, z)); });
}

void rcScalex(RCfixed x, RCfixed y, RCfixed z) {
  multiply("rcScalex", [&] { return glm::scale(Mat4(1), Vec3(fromFixed(x), fromFixed(y), fromFixed(z))); });
}

void rcPushMatrix(void) {
  enter("rcPushMatrix", [](Context &context) {
    if (!context.state.matrices.current().push()) {
      context.fail(RC_STACK_OVERFLOW, "the stack holds %d matrices and is full", MatrixStack::kDepth);
    }
  });
}

void rcPopMatrix(void) {
  enter("rcPopMatrix", [](Context &context) {
    if (!context.state.matrices.current().pop()) context.fail(RC_STACK_UNDERFLOW, "nothing was pushed");
  });
}

}  // extern "C"
