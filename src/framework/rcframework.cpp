// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// The life of a program: window and EGL, OnIntialize, frames, OnRelease. [spec 6; reference 6.2]
#include "RCFramework.h"

#include <string.h>

#include <algorithm>
#include <chrono>

namespace {

// Set by the constructor of a global object, maybe before any other global of this library exists.
RCFramework *gInstance = nullptr;

constexpr RCenum kRenderingHints[] = {RC_DONT_CARE, RC_FASTEST, RC_NICEST, RC_FASTEST_AND_NICEST};
constexpr int kFirstRendering = 1;
constexpr int kLastThreshold = 7;
constexpr int kMostBounces = 14;
constexpr int kMostSkip = 3;
constexpr int kFramesPerTitle = 10;

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

// Sizes given as arguments are rounded down to a multiple of 16; 0 for what is no size.
int sizeArgument(const char *text) { return std::max(std::min(atoi(text), 16384), 0) & ~15; }

}  // namespace

RCFramework::RCFramework(const char *title, int width, int height) : m_Cmd{0, nullptr}, m_sTitle(title) {
  m_iWidth = width;
  m_iHeight = height;
  gInstance = this;
}

RCFramework::~RCFramework() {
  if (gInstance == this) gInstance = nullptr;
}

RCFramework *RCFramework::Instance() { return gInstance; }

BOOL RCFramework::OnIntialize() { return TRUE; }
void RCFramework::OnRelease() {}
BOOL RCFramework::OnDraw() { return TRUE; }
BOOL RCFramework::OnPostDraw() { return TRUE; }
void RCFramework::OnKeyDown(char) {}
void RCFramework::OnMouseEvent(float, float, DWORD) {}

BOOL RCFramework::IsTestMode() const {
  const char *test = getenv("RAYCORE_TEST");
  return test && !strcmp(test, "1");
}

BOOL RCFramework::Fail(const char *what) {
  fprintf(stderr, "RCFramework: %s\n", what);
  m_bFailed = true;
  return FALSE;
}

BOOL RCFramework::Initialize(int argc, char **argv) {
  m_Cmd = {argc, argv};
  if (argc >= 4) {
    const int width = sizeArgument(argv[2]), height = sizeArgument(argv[3]);
    if (width > 0 && height > 0) {
      m_iWidth = width;
      m_iHeight = height;
    }
    printf("Current resolution : %dx%d\n", m_iWidth, m_iHeight);
  }
  if (!Create(m_sTitle, m_iWidth, m_iHeight)) return Fail("no window could be opened");
  if (!InitializeEgl()) return FALSE;
  RCint bounces = 0;
  rcGetIntegerv(RC_DEPTH_BOUNCE, &bounces);  // 10, or 1 in the second generation: the library knows the profile
  m_uFirstBounces = static_cast<unsigned>(bounces);
  InitializeState();
  m_bInitialized = true;
  m_dSince = seconds();
  if (OnIntialize()) return TRUE;
  return Fail("OnIntialize failed");
}

BOOL RCFramework::InitializeEgl() {
  const EGLint wanted[] = {
      EGL_RED_SIZE,      8,       EGL_GREEN_SIZE, 8, EGL_BLUE_SIZE, 8, EGL_DEPTH_SIZE, 16, EGL_RENDERABLE_TYPE,
      EGL_OPENGL_ES_BIT, EGL_NONE};
  const EGLint version[] = {EGL_CONTEXT_CLIENT_VERSION, 1, EGL_NONE};
  const EGLint offScreen[] = {EGL_WIDTH, m_iWidth, EGL_HEIGHT, m_iHeight, EGL_NONE};
  EGLConfig config;
  EGLint count = 0;
  m_eglDisplay = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  if (!eglInitialize(m_eglDisplay, nullptr, nullptr)) return Fail("eglInitialize failed");
  if (!eglChooseConfig(m_eglDisplay, wanted, &config, 1, &count) || count == 0) return Fail("eglChooseConfig failed");
  m_eglSurface = GetWindowHandle() ? eglCreateWindowSurface(m_eglDisplay, config, GetWindowHandle(), nullptr)
                                   : eglCreatePbufferSurface(m_eglDisplay, config, offScreen);
  if (m_eglSurface == EGL_NO_SURFACE) return Fail("there is no EGL surface for the program");
  m_eglContext = eglCreateContext(m_eglDisplay, config, EGL_NO_CONTEXT, version);
  if (m_eglContext == EGL_NO_CONTEXT) return Fail("eglCreateContext failed");
  if (eglMakeCurrent(m_eglDisplay, m_eglSurface, m_eglSurface, m_eglContext) != EGL_TRUE) {
    return Fail("eglMakeCurrent failed");
  }
  return TRUE;
}

// What every program finds set; key I brings it back. [reference 6.2]
void RCFramework::InitializeState() {
  rcEnable(RC_LIGHTING);
  rcEnable(RC_USE_SHADOW);
  m_bMipmap = true;
  rcHint(RC_MIPMAP_HINT, RC_FASTEST);
  m_iThreshold = 0;
  StepThreshold(0);
  m_iRendering = m_Cmd.argc >= 5 ? std::clamp(atoi(m_Cmd.argv[4]), 0, 3) : kFirstRendering;
  StepRendering(0);
  SetDepthBounce(m_uFirstBounces);
}

BOOL RCFramework::DrawScene() {
  if (!PumpMessage()) return FALSE;
  const double before = seconds();
  if (!OnDraw()) return FALSE;
  m_dDrawing += seconds() - before;
  const RCenum error = rcGetError();
  if (error != RC_NO_ERROR) {
    fprintf(stderr, "RCFramework: error 0x%04X after OnDraw; RAYCORE_LOG=error shows the call\n", error);
    m_bFailed = true;
    return FALSE;
  }
  if (!ShowFrame()) return FALSE;
  OnDrawComplete();
  if (!PumpMessage()) return FALSE;
  CountFrame();
  return OnPostDraw();
}

BOOL RCFramework::ShowFrame() {
  const double before = seconds();
  rcFinish();
  const double traced = seconds();
  // The window may be closed while a frame is traced: then the events say so.
  if (!eglSwapBuffers(m_eglDisplay, m_eglSurface) && PumpMessage()) return Fail("eglSwapBuffers failed");
  m_dTracing += traced - before;
  m_dShowing += seconds() - traced;
  return TRUE;
}

void RCFramework::CountFrame() {
  if (++m_iFrames < kFramesPerTitle) return;
  const double now = seconds();
  const auto milliseconds = [&](double sum) { return sum * 1000 / m_iFrames; };
  char title[256];
  snprintf(title, sizeof title, "%s : %.2f fps (draw %.2f ms, trace %.2f ms, show %.2f ms)", m_sTitle,
           m_iFrames / std::max(now - m_dSince, 1e-9), milliseconds(m_dDrawing), milliseconds(m_dTracing),
           milliseconds(m_dShowing));
  SetTitle(title);
  m_iFrames = 0;
  m_dSince = now;
  m_dDrawing = m_dTracing = m_dShowing = 0;
}

void RCFramework::Release() {
  if (m_bInitialized) OnRelease();
  m_bInitialized = false;
  if (m_eglDisplay != EGL_NO_DISPLAY) {
    eglMakeCurrent(m_eglDisplay, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (m_eglSurface != EGL_NO_SURFACE) eglDestroySurface(m_eglDisplay, m_eglSurface);
    if (m_eglContext != EGL_NO_CONTEXT) eglDestroyContext(m_eglDisplay, m_eglContext);
    eglTerminate(m_eglDisplay);
  }
  m_eglDisplay = EGL_NO_DISPLAY;
  m_eglContext = EGL_NO_CONTEXT;
  m_eglSurface = EGL_NO_SURFACE;
  Destroy();
}

int RCFramework::SkipFrame() { return 1 << m_iSkip; }

void RCFramework::SetDepthBounce(unsigned bounces) {
  m_iBounces = static_cast<int>(std::min(bounces, unsigned{kMostBounces}));
  rcDepthBounce(static_cast<RCuint>(m_iBounces));
}

void RCFramework::SetLightRadius(float radius) { rcSetLightRadius(std::clamp(radius, 0.0f, 8191.0f)); }

void RCFramework::SetSPPCount(unsigned count) { rcSetSPPCount(std::clamp(count, 1u, 32u)); }

void RCFramework::SetDiffuseRate(unsigned rate) { rcSetDiffuseRate(std::min(rate, 10u)); }

void RCFramework::StepThreshold(int step) {
  m_iThreshold = std::clamp(m_iThreshold + step, -1, kLastThreshold);
  rcHint(RC_RAYBOUNCE_THRESHOLD_HINT,
         m_iThreshold < 0 ? RC_DONT_CARE : static_cast<RCenum>(RC_THRESHOLD_LEVEL0 + m_iThreshold));
}

void RCFramework::StepRendering(int step) {
  m_iRendering = std::clamp(m_iRendering + step, 0, 3);
  rcHint(RC_RENDERING_HINT, kRenderingHints[m_iRendering]);
}

// The framework's own keys. [reference 6.4] False for keys that are the program's.
bool RCFramework::HandleKey(char key) {
  switch (key) {
    case 'S':
      rcIsEnabled(RC_USE_SHADOW) ? rcDisable(RC_USE_SHADOW) : rcEnable(RC_USE_SHADOW);
      return true;
    case 'X':
      m_bMipmap = !m_bMipmap;
      rcHint(RC_MIPMAP_HINT, m_bMipmap ? RC_FASTEST : RC_NICEST);
      return true;
    case 'Q':
      StepThreshold(1);
      return true;
    case 'W':
      StepThreshold(-1);
      return true;
    case RC_KEY_PLUS:
      SetDepthBounce(unsigned(m_iBounces + 1));
      return true;
    case RC_KEY_MINUS:
      SetDepthBounce(unsigned(std::max(m_iBounces - 1, 0)));
      return true;
    case RC_KEY_UP:
      StepRendering(1);
      return true;
    case RC_KEY_DOWN:
      StepRendering(-1);
      return true;
    case RC_KEY_LEFT:
      m_iSkip = std::max(m_iSkip - 1, 0);
      return true;
    case RC_KEY_RIGHT:
      m_iSkip = std::min(m_iSkip + 1, kMostSkip);
      return true;
    default:
      return false;
  }
}

void RCFramework::KeyDownEvent(char key) {
  if (key == 'I') InitializeState();  // and the program may reset its own things
  if (!HandleKey(key)) OnKeyDown(key);
}
