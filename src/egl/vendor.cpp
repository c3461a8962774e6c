// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// libEGL_raycore.so.0: what libglvnd's libEGL.so.1 loads to reach libRayCoreAPI.so, whose EGL it passes on. There is
// one implementation and one current context, whichever way a program comes. [libglvnd: glvnd/libeglabi.h]
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>
#include <glvnd/libeglabi.h>

#include <algorithm>
#include <cstring>
#include <iterator>

namespace {

using Function = __eglMustCastToProperFunctionPointerType;

const __EGLapiExports *sLibrary = nullptr;

// Looked up in that library alone: in the process the name means libEGL's own function.
Function raycoreFunction(const char *name) {
  using GetProcAddress = Function (*)(const char *);
  static const auto get = [] {
    void *library = dlopen("libRayCoreAPI.so", RTLD_NOW | RTLD_LOCAL);
    return library ? reinterpret_cast<GetProcAddress>(dlsym(library, "eglGetProcAddress")) : nullptr;
  }();
  return get ? get(name) : nullptr;
}

template <class Type>
Type raycore(const char *name) {
  return reinterpret_cast<Type>(raycoreFunction(name));
}

// Functions that libEGL does not know: it calls ours, and we find whose the display is.
struct Dispatched {
  const char *name;
  Function function;
  int index;  // which libEGL gives us
};

template <size_t Row, class Result, class... Arguments>
Result dispatch(EGLDisplay display, Arguments... arguments);

template <size_t Row, class Result, class... Arguments>
Dispatched row(const char *name, Result (*)(EGLDisplay, Arguments...)) {
  return {name, reinterpret_cast<Function>(&dispatch<Row, Result, Arguments...>), -1};
}

Dispatched sDispatched[] = {
    row<0>("eglClientWaitSyncKHR", PFNEGLCLIENTWAITSYNCKHRPROC()),
    row<1>("eglCreateImageKHR", PFNEGLCREATEIMAGEKHRPROC()),
    row<2>("eglCreatePlatformPixmapSurfaceEXT", PFNEGLCREATEPLATFORMPIXMAPSURFACEEXTPROC()),
    row<3>("eglCreatePlatformWindowSurfaceEXT", PFNEGLCREATEPLATFORMWINDOWSURFACEEXTPROC()),
    row<4>("eglCreateSyncKHR", PFNEGLCREATESYNCKHRPROC()),
    row<5>("eglDestroyImageKHR", PFNEGLDESTROYIMAGEKHRPROC()),
    row<6>("eglDestroySyncKHR", PFNEGLDESTROYSYNCKHRPROC()),
    row<7>("eglGetSyncAttribKHR", PFNEGLGETSYNCATTRIBKHRPROC()),
    row<8>("eglSwapBuffersWithDamageKHR", PFNEGLSWAPBUFFERSWITHDAMAGEKHRPROC()),
    row<9>("eglWaitSyncKHR", PFNEGLWAITSYNCKHRPROC()),
};

template <size_t Row, class Result, class... Arguments>
Result dispatch(EGLDisplay display, Arguments... arguments) {
  sLibrary->threadInit();
  __EGLvendorInfo *vendor = sLibrary->getVendorFromDisplay(display);
  if (!vendor) {
    sLibrary->setEGLError(EGL_BAD_DISPLAY);
    return Result();
  }
  sLibrary->setLastVendor(vendor);
  const Function target = sLibrary->fetchDispatchEntry(vendor, sDispatched[Row].index);
  if (!target) {
    sLibrary->setEGLError(EGL_BAD_DISPLAY);
    return Result();
  }
  return reinterpret_cast<Result (*)(EGLDisplay, Arguments...)>(target)(display, arguments...);
}

Dispatched *find(const char *name) {
  auto *found = std::find_if(std::begin(sDispatched), std::end(sDispatched),
                             [&](const Dispatched &function) { return !std::strcmp(function.name, name); });
  return found == std::end(sDispatched) ? nullptr : found;
}

// platform: EGL_NONE for eglGetDisplay(EGL_DEFAULT_DISPLAY).
EGLDisplay getPlatformDisplay(EGLenum platform, void *native, const EGLAttrib *attributes) {
  if (platform == EGL_NONE) return raycore<PFNEGLGETDISPLAYPROC>("eglGetDisplay")(EGL_DEFAULT_DISPLAY);
  return raycore<PFNEGLGETPLATFORMDISPLAYPROC>("eglGetPlatformDisplay")(platform, native, attributes);
}

EGLBoolean getSupportsApi(EGLenum api) { return api == EGL_OPENGL_ES_API; }

const char *getVendorString(int name) {
  return name == __EGL_VENDOR_STRING_PLATFORM_EXTENSIONS
             ? "EGL_EXT_platform_x11 EGL_KHR_platform_x11 EGL_MESA_platform_surfaceless"
             : nullptr;
}

// libEGL asks for gl* too, to call them while our context is current. Ours would call libGLESv1_CM's, and those ours.
void *getProcAddress(const char *name) {
  const bool isGl = !std::strncmp(name, "gl", 2);
  return isGl ? nullptr : reinterpret_cast<void *>(raycoreFunction(name));
}

void *getDispatchAddress(const char *name) {
  const Dispatched *found = find(name);
  return found ? reinterpret_cast<void *>(found->function) : nullptr;
}

void setDispatchIndex(const char *name, int index) {
  if (Dispatched *found = find(name)) found->index = index;
}

}  // namespace

extern "C" __attribute__((visibility("default"))) EGLBoolean __egl_Main(uint32_t version,
                                                                        const __EGLapiExports *exports,
                                                                        __EGLvendorInfo *, __EGLapiImports *imports) {
  if (EGL_VENDOR_ABI_GET_MAJOR_VERSION(version) != EGL_VENDOR_ABI_MAJOR_VERSION) return EGL_FALSE;
  if (!raycoreFunction("eglGetPlatformDisplay")) return EGL_FALSE;
  sLibrary = exports;
  imports->getPlatformDisplay = getPlatformDisplay;
  imports->getSupportsAPI = getSupportsApi;
  imports->getVendorString = getVendorString;
  imports->getProcAddress = getProcAddress;
  imports->getDispatchAddress = getDispatchAddress;
  imports->setDispatchIndex = setDispatchIndex;
  return EGL_TRUE;
}
