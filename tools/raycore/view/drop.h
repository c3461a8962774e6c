// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// drop.h: files that are dropped onto the window. [XDND, the Drag-and-Drop Protocol for the X Window System, version 5]
#pragma once

#include <optional>
#include <string>

#include "view/window.h"

namespace rc::tool {

class DropTarget {
 public:
  explicit DropTarget(const XWindow &window);

  // Takes part in the talk with the source; the file's name once it is there.
  std::optional<std::string> handle(const XEvent &event);

 private:
  void enter(const XClientMessageEvent &message);
  void answer(const XClientMessageEvent &message) const;
  void ask(const XClientMessageEvent &message);
  std::optional<std::string> take(const XSelectionEvent &event);
  void say(const char *type, long flags, Atom action) const;

  const XWindow &mWindow;
  Window mSource = 0;
  bool mAcceptable = false;  // the source has files to give
};

// The first file of a text/uri-list: "file:///a%20b.glb" -> "/a b.glb"; nothing if there is none. [RFC 2483, RFC 8089]
std::optional<std::string> fileOfUriList(const std::string &text);

}  // namespace rc::tool
