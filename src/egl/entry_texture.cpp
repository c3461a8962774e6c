// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: surfaces as textures, textures as images. [EGL 1.5, 3.6, 3.9]
// A texture may be in use by the trace of a context that shares it: handles are looked up under the display lock, and
// what waits for the trace is done without it.
#include "egl/entry.h"
#include "egl/twins.h"

using namespace rc;
using namespace rc::egl;

namespace {

// The surface of eglBindTexImage and eglReleaseTexImage.
std::shared_ptr<Surface> texturableSurface(EGLDisplay dpy, EGLSurface handle, EGLint buffer) {
  const std::lock_guard lock(displayMutex());
  auto surface = surfaceOf(initializedDisplay(dpy), handle);
  require(buffer == EGL_BACK_BUFFER, EGL_BAD_PARAMETER);
  require(surface->kind() == EGL_PBUFFER_BIT, EGL_BAD_SURFACE);
  require(surface->attributes.textureFormat != EGL_NO_TEXTURE, EGL_BAD_MATCH);
  return surface;
}

// What it shows. A surface that another thread draws to, or may begin to, does not keep still.
TextureBinding::Copy copyOf(const ThreadState &thread, const std::shared_ptr<Surface> &surface) {
  const Current &current = thread.current;
  const uint32_t alpha = current.context->api.state.texture.alpha;
  if (current.draw == surface) current.context->api.complete();
  if (current.draw == surface || current.read == surface) return TextureBinding::copyOf(*surface, alpha);
  const std::lock_guard lock(displayMutex());
  require(!surface->current, EGL_BAD_ACCESS);
  return TextureBinding::copyOf(*surface, alpha);
}

struct ImageAttributes {
  EGLint level = 0;
};

ImageAttributes readImageAttributes(Attributes list) {
  ImageAttributes wanted;
  for (; list.more(); list.advance()) {
    if (list.name() == EGL_GL_TEXTURE_LEVEL) {
      wanted.level = list.number();
    } else {  // preserved or not, the texture keeps its texels
      require(list.name() == EGL_IMAGE_PRESERVED && booleanValue(list.number()), EGL_BAD_PARAMETER);
    }
  }
  return wanted;
}

std::shared_ptr<RenderContext> sourceOf(EGLDisplay dpy, EGLContext handle) {
  const std::lock_guard lock(displayMutex());
  Display &display = initializedDisplay(dpy);
  return handle == EGL_NO_CONTEXT ? nullptr : contextOf(display, handle);
}

// The loaded texture of a name in a context.
std::shared_ptr<ddk::Texture> textureOf(RenderContext &context, EGLClientBuffer buffer, EGLint level) {
  const auto name = reinterpret_cast<uintptr_t>(buffer);
  const std::lock_guard lock(context.api.objects().mutex);
  const bool isName = name != 0 && name <= UINT32_MAX;
  auto texture = isName ? context.api.objects().textures.find(static_cast<RCuint>(name)) : nullptr;
  require(texture && texture->loaded(), EGL_BAD_PARAMETER);
  require(level >= 0 && size_t(level) < texture->image->levels.size(), EGL_BAD_MATCH);
  return texture;
}

}  // namespace

namespace rc::egl {

EGLImage createImage(EGLDisplay dpy, EGLContext handle, EGLenum target, EGLClientBuffer buffer, Attributes list) {
  const auto context = sourceOf(dpy, handle);
  require(target == EGL_GL_TEXTURE_2D, EGL_BAD_PARAMETER);
  require(context != nullptr, EGL_BAD_MATCH);
  auto texture = textureOf(*context, buffer, readImageAttributes(list).level);
  const std::lock_guard lock(displayMutex());
  Display &display = initializedDisplay(dpy);
  const bool ofSurface = display.surfaces.any([&](const Surface &other) { return other.texture.boundTo(*texture); });
  const bool ofImage = display.images.any([&](const Image &other) { return other.texture == texture; });
  require(!ofSurface && !ofImage, EGL_BAD_ACCESS);
  return display.images.add(std::make_shared<Image>(std::move(texture)));
}

}  // namespace rc::egl

extern "C" {

EGLBoolean eglBindTexImage(EGLDisplay dpy, EGLSurface handle, EGLint buffer) {
  return enterUnlocked<EGLBoolean>(EGL_FALSE, [&](ThreadState &thread) {
    const auto surface = texturableSurface(dpy, handle, buffer);
    const auto &context = thread.current.context;
    if (!context) return EGL_TRUE;  // there is no texture to bind to
    require(surface->texture.bind(context->api, *surface, copyOf(thread, surface)), EGL_BAD_ACCESS);
    return EGL_TRUE;
  });
}

EGLBoolean eglReleaseTexImage(EGLDisplay dpy, EGLSurface handle, EGLint buffer) {
  return enterUnlocked<EGLBoolean>(EGL_FALSE, [&](ThreadState &) {
    texturableSurface(dpy, handle, buffer)->texture.release();
    return EGL_TRUE;
  });
}

EGLImage eglCreateImage(EGLDisplay dpy, EGLContext context, EGLenum target, EGLClientBuffer buffer,
                        const EGLAttrib *attributes) {
  return enterUnlocked<EGLImage>(
      EGL_NO_IMAGE, [&](ThreadState &) { return createImage(dpy, context, target, buffer, Attributes(attributes)); });
}

EGLBoolean eglDestroyImage(EGLDisplay dpy, EGLImage image) {
  return enter<EGLBoolean>(EGL_FALSE, [&](ThreadState &) {
    Display &display = initializedDisplay(dpy);
    display.images.destroy(*objectOf(display.images, image, EGL_BAD_PARAMETER));
    return EGL_TRUE;
  });
}

}  // extern "C"
