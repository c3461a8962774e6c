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

// values: null where the caller gave none, and then nothing happens.
template <class... Arguments, class Values, class MakeMatrix>
void multiply(const Call<Arguments...> &call, const Values *values, MakeMatrix &&makeMatrix) {
  enter(call, [&](Context &context) {
    if (!values) return;
    if (Mat4 *current = loadTarget(context)) *current = *current * makeMatrix();
  });
}

template <class... Arguments, class Values, class MakeMatrix>
void load(const Call<Arguments...> &call, const Values *values, MakeMatrix &&makeMatrix) {
  enter(call, [&](Context &context) {
    if (!values) return;
    if (Mat4 *current = loadTarget(context)) *current = makeMatrix();
  });
}

// The stack of the mode; null in palette mode, which has none: moves, pushes and pops do nothing there.
MatrixStack *stackOf(Context &context) {
  MatrixState &matrices = context.state.matrices;
  return matrices.mode == RC_MATRIX_PALETTE_OES ? nullptr : &matrices.current();
}

template <class... Arguments, class MakeMatrix>
void move(const Call<Arguments...> &call, MakeMatrix &&makeMatrix) {
  enter(call, [&](Context &context) {
    if (MatrixStack *stack = stackOf(context)) stack->current() = stack->current() * makeMatrix();
  });
}

}  // namespace

extern "C" {

void rcMatrixMode(RCenum mode) {
  enter(Call("rcMatrixMode", mode), [&](Context &context) {
    if (mode == RC_MATRIX_PALETTE_OES && !context.state.palette.enabled) {
      return context.fail(RC_INVALID_OPERATION, "the matrix palette is not enabled");
    }
    if (mode != RC_MODELVIEW && mode != RC_PROJECTION && mode != RC_TEXTURE && mode != RC_MATRIX_PALETTE_OES) {
      return context.fail(RC_INVALID_ENUM,
                          "mode 0x%04X is not RC_MODELVIEW, RC_PROJECTION, RC_TEXTURE or RC_MATRIX_PALETTE_OES", mode);
    }
    context.state.matrices.mode = mode;
  });
}

void rcLoadIdentity(void) {
  enter(Call("rcLoadIdentity"), [](Context &context) {
    if (Mat4 *current = loadTarget(context)) *current = Mat4(1);
  });
}

void rcLoadMatrixf(const RCfloat *m) {
  load(Call("rcLoadMatrixf", list(m, 16)), m, [&] { return loadMatrix(m); });
}

void rcLoadMatrixx(const RCfixed *m) {
  load(Call("rcLoadMatrixx", list(m, 16)), m, [&] { return loadMatrix(fromFixed<16>(m).data()); });
}

void rcMultMatrixf(const RCfloat *m) {
  multiply(Call("rcMultMatrixf", list(m, 16)), m, [&] { return loadMatrix(m); });
}

void rcMultMatrixx(const RCfixed *m) {
  multiply(Call("rcMultMatrixx", list(m, 16)), m, [&] { return loadMatrix(fromFixed<16>(m).data()); });
}

void rcTranslatef(RCfloat x, RCfloat y, RCfloat z) {
  move(Call("rcTranslatef", x, y, z), [&] { return glm::translate(Mat4(1), Vec3(x, y, z)); });
}

void rcTranslatex(RCfixed x, RCfixed y, RCfixed z) {
  move(Call("rcTranslatex", x, y, z),
       [&] { return glm::translate(Mat4(1), Vec3(fromFixed(x), fromFixed(y), fromFixed(z))); });
}

void rcRotatef(RCfloat angle, RCfloat x, RCfloat y, RCfloat z) {
  move(Call("rcRotatef", angle, x, y, z), [&] { return rotation(angle, x, y, z); });
}

void rcRotatex(RCfixed angle, RCfixed x, RCfixed y, RCfixed z) {
  move(Call("rcRotatex", angle, x, y, z),
       [&] { return rotation(fromFixed(angle), fromFixed(x), fromFixed(y), fromFixed(z)); });
}

void rcScalef(RCfloat x, RCfloat y, RCfloat z) {
  move(Call("rcScalef", x, y, z), [&] { return glm::scale(Mat4(1), Vec3(x, y, z)); });
}

void rcScalex(RCfixed x, RCfixed y, RCfixed z) {
  move(Call("rcScalex", x, y, z), [&] { return glm::scale(Mat4(1), Vec3(fromFixed(x), fromFixed(y), fromFixed(z))); });
}

void rcPushMatrix(void) {
  enter(Call("rcPushMatrix"), [](Context &context) {
    MatrixStack *stack = stackOf(context);
    if (stack && !stack->push()) {
      context.fail(RC_STACK_OVERFLOW, "the stack holds %d matrices and is full", MatrixStack::kDepth);
    }
  });
}

void rcPopMatrix(void) {
  enter(Call("rcPopMatrix"), [](Context &context) {
    MatrixStack *stack = stackOf(context);
    if (stack && !stack->pop()) context.fail(RC_STACK_UNDERFLOW, "nothing was pushed");
  });
}

void rcCurrentPaletteMatrixOES(RCuint index) {
  enter(Call("rcCurrentPaletteMatrixOES", index), [&](Context &context) {
    PaletteState &palette = context.state.palette;
    if (index >= PaletteState::kMatrices)
      return context.fail(RC_INVALID_VALUE, "matrixpaletteindex is %u, not in 0 ... 127", index);
    if (!palette.enabled) return context.fail(RC_INVALID_OPERATION, "the matrix palette is not enabled");
    palette.current = index;
  });
}

void rcLoadPaletteFromModelViewMatrixOES(void) {
  enter(Call("rcLoadPaletteFromModelViewMatrixOES"), [](Context &context) {
    PaletteState &palette = context.state.palette;
    if (!palette.enabled) return context.fail(RC_INVALID_OPERATION, "the matrix palette is not enabled");
    palette.matrices[palette.current] = context.state.matrices.modelview.current();
  });
}

}  // extern "C"
