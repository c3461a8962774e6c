// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "view/drop.h"

#include <algorithm>
#include <sstream>
#include <vector>

namespace rc::tool {
namespace {

constexpr long kVersion = 5;
constexpr long kMoreThanThreeTypes = 1;

std::string propertyOf(Display *display, Window window, Atom property, bool remove) {
  Atom type = 0;
  int format = 0;
  unsigned long count = 0, left = 0;
  unsigned char *value = nullptr;
  XGetWindowProperty(display, window, property, 0, 65536, remove, AnyPropertyType, &type, &format, &count, &left,
                     &value);
  // Xlib gives 32-bit items as longs.
  const size_t item = format == 32 ? sizeof(long) : size_t(format / 8);
  std::string bytes;
  if (value) bytes.assign(reinterpret_cast<const char *>(value), count * item);
  if (value) XFree(value);
  return bytes;
}

int hexDigit(char c) {
  const char *const digits = "0123456789abcdef";
  const char *const found = std::find(digits, digits + 16, char(c >= 'A' && c <= 'F' ? c - 'A' + 'a' : c));
  return found == digits + 16 ? -1 : int(found - digits);
}

std::string unescaped(const std::string &text) {
  std::string result;
  for (size_t i = 0; i < text.size(); ++i) {
    const int high = text[i] == '%' && i + 2 < text.size() ? hexDigit(text[i + 1]) : -1;
    const int low = high >= 0 ? hexDigit(text[i + 2]) : -1;
    result += low >= 0 ? char(high * 16 + low) : text[i];
    if (low >= 0) i += 2;
  }
  return result;
}

}  // namespace

std::optional<std::string> fileOfUriList(const std::string &text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    while (!line.empty() && (line.back() == '\r' || line.back() == '\0')) line.pop_back();
    constexpr std::string_view kScheme = "file:";
    if (!line.starts_with(kScheme)) continue;
    std::string path = line.substr(kScheme.size());
    if (path.starts_with("//")) path.erase(0, std::min(path.find('/', 2), path.size()));  // a host's name
    if (!path.empty()) return unescaped(path);
  }
  return std::nullopt;
}

DropTarget::DropTarget(const XWindow &window) : mWindow(window) {
  const auto version = static_cast<unsigned long>(kVersion);
  XChangeProperty(window.display(), window.id(), window.atom("XdndAware"), XA_ATOM, 32, PropModeReplace,
                  reinterpret_cast<const unsigned char *>(&version), 1);
}

std::optional<std::string> DropTarget::handle(const XEvent &event) {
  if (event.type == SelectionNotify) return take(event.xselection);
  if (event.type != ClientMessage) return std::nullopt;
  const XClientMessageEvent &message = event.xclient;
  if (message.message_type == mWindow.atom("XdndEnter")) enter(message);
  if (message.message_type == mWindow.atom("XdndPosition")) answer(message);
  if (message.message_type == mWindow.atom("XdndDrop")) ask(message);
  return std::nullopt;
}

void DropTarget::enter(const XClientMessageEvent &message) {
  mSource = Window(message.data.l[0]);
  const Atom wanted = mWindow.atom("text/uri-list");
  if (message.data.l[1] & kMoreThanThreeTypes) {
    const std::string types = propertyOf(mWindow.display(), mSource, mWindow.atom("XdndTypeList"), false);
    const auto *first = reinterpret_cast<const Atom *>(types.data());
    const Atom *last = first + types.size() / sizeof(Atom);
    mAcceptable = std::find(first, last, wanted) != last;
    return;
  }
  mAcceptable = std::find(message.data.l + 2, message.data.l + 5, long(wanted)) != message.data.l + 5;
}

void DropTarget::answer(const XClientMessageEvent &message) const {
  if (Window(message.data.l[0]) != mSource) return;
  say("XdndStatus", mAcceptable ? 1 : 0, mAcceptable ? mWindow.atom("XdndActionCopy") : 0);
}

void DropTarget::ask(const XClientMessageEvent &message) {
  if (Window(message.data.l[0]) != mSource) return;
  if (!mAcceptable) return say("XdndFinished", 0, 0);
  XConvertSelection(mWindow.display(), mWindow.atom("XdndSelection"), mWindow.atom("text/uri-list"),
                    mWindow.atom("RAYCORE_DROP"), mWindow.id(), Time(message.data.l[2]));
}

std::optional<std::string> DropTarget::take(const XSelectionEvent &event) {
  if (event.selection != mWindow.atom("XdndSelection") || !mSource) return std::nullopt;
  std::optional<std::string> file;
  if (event.property != 0) {
    file = fileOfUriList(propertyOf(mWindow.display(), mWindow.id(), event.property, true));
  }
  say("XdndFinished", file ? 1 : 0, file ? mWindow.atom("XdndActionCopy") : 0);
  mSource = 0;
  return file;
}

// XdndStatus has the action in its fifth place, XdndFinished in its third.
void DropTarget::say(const char *type, long flags, Atom action) const {
  XEvent event{};
  event.xclient.type = ClientMessage;
  event.xclient.window = mSource;
  event.xclient.message_type = mWindow.atom(type);
  event.xclient.format = 32;
  event.xclient.data.l[0] = long(mWindow.id());
  event.xclient.data.l[1] = flags;
  event.xclient.data.l[std::string_view(type) == "XdndStatus" ? 4 : 2] = long(action);
  XSendEvent(mWindow.display(), mSource, False, NoEventMask, &event);
  XFlush(mWindow.display());
}

}  // namespace rc::tool
