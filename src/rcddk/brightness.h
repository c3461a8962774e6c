// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// brightness.h: how bright anything in a scene can be, which says which rays cannot be missed.
#pragma once

#include "rchal/scene_view.h"

namespace rc::ddk {

// No ray brings more light than this in any channel. Infinite where nothing bounds a light.
float brightest(const hal::SceneView &scene);

// SceneView::ignorable: a pixel may be off by one step of a byte.
float ignorable(const hal::SceneView &scene);

}  // namespace rc::ddk
