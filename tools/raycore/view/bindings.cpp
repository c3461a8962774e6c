// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "view/bindings.h"

#include <X11/keysym.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace rc::tool {
namespace {

struct KeyRow {
  ViewAction action;
  std::array<KeySym, 3> keys;
  const char *shown, *what;
};

constexpr KeyRow kKeys[] = {
    {ViewAction::FrameAll, {XK_f, XK_Home}, "F, Home", "show the whole model"},
    {ViewAction::Reset, {XK_r}, "R", "back to where it began"},
    {ViewAction::NextCamera, {XK_c}, "C", "next camera of the file"},
    {ViewAction::PlayPause, {XK_space}, "Space", "play or pause the animation"},
    {ViewAction::ScrubBack, {XK_Left}, "Left", "animation back by a thirtieth second"},
    {ViewAction::ScrubOn, {XK_Right}, "Right", "animation on by a thirtieth second"},
    {ViewAction::FewerBounces, {XK_minus, XK_KP_Subtract}, "-", "fewer reflections and refractions"},
    {ViewAction::MoreBounces, {XK_plus, XK_equal, XK_KP_Add}, "+", "more of them"},
    {ViewAction::Shadows, {XK_x}, "X", "shadows on or off"},
    {ViewAction::Filter, {XK_t}, "T", "texture filter: anisotropic, trilinear, bilinear, base level"},
    {ViewAction::Structure, {XK_k}, "K", "acceleration structure: BVH, KD-tree"},
    {ViewAction::Statistics, {XK_i}, "I", "statistics"},
    {ViewAction::Help, {XK_h, XK_F1}, "H, F1", "this help"},
    {ViewAction::Screenshot, {XK_p, XK_Print}, "P", "take a screenshot"},
    {ViewAction::FullScreen, {XK_F11, XK_Return}, "F11, Return", "full screen"},
    {ViewAction::Quit, {XK_Escape, XK_q}, "Esc, Q", "end"},
};

struct FlightRow {
  KeySym key;
  Vec3 way;
};

const FlightRow kFlight[] = {{XK_w, {0, 0, 1}}, {XK_s, {0, 0, -1}},      {XK_a, {-1, 0, 0}},
                             {XK_d, {1, 0, 0}}, {XK_Page_Up, {0, 1, 0}}, {XK_Page_Down, {0, -1, 0}}};

struct DragRow {
  unsigned button, state;
  Drag drag;
};

constexpr unsigned kModifiers = ShiftMask | ControlMask;
constexpr DragRow kDrags[] = {{Button1, 0, Drag::Orbit},
                              {Button1, ShiftMask, Drag::Pan},
                              {Button1, ControlMask, Drag::Look},
                              {Button2, 0, Drag::Pan},
                              {Button3, 0, Drag::Pan}};

struct TextRow {
  const char *shown, *what;
};

constexpr TextRow kMouse[] = {{"left drag", "orbit"},
                              {"right drag", "pan; also with the middle button, or Shift and the left one"},
                              {"Ctrl, left drag", "look about"},
                              {"wheel", "zoom"},
                              {"left click", "what is there: material, distance, place"},
                              {"drop a file", "look at that one"},
                              {"W A S D", "fly; Page Up and Page Down: up and down"}};

std::string line(const char *shown, const char *what) { return fmt::format("{:<16} {}", shown, what); }

}  // namespace

std::optional<ViewAction> actionOf(KeySym key) {
  for (const KeyRow &row : kKeys) {
    if (key != NoSymbol && std::find(row.keys.begin(), row.keys.end(), key) != row.keys.end()) return row.action;
  }
  return std::nullopt;
}

std::optional<Vec3> flightOf(KeySym key) {
  for (const FlightRow &row : kFlight) {
    if (row.key == key) return row.way;
  }
  return std::nullopt;
}

std::optional<Drag> dragOf(unsigned button, unsigned state) {
  for (const DragRow &row : kDrags) {
    if (row.button == button && row.state == (state & kModifiers)) return row.drag;
  }
  return std::nullopt;
}

std::vector<std::string> bindingLines() {
  std::vector<std::string> lines;
  for (const TextRow &row : kMouse) lines.push_back(line(row.shown, row.what));
  for (const KeyRow &row : kKeys) lines.push_back(line(row.shown, row.what));
  return lines;
}

}  // namespace rc::tool
