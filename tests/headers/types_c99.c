/* SPDX-License-Identifier: Apache-2.0
 * SPDX-FileCopyrightText: The raycore authors
 *
 * The headers as C99: the value of every token, the size of every type, the type of every function.
 * What is wrong does not compile.
 */
#include <RC/rc.h>
#include <RC/rcu.h>
#include <RC1/rc1.h>
#include <stddef.h>

#include "STDInterface.h"

#define RC_TOKEN(name, value) typedef char token_##name[(name) == (value) ? 1 : -1];
#include "headers/token_values.inc"
#undef RC_TOKEN

/* A function whose type differs makes the assignment fail, for both sides are pointers to functions. */
#define RC_PROTOTYPE(name, result, arguments) result(RC_APIENTRY *const pointer_##name) arguments = name;
#include "headers/prototypes.inc"
#undef RC_PROTOTYPE

/* The guide's other spellings. */
typedef char check_shininess[RC_SHINIESS == RC_SHININESS ? 1 : -1];
typedef char check_quadratic[RC_QUADRIC_ATTENUATION == RC_QUADRATIC_ATTENUATION ? 1 : -1];
typedef char check_inner[RC_INNER_CONE == RC_SPOT_INNER_CONE ? 1 : -1];
typedef char check_outer[RC_OUTER_CONE == RC_SPOT_OUTER_CONE ? 1 : -1];

#define RC_TYPE(name, type)          \
  type *convert_##name(name *value); \
  type *convert_##name(name *value) { return value; }
RC_TYPE(RCenum, unsigned int)
RC_TYPE(RCboolean, unsigned char)
RC_TYPE(RCbitfield, unsigned int)
RC_TYPE(RCbyte, signed char)
RC_TYPE(RCshort, short)
RC_TYPE(RCint, int)
RC_TYPE(RCsizei, int)
RC_TYPE(RCubyte, unsigned char)
RC_TYPE(RCushort, unsigned short)
RC_TYPE(RCuint, unsigned int)
RC_TYPE(RCfloat, float)
RC_TYPE(RCclampf, float)
RC_TYPE(RCdouble, double)
RC_TYPE(RCfixed, int)
RC_TYPE(RCclampx, int)
RC_TYPE(RCvoid, void)
RC_TYPE(RCchar, char)
RC_TYPE(RCintptr, signed long int)
RC_TYPE(RCsizeiptr, signed long int)

typedef char check_word[sizeof(WORD) == 2 ? 1 : -1];
typedef char check_dword[sizeof(DWORD) == 4 ? 1 : -1];
typedef char check_bool[sizeof(BOOL) == sizeof(int) && TRUE == 1 && FALSE == 0 ? 1 : -1];

int main(void) {
  /* Without a context every call is harmless; the macros name functions. */
  void (*draw)(RCenum, RCint, RCsizei) = rcDrawArray;
  void (*light)(RCenum, RCenum, RCfloat) = rcLight;
  void (*lights)(RCenum, RCenum, const RCfloat *) = rcLightv;
  draw(RC_TRIANGLES, 0, 3);
  light(RC_LIGHT0, RC_SPOT_EXPONENT, 1);
  lights(RC_LIGHT0, RC_AMBIENT, NULL);
  return rcGetError() == RC_INVALID_OPERATION && rcGetError() == RC_NO_ERROR ? 0 : 1;
}
