// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// checks.h: what `raycore doctor` looks at. Each check is one line: what is there, whether it is well, what helps.
#pragma once

#include <memory>
#include <string>
#include <vector>

struct _XDisplay;  // Xlib's Display

namespace rc::tool {

enum class Finding { Ok, Note, Problem };  // Note: works, but with less than there could be

struct Check {
  std::string name;
  Finding finding = Finding::Ok;
  std::string found;
  std::string advice;  // empty if all is well
};

// All of them, in the order in which they are shown.
std::vector<Check> examine();

// checks_library.cpp. The first context makes the library read its settings: what it says of them is a check too.
Check checkLibrary();
Check checkSettings();
Check checkPicture();
// checks_machine.cpp
Check checkDevice();
Check checkInstructions();
Check checkThreads();
Check checkFolders();
Check checkFilms();
Check checkLibraries();
// checks_display.cpp
using XServer = std::shared_ptr<_XDisplay>;
XServer connectToDisplay();  // null if there is none
std::vector<Check> checkDisplay(const XServer &server);

}  // namespace rc::tool
