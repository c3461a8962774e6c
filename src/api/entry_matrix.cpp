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

// The matrix that loads and products act on. In palette mode it is the current one of the palette, and an error
// once the palette is off.
Mat4 *loadTarget(Context &context) {
  State &state = context.state;
  if (state.matrices.mode != RC_MATRIX_PALETTE_OES) return &state.matrices.current().current();
  if (state.palette.enabled) return &state.palette.matrices[state.palette.current];
  context.fail(RC_INVALID_OPERATION, "the matrix palette is not enabled");
  return nullptr;
}

template <class MakeMatrix>
void multiply(const char *function, MakeMatrix &&makeMatrix) {
  enter(function, [&](Context &context) {
    if (Mat4 *current = loadTarget(context)) *current = *current * makeMatrix();
  });
}

template <class MakeMatrix>
void load(const char *function, MakeMatrix &&makeMatrix) {
  enter(function, [&](Context &context) {
    if (Mat4 *current = loadTarget(context)) *current = makeMatrix();
  });
}

// The stack of the mode; null in palette mode, which has none: moves, pushes and pops do nothing there.
MatrixStack *stackOf(Context &context) {
  MatrixState &matrices = context.state.matrices;
  return matrices.mode == RC_MATRIX_PALETTE_OES ? nullptr : &matrices.current();
}

template <class MakeMatrix>
void move(const char *function, MakeMatrix &&makeMatrix) {
  enter(function, [&](Context &context) {
    if (MatrixStack *stack = stackOf(context)) stack->current() = stack->current() * makeMatrix();
  });
}

}  // namespace

extern "C" {

void rcMatrixMode(RCenum mode) {
  enter("rcMatrixMode", [&](Context &context) {
    if (mode == RC_MATRIX_PALETTE_OES && !context.state.palette.enabled) {
      return context.fail(RC_INVALID_OPERATION, "the matrix palette is not enabled");
    }
    if (mode != RC_MODELVIEW && mode != RC_PROJECTION && mode != RC_TEXTURE && mode != RC_MATRIX_PALETTE_OES) {
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
  move("rcTranslatef", [&] { return glm::translate(Mat4(1), Vec3(x, y, z)); });
}

void rcTranslatex(RCfixed x, RCfixed y, RCfixed z) {
  move("rcTranslatex", [&] { return glm::translate(Mat4(1), Vec3(fromFixed(x), fromFixed(y), fromFixed(z))); });
}

void rcRotatef(RCfloat angle, RCfloat x, RCfloat y, RCfloat z) {
  move("rcRotatef", [&] { return rotation(angle, x, y, z); });
}

void rcRotatex(RCfixed angle, RCfixed x, RCfixed y, RCfixed z) {
  move("rcRotatex", [&] { return rotation(fromFixed(angle), fromFixed(x), fromFixed(y), fromFixed(z)); });
}

void rcScalef(RCfloat x, RCfloat y, RCfloat z) {
  move("rcScalef", [&] { return glm::scale(Mat4(1), Vec3(x, y, z)); });
}

void rcScalex(RCfixed x, RCfixed y, RCfixed z) {
  move("rcScalex", [&] { return glm::scale(Mat4(1), Vec3(fromFixed(x), fromFixed(y), fromFixed(z))); });
}

void rcPushMatrix(void) {
  enter("rcPushMatrix", [](Context &context) {
    MatrixStack *stack = stackOf(context);
    if (stack && !stack->push()) {
      context.fail(RC_STACK_OVERFLOW, "the stack holds %d matrices and is full", MatrixStack::kDepth);
    }
  });
}

void rcPopMatrix(void) {
  enter("rcPopMatrix", [](Context &context) {
    MatrixStack *stack = stackOf(context);
    if (stack && !stack->pop()) context.fail(RC_STACK_UNDERFLOW, "nothing was pushed");
  });
}

void rcCurrentPaletteMatrixOES(RCuint index) {
  enter("rcCurrentPaletteMatrixOES", [&](Context &context) {
    PaletteState &palette = context.state.palette;
    if (index >= PaletteState::kMatrices) return context.fail(RC_INVALID_VALUE, "%u is above 127", index);
    if (!palette.enabled) return context.fail(RC_INVALID_OPERATION, "the matrix palette is not enabled");
    palette.current = index;
  });
}

void rcLoadPaletteFromModelViewMatrixOES(void) {
  enter("rcLoadPaletteFromModelViewMatrixOES", [](Context &context) {
    PaletteState &palette = context.state.palette;
    if (!palette.enabled) return context.fail(RC_INVALID_OPERATION, "the matrix palette is not enabled");
    palette.matrices[palette.current] = context.state.matrices.modelview.current();
  });
}

}  // extern "C"
