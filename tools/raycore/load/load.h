// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// load.h: a file becomes a Scene.
#pragma once

#include <string>

#include "scene/scene.h"

namespace rc::tool {

// The usual way: reads in a process of its own, with limits (load/sandbox.cpp). name "-": standard input.
// Throws InputError. Other threads must be idle: the reader has a copy of the calling one alone.
Scene loadModel(const std::string &name);

// A picture, read in the same way.
Image loadPicture(const std::string &name);

// Reads in this process; what the sandbox runs.
Scene readModel(const std::string &name);

}  // namespace rc::tool
