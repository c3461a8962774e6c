// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// The framework's window on X11: events to keys and mouse, title, full screen. [reference 6.3]
#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/keysym.h>

#include <chrono>
#include <thread>

#include "RCFramework.h"

struct WindowPlatform::Window {
  ::Display *display = nullptr;
  ::Window window = 0;
  Atom deleteWindow = None;
  bool ended = false;
  bool filling = false;       // the screen, by our own doing
  int width = 0, height = 0;  // before it did

  Atom atom(const char *name) const { return XInternAtom(display, name, False); }
};

namespace {

// What KeyDownEvent is told for a key; 0 for keys that mean nothing.
char keyOf(KeySym symbol) {
  struct Range {
    KeySym first, last;
    char key;
  };
  static const Range kRanges[] = {
      {XK_a, XK_z, 'A'},
      {XK_A, XK_Z, 'A'},
      {XK_0, XK_9, '0'},
      {XK_KP_0, XK_KP_9, '0'},
      {XK_KP_Add, XK_KP_Add, RC_KEY_PLUS},
      {XK_plus, XK_plus, RC_KEY_PLUS},
      {XK_equal, XK_equal, RC_KEY_PLUS},
      {XK_KP_Subtract, XK_KP_Subtract, RC_KEY_MINUS},
      {XK_minus, XK_minus, RC_KEY_MINUS},
      {XK_Up, XK_Up, RC_KEY_UP},
      {XK_Down, XK_Down, RC_KEY_DOWN},
      {XK_Left, XK_Left, RC_KEY_LEFT},
      {XK_Right, XK_Right, RC_KEY_RIGHT},
  };
  for (const Range &range : kRanges) {
    if (symbol >= range.first && symbol <= range.last) return static_cast<char>(range.key + (symbol - range.first));
  }
  return 0;
}

// Without modifiers, but a keypad's digits, which most keyboards have above its arrows.
KeySym symbolOf(XKeyEvent &event) {
  const KeySym above = XLookupKeysym(&event, 1);
  return above >= XK_KP_0 && above <= XK_KP_9 ? above : XLookupKeysym(&event, 0);
}

DWORD buttonOf(unsigned button) {
  switch (button) {
    case Button1:
      return MOUSE_BTN_LEFT;
    case Button2:
      return MOUSE_BTN_MIDDLE;
    case Button3:
      return MOUSE_BTN_RIGHT;
    default:
      return MOUSE_BTN_NULL;
  }
}

DWORD buttonsOf(unsigned state) {
  DWORD buttons = MOUSE_BTN_NULL;
  if (state & Button1Mask) buttons |= MOUSE_BTN_LEFT;
  if (state & Button2Mask) buttons |= MOUSE_BTN_MIDDLE;
  if (state & Button3Mask) buttons |= MOUSE_BTN_RIGHT;
  return buttons;
}

// Without a name of a server Xlib need not be asked.
::Display *openDisplay() {
  const char *name = getenv("DISPLAY");
  return name && *name ? XOpenDisplay(nullptr) : nullptr;
}

// Window managers that take requests say so. [EWMH 1.5, _NET_SUPPORTING_WM_CHECK]
bool isManaged(::Display *display, Atom check) {
  Atom type = None;
  int format = 0;
  unsigned long count = 0, left = 0;
  unsigned char *data = nullptr;
  XGetWindowProperty(display, DefaultRootWindow(display), check, 0, 1, False, XA_WINDOW, &type, &format, &count, &left,
                     &data);
  if (data) XFree(data);
  return count == 1;
}

// A window manager may have sizes of its own. It may also never map the window: the program then begins without.
void awaitMapped(::Display *display, ::Window window, int &width, int &height) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(2);
  while (std::chrono::steady_clock::now() < deadline) {
    XEvent event;
    if (!XCheckWindowEvent(display, window, StructureNotifyMask, &event)) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      continue;
    }
    if (event.type == ConfigureNotify) width = event.xconfigure.width, height = event.xconfigure.height;
    if (event.type == MapNotify || event.type == DestroyNotify) return;
  }
}

float fraction(int position, int size) { return size > 0 ? float(position) / float(size) : 0.0f; }

}  // namespace

WindowPlatform::WindowPlatform() : m_pWindow(nullptr) {}

WindowPlatform::~WindowPlatform() { WindowPlatform::Destroy(); }

BOOL WindowPlatform::Create(const char *title, int &width, int &height) {
  ::Display *display = openDisplay();
  if (!display) {
    fprintf(stderr,
            "RCFramework: no display, so the program runs off-screen; RAYCORE_CAPTURE=file.png writes its "
            "pictures, RAYCORE_FRAMES=n ends it\n");
    return TRUE;
  }
  m_pWindow = new Window;
  m_pWindow->display = display;
  m_pWindow->window = XCreateSimpleWindow(display, DefaultRootWindow(display), 0, 0, unsigned(width), unsigned(height),
                                          0, 0, BlackPixel(display, DefaultScreen(display)));
  m_pWindow->deleteWindow = m_pWindow->atom("WM_DELETE_WINDOW");
  XSetWMProtocols(display, m_pWindow->window, &m_pWindow->deleteWindow, 1);
  XSelectInput(display, m_pWindow->window,
               KeyPressMask | ButtonPressMask | ButtonReleaseMask | PointerMotionMask | StructureNotifyMask);
  SetTitle(title);
  XMapWindow(display, m_pWindow->window);
  awaitMapped(display, m_pWindow->window, width, height);
  return TRUE;
}

void WindowPlatform::Destroy() {
  if (!m_pWindow) return;
  XDestroyWindow(m_pWindow->display, m_pWindow->window);
  XCloseDisplay(m_pWindow->display);
  delete m_pWindow;
  m_pWindow = nullptr;
}

EGLNativeWindowType WindowPlatform::GetWindowHandle() {
  return m_pWindow ? static_cast<EGLNativeWindowType>(m_pWindow->window) : EGLNativeWindowType{};
}

void WindowPlatform::OnDrawComplete() {}

void WindowPlatform::SetTitle(const char *title) {
  if (!m_pWindow || !title) return;
  XStoreName(m_pWindow->display, m_pWindow->window, title);
  XFlush(m_pWindow->display);
}

void WindowPlatform::ToggleFullScreen() {
  if (!m_pWindow) return;
  if (isManaged(m_pWindow->display, m_pWindow->atom("_NET_SUPPORTING_WM_CHECK"))) {
    AskForFullScreen();
  } else {
    FillScreen();
  }
}

void WindowPlatform::AskForFullScreen() {
  constexpr long kToggle = 2, kFromApplication = 1;
  XEvent event = {};
  event.xclient.type = ClientMessage;
  event.xclient.window = m_pWindow->window;
  event.xclient.message_type = m_pWindow->atom("_NET_WM_STATE");
  event.xclient.format = 32;
  event.xclient.data.l[0] = kToggle;
  event.xclient.data.l[1] = static_cast<long>(m_pWindow->atom("_NET_WM_STATE_FULLSCREEN"));
  event.xclient.data.l[3] = kFromApplication;
  XSendEvent(m_pWindow->display, DefaultRootWindow(m_pWindow->display), False,
             SubstructureRedirectMask | SubstructureNotifyMask, &event);
  XFlush(m_pWindow->display);
}

// Where nobody manages windows, the window itself becomes as large as the screen, or as it was.
void WindowPlatform::FillScreen() {
  ::Display *display = m_pWindow->display;
  const int screen = DefaultScreen(display);
  m_pWindow->filling = !m_pWindow->filling;
  if (m_pWindow->filling) {
    m_pWindow->width = m_iWidth;
    m_pWindow->height = m_iHeight;
  }
  const int width = m_pWindow->filling ? DisplayWidth(display, screen) : m_pWindow->width;
  const int height = m_pWindow->filling ? DisplayHeight(display, screen) : m_pWindow->height;
  XMoveResizeWindow(display, m_pWindow->window, 0, 0, unsigned(width), unsigned(height));
  XFlush(display);
}

void WindowPlatform::HandleKeyEvent(unsigned long symbol, unsigned state, BOOL dispatch) {
  if (symbol == XK_Escape) {
    m_pWindow->ended = true;
  } else if (symbol == XK_Return && state & Mod1Mask) {
    ToggleFullScreen();
  } else if (const char key = keyOf(symbol)) {
    if (dispatch) KeyDownEvent(key);
  }
}

void WindowPlatform::TellMouse(int x, int y, DWORD buttons) {
  OnMouseEvent(fraction(x, m_iWidth), fraction(y, m_iHeight), buttons);
}

BOOL WindowPlatform::PumpMessage(BOOL dispatch) {
  if (!m_pWindow) return TRUE;
  while (!m_pWindow->ended && XPending(m_pWindow->display)) {
    XEvent event;
    XNextEvent(m_pWindow->display, &event);
    switch (event.type) {
      case KeyPress:
        HandleKeyEvent(symbolOf(event.xkey), event.xkey.state, dispatch);
        break;
      // The state of an event is that of before it.
      case ButtonPress:
        if (dispatch)
          TellMouse(event.xbutton.x, event.xbutton.y, buttonsOf(event.xbutton.state) | buttonOf(event.xbutton.button));
        break;
      case ButtonRelease:
        if (dispatch)
          TellMouse(event.xbutton.x, event.xbutton.y, buttonsOf(event.xbutton.state) & ~buttonOf(event.xbutton.button));
        break;
      case MotionNotify:
        if (dispatch) TellMouse(event.xmotion.x, event.xmotion.y, buttonsOf(event.xmotion.state));
        break;
      case ConfigureNotify:
        m_iWidth = event.xconfigure.width;
        m_iHeight = event.xconfigure.height;
        break;
      case ClientMessage:
        m_pWindow->ended |= static_cast<Atom>(event.xclient.data.l[0]) == m_pWindow->deleteWindow;
        break;
      case DestroyNotify:
        m_pWindow->ended = true;
        break;
      default:
        break;
    }
  }
  return !m_pWindow->ended;
}
