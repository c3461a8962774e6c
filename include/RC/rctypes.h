/* SPDX-License-Identifier: Apache-2.0
 * SPDX-FileCopyrightText: The raycore authors
 *
 * rctypes.h: the C types of the RayCore API, and how its symbols are exported. [API Specifications]
 */
#ifndef RC_RCTYPES_H
#define RC_RCTYPES_H

#if defined(_WIN32)
#define RC_APIENTRY __stdcall
#define RC_APICALL __declspec(dllimport)
#elif defined(__GNUC__)
#define RC_APIENTRY
#define RC_APICALL __attribute__((visibility("default")))
#else
#define RC_APIENTRY
#define RC_APICALL
#endif

typedef unsigned int RCenum;
typedef unsigned char RCboolean;
typedef unsigned int RCbitfield;
typedef signed char RCbyte; /* as in GL; RC_BYTE data are signed */
typedef short RCshort;
typedef int RCint;
typedef int RCsizei;
typedef unsigned char RCubyte;
typedef unsigned short RCushort;
typedef unsigned int RCuint;
typedef float RCfloat;
typedef float RCclampf; /* a float that is clamped to 0 ... 1 */
typedef int RCfixed;    /* 16.16: 0x10000 is 1.0 */
typedef int RCclampx;   /* 16.16, clamped to 0 ... 1 */
typedef double RCdouble;
typedef void RCvoid;
typedef char RCchar;
typedef signed long int RCintptr;
typedef signed long int RCsizeiptr;

/* What rcDebugMessageCallbackRCX calls. */
typedef void(RC_APIENTRY *RCDEBUGPROCRCX)(RCenum source, RCenum type, RCuint id, RCenum severity, RCsizei length,
                                          const RCchar *message, const RCvoid *userParam);

#endif /* RC_RCTYPES_H */
