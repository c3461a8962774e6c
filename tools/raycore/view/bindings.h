// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// bindings.h: which keys and buttons do what: one table for the window, its help and --help.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/math.h"
#include "view/x11.h"

namespace rc::tool {

enum class ViewAction {
  FrameAll,
  Reset,
  NextCamera,
  PlayPause,
  ScrubBack,
  ScrubOn,
  FewerBounces,
  MoreBounces,
  Shadows,
  Filter,
  Structure,
  Statistics,
  Help,
  Screenshot,
  FullScreen,
  Quit
};

enum class Drag { Orbit, Look, Pan };

std::optional<ViewAction> actionOf(KeySym key);
// Right, up, forward, for keys that are held; nothing for other keys.
std::optional<Vec3> flightOf(KeySym key);
// state: modifiers, as X has them.
std::optional<Drag> dragOf(unsigned button, unsigned state);

// "Space        play or pause the animation", a line each.
std::vector<std::string> bindingLines();

}  // namespace rc::tool
