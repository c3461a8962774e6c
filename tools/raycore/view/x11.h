// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// x11.h: Xlib without those of its macros that are names elsewhere.
#pragma once

#include <X11/Xlib.h>
// These use the macros.
#include <X11/XKBlib.h>
#include <X11/Xatom.h>
#include <X11/Xutil.h>

#undef None
#undef Bool
#undef Status
#undef Always
#undef Success
