// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// lights.h: lights of the file, or a key, a fill and a rim light about the viewer.
#pragma once

#include "draw/view.h"
#include "scene/pose.h"

namespace rc::tool {

enum class Lighting { Automatic, File, Studio, Headlight, None };

// Automatic: those of the file if it has any. Throws InputError: File without lights.
void setLights(Scene &scene, const Pose &pose, const View &view, const Bounds &bounds, Lighting lighting);

}  // namespace rc::tool
