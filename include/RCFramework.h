/* SPDX-License-Identifier: Apache-2.0
 * SPDX-FileCopyrightText: The raycore authors
 *
 * RCFramework.h: a window, an EGL context and a frame loop around a RayCore program. C++11. [G A, D 1.4]
 *
 *   #include "RCFramework.h"
 *   class Program : public RCFramework {
 *    public:
 *     Program() : RCFramework("Title", 800, 480) {}
 *    protected:
 *     BOOL OnIntialize() override { ...; return TRUE; }  // camera, textures, materials, static scene
 *     BOOL OnDraw() override { ...; return TRUE; }       // the frame's dynamic geometry; FALSE ends
 *   };
 *   Program g_program;                                   // one global object; main comes from the library
 *
 * Esc, or closing the window, ends the program; Alt+Enter toggles full screen. Without a display the program
 * runs off-screen all the same. Arguments: [word] [width height] [0-3: rendering hint].
 */
#ifndef RCFRAMEWORK_H
#define RCFRAMEWORK_H

#include <EGL/egl.h>
#include <RC/rc.h>
#include <RC/rcu.h>
#include <stdio.h>
#include <stdlib.h>

#include "STDInterface.h"

/* Mouse buttons of OnMouseEvent; they add up. */
enum { MOUSE_BTN_NULL = 0, MOUSE_BTN_LEFT = 1, MOUSE_BTN_RIGHT = 2, MOUSE_BTN_MIDDLE = 4 };

/* What OnKeyDown gets for keys that are no letters (capitals) or digits. */
enum { RC_KEY_PLUS = 91, RC_KEY_MINUS = 92, RC_KEY_UP = 93, RC_KEY_DOWN = 94, RC_KEY_LEFT = 95, RC_KEY_RIGHT = 96 };

/* What a window system does for the framework. */
class PlatformBase {
 public:
  virtual ~PlatformBase() {}

  /* Opens a window; width and height are in pixels and may be changed to what was got. */
  virtual BOOL Create(const char *title, int &width, int &height) = 0;
  virtual void Destroy() = 0;
  /* 0 where there is no window system: the program runs off-screen. */
  virtual EGLNativeWindowType GetWindowHandle() = 0;
  /* Handles waiting events; FALSE once the user has asked to end. */
  virtual BOOL PumpMessage(BOOL dispatch = TRUE) = 0;
  virtual void KeyDownEvent(char key) = 0;
  /* x, y: position as a fraction of the window, 0 ... 1 from the upper left corner. */
  virtual void OnMouseEvent(float x, float y, DWORD buttons = MOUSE_BTN_NULL) = 0;
  virtual void OnDrawComplete() = 0;

  int Width() { return m_iWidth; }
  int Height() { return m_iHeight; }

 protected:
  int m_iWidth = 0, m_iHeight = 0;
};

/* X11. */
class WindowPlatform : public PlatformBase {
 public:
  WindowPlatform();
  ~WindowPlatform() override;
  WindowPlatform(const WindowPlatform &) = delete;
  WindowPlatform &operator=(const WindowPlatform &) = delete;

  BOOL Create(const char *title, int &width, int &height) override;
  void Destroy() override;
  EGLNativeWindowType GetWindowHandle() override;
  BOOL PumpMessage(BOOL dispatch = TRUE) override;
  void OnDrawComplete() override;

 protected:
  void SetTitle(const char *title);
  void ToggleFullScreen();

 private:
  void AskForFullScreen();
  void FillScreen();
  void HandleKeyEvent(unsigned long symbol, unsigned state, BOOL dispatch);
  void TellMouse(int x, int y, DWORD buttons);

  struct Window;
  Window *m_pWindow; /* null where there is no display */
};

class RCFramework : protected WindowPlatform {
 public:
  /* title: the window's, kept by pointer; size in pixels, which arguments of the program may override. */
  RCFramework(const char *title, int width, int height);

  /* What main calls: FALSE if the window, EGL or OnIntialize failed. */
  BOOL Initialize(int argc, char **argv);
  BOOL Initialize() { return Initialize(0, nullptr); }
  /* One frame; FALSE once the program is to end. */
  BOOL DrawScene();
  void Release();
  /* Whether the program ended because something failed. */
  BOOL Failed() const { return m_bFailed; }

  /* Keys go to the framework's own (see docs/framework.md), the others to OnKeyDown. */
  void KeyDownEvent(char key) override;
  /* By how many steps a program that animates should advance: 1, 2, 4 or 8 (keys left and right). */
  virtual int SkipFrame();
  /* Generations of secondary rays, limited to 14. */
  void SetDepthBounce(unsigned bounces);
  /* Second generation; stored, without effect on the picture yet. Limited to 8191, 32 and 10. [beyond the guide] */
  void SetLightRadius(float radius);
  void SetSPPCount(unsigned count);
  void SetDiffuseRate(unsigned rate);
  /* RAYCORE_TEST=1: programs of the guide end by themselves after three frames. */
  BOOL IsTestMode() const;

  EGLDisplay CurrentDisplay() { return m_eglDisplay; }
  EGLContext CurrentContext() { return m_eglContext; }
  EGLSurface CurrentSurface() { return m_eglSurface; }
  using PlatformBase::Height;
  using PlatformBase::Width;

  /* The object of the program; the last one constructed. */
  static RCFramework *Instance();

 protected:
  ~RCFramework() override;

  /* Once, with a current context. FALSE ends the program. (The name is the guide's.) */
  virtual BOOL OnIntialize();
  /* Once at the end, with a current context, if OnIntialize was called. */
  virtual void OnRelease();
  /* Each frame: submit what moves. FALSE ends; so does an error that rcGetError reports afterwards. */
  virtual BOOL OnDraw();
  /* After the frame was shown. FALSE ends. */
  virtual BOOL OnPostDraw();
  /* A key that is not one of the framework's. */
  virtual void OnKeyDown(char key);
  void OnMouseEvent(float x, float y, DWORD buttons = MOUSE_BTN_NULL) override;

  struct {
    int argc;
    char **argv;
  } m_Cmd;

 private:
  BOOL InitializeEgl();
  void InitializeState();
  BOOL Fail(const char *what);
  void CountFrame();
  BOOL ShowFrame();
  void StepThreshold(int step);
  void StepRendering(int step);
  bool HandleKey(char key);

  EGLDisplay m_eglDisplay = EGL_NO_DISPLAY;
  EGLContext m_eglContext = EGL_NO_CONTEXT;
  EGLSurface m_eglSurface = EGL_NO_SURFACE;
  const char *m_sTitle;
  int m_iRendering = 1; /* of RC_DONT_CARE, FASTEST, NICEST, FASTEST_AND_NICEST */
  int m_iThreshold = 0; /* level; -1: none */
  int m_iBounces = 10;
  unsigned m_uFirstBounces = 10; /* what a new context begins with */
  int m_iSkip = 0;               /* exponent of SkipFrame */
  bool m_bMipmap = true;
  bool m_bInitialized = false;
  bool m_bFailed = false;
  int m_iFrames = 0;   /* since the title was last changed */
  double m_dSince = 0; /* when, in seconds */
  /* Seconds of these frames: what OnDraw took, rcFinish, the swap. */
  double m_dDrawing = 0, m_dTracing = 0, m_dShowing = 0;
};

#endif /* RCFRAMEWORK_H */
