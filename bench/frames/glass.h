// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// glass.h: scenes of mirrors, glass and one light, which POV-Ray is compared on; no file is needed.
#pragma once

#include "frames/scenes.h"

namespace rc::bench {

// "spheres": the Cornell box with its mirror block, a ball of glass and one that mirrors. "balls": a knot on a mirror
// floor beside two such balls. "panes": the knot between two panes of glass and a mirror. Nothing for other names.
std::optional<FrameScene> loadGlassScene(const std::string &name);

}  // namespace rc::bench
