// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// keyframes.h: the value of an animation's channel at a moment. [glTF 2.0, appendix C]
#pragma once

#include <vector>

#include "scene/scene.h"

namespace rc::tool {

// width values; rotations are normalised quaternions x y z w. Empty if the channel has no keys.
std::vector<float> sampleChannel(const Channel &channel, float seconds);

}  // namespace rc::tool
