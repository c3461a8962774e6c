// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// surface_attributes.h: what surfaces are made with, and what can be asked about them. [EGL 1.5, 3.5, table 3.5]
#pragma once

#include <EGL/egl.h>

#include <optional>

#include "egl/attributes.h"
#include "egl/config.h"

namespace rc::egl {

class Surface;

struct SurfaceAttributes {
  EGLint width = 0, height = 0;
  EGLint largestPbuffer = EGL_FALSE;
  EGLint textureFormat = EGL_NO_TEXTURE, textureTarget = EGL_NO_TEXTURE;
  EGLint mipmapTexture = EGL_FALSE, mipmapLevel = 0;
  EGLint renderBuffer = EGL_BACK_BUFFER;
  EGLint swapBehavior = EGL_BUFFER_PRESERVED;
  EGLint multisampleResolve = EGL_MULTISAMPLE_RESOLVE_DEFAULT;
  EGLint glColorspace = EGL_GL_COLORSPACE_LINEAR;
  EGLint vgColorspace = EGL_VG_COLORSPACE_sRGB, vgAlphaFormat = EGL_VG_ALPHA_FORMAT_NONPRE;
};

// kind: EGL_WINDOW_BIT, EGL_PBUFFER_BIT or EGL_PIXMAP_BIT. Throws EglError for what such a surface of this config
// cannot have.
SurfaceAttributes readSurfaceAttributes(EGLint kind, const Config &config, Attributes list);

// eglSurfaceAttrib; throws EglError.
void setSurfaceAttribute(Surface &surface, EGLint name, EGLint value);

// eglQuerySurface; nothing for what this kind of surface does not have; throws EglError for no attribute of surfaces.
std::optional<EGLint> surfaceAttribute(const Surface &surface, EGLint name);

}  // namespace rc::egl
