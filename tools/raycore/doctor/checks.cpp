// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "doctor/checks.h"

namespace rc::tool {

std::vector<Check> examine() {
  // Held while the picture is tried: a server whose last guest leaves may start anew, and refuses others meanwhile.
  const XServer server = connectToDisplay();
  std::vector<Check> checks{checkLibrary(),      checkSettings(), checkDevice(),
                            checkInstructions(), checkThreads(),  checkPicture()};
  for (Check &check : checkDisplay(server)) checks.push_back(std::move(check));
  for (Check (*check)() : {checkFolders, checkFilms, checkLibraries}) checks.push_back(check());
  return checks;
}

}  // namespace rc::tool
