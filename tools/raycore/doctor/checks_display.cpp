// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// The X server: whether there is one, whether its windows can show pictures, whether it shares memory with us.
#include <X11/Xlib.h>
#include <X11/extensions/XShm.h>
#include <fmt/format.h>
#include <sys/ipc.h>
#include <sys/shm.h>

#include <cstdlib>

#include "doctor/checks.h"

namespace rc::tool {
namespace {

bool gFailed = false;

int noteError(Display *, XErrorEvent *) {
  gFailed = true;
  return 0;
}

// As windows do it: a segment of ours that the server attaches.
bool sharesMemory(Display *display) {
  if (!XShmQueryExtension(display)) return false;
  XShmSegmentInfo info{};
  info.shmid = shmget(IPC_PRIVATE, 4096, IPC_CREAT | 0600);
  if (info.shmid < 0) return false;
  void *memory = shmat(info.shmid, nullptr, 0);
  const bool mapped = memory != reinterpret_cast<void *>(-1);
  if (mapped) {
    info.shmaddr = static_cast<char *>(memory);
    gFailed = false;
    const auto before = XSetErrorHandler(noteError);
    XShmAttach(display, &info);
    XSync(display, False);
    if (!gFailed) XShmDetach(display, &info);
    XSync(display, False);
    XSetErrorHandler(before);
  }
  shmctl(info.shmid, IPC_RMID, nullptr);
  if (mapped) shmdt(memory);
  return mapped && !gFailed;
}

Check windows(Display *display) {
  const int screen = DefaultScreen(display);
  const Visual *visual = DefaultVisual(display, screen);
  const int depth = DefaultDepth(display, screen);
  Check check{"display",
              Finding::Ok,
              fmt::format("{}, depth {}, {}", DisplayString(display), depth, ServerVendor(display)),
              {}};
  if (visual->c_class == TrueColor && depth >= 15) return check;
  check.finding = Finding::Problem;
  check.advice = "pictures need a TrueColor visual of 15 bits or more: Xvfb :1 -screen 0 1280x800x24";
  return check;
}

Check sharing(Display *display) {
  if (sharesMemory(display)) return {"shared memory", Finding::Ok, "the X server reads pictures from it", {}};
  return {"shared memory", Finding::Note, "none with this X server",
          "windows work, each picture is sent instead: slower; usual over a network and between containers"};
}

}  // namespace

XServer connectToDisplay() {
  const char *name = std::getenv("DISPLAY");
  if (!name || !*name) return nullptr;
  return {XOpenDisplay(name), [](Display *display) {
            if (display) XCloseDisplay(display);
          }};
}

std::vector<Check> checkDisplay(const XServer &server) {
  const char *name = std::getenv("DISPLAY");
  if (!name || !*name) {
    const char *advice = "off-screen pictures need none; raycore view and windows do: set DISPLAY, or xvfb-run COMMAND";
    return {{"display", Finding::Note, "none", advice}};
  }
  if (!server) {
    const auto advice =
        fmt::format("no X server answers at {} (or it refuses: xauth, xhost); unset DISPLAY without one", name);
    return {{"display", Finding::Problem, name, advice}};
  }
  return {windows(server.get()), sharing(server.get())};
}

}  // namespace rc::tool
