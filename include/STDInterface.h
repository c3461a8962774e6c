/* SPDX-License-Identifier: Apache-2.0
 * SPDX-FileCopyrightText: The raycore authors
 *
 * STDInterface.h: the Windows-style names that RayCore programs use on every platform. [G C.1]
 */
#ifndef RC_STDINTERFACE_H
#define RC_STDINTERFACE_H

#if defined(_WIN32)
#include <windows.h>
#else
#include <stdint.h>

typedef int BOOL;
typedef uint16_t WORD;  /* 2 bytes: bitmap headers are read into it */
typedef uint32_t DWORD; /* 4 bytes */
#ifndef TRUE
#define TRUE 1
#endif
#ifndef FALSE
#define FALSE 0
#endif
#endif

#endif /* RC_STDINTERFACE_H */
