// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "egl/shortage_program.h"

#include <cmath>

#include "RC/rcu.h"

namespace rc::test {
namespace {

// A bumpy sheet of strips of quads, four vertices each.
template <int kCells>
struct Sheet {
  std::array<float, size_t(12) * kCells * kCells> vertices;

  constexpr static int kVertices = 4 * kCells * kCells;

  Sheet() {
    float *next = vertices.data();
    for (int i = 0; i < kCells; ++i) {
      for (int j = 0; j < kCells; ++j) {
        for (const auto &[di, dj] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
          const float x = float(i + di) / kCells - 0.5f, z = float(j + dj) / kCells - 0.5f;
          for (const float value : {2 * x, 0.2f * std::sin(9 * x) * std::cos(8 * z), 2 * z}) *next++ = value;
        }
      }
    }
  }
};

const Sheet<8> kSmall;
const Sheet<66> kLarge;  // 8712 triangles: more than rcddk/accel/builder.cpp calls few

constexpr std::array<RCubyte, 32 * 32 * 4> kTexels = [] {
  std::array<RCubyte, 32 * 32 * 4> texels{};
  for (size_t i = 0; i < texels.size(); ++i) texels[i] = RCubyte(37 * i);
  return texels;
}();

}  // namespace

bool ShortageProgram::failed(bool succeeded) {
  if (!succeeded) mEglError = eglGetError();
  return !succeeded;
}

bool ShortageProgram::open() {
  static constexpr EGLint kSize[] = {EGL_WIDTH, kShortageSide, EGL_HEIGHT, kShortageSide, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  mEglError = EGL_SUCCESS;
  mDisplay = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  if (failed(mDisplay != EGL_NO_DISPLAY)) return false;
  if (failed(eglInitialize(mDisplay, nullptr, nullptr))) return false;
  if (failed(eglChooseConfig(mDisplay, nullptr, &config, 1, &count))) return false;
  if (failed((mSurface = eglCreatePbufferSurface(mDisplay, config, kSize)) != EGL_NO_SURFACE)) return false;
  if (failed((mContext = eglCreateContext(mDisplay, config, EGL_NO_CONTEXT, nullptr)) != EGL_NO_CONTEXT)) return false;
  return !failed(eglMakeCurrent(mDisplay, mSurface, mSurface, mContext));
}

void ShortageProgram::close() {
  eglReleaseThread();
  if (mDisplay != EGL_NO_DISPLAY) eglTerminate(mDisplay);
  eglReleaseThread();
}

void ShortageProgram::note() {
  for (RCenum error; (error = rcGetError()) != RC_NO_ERROR;) {
    if (error == RC_OUT_OF_MEMORY) {
      ++mShortages;
    } else {
      mOther = error;
    }
  }
}

void ShortageProgram::loadTextures() {
  rcBindMaterial(1);
  rcBindTexture(RC_TEXTURE_2D, 1);
  note();
  rcTexParameteri(RC_TEXTURE_2D, RC_TEXTURE_MIN_FILTER, RC_LINEAR_MIPMAP_LINEAR);
  rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGBA, 32, 32, 0, RC_RGBA, RC_UNSIGNED_BYTE, kTexels.data());
  note();
  rcTexSubImage2D(RC_TEXTURE_2D, 0, 4, 4, 16, 8, RC_RGBA, RC_UNSIGNED_BYTE, kTexels.data() + 7);
  note();
  rcBindMaterial(0);
}

void ShortageProgram::loadBuffers() {
  rcBindBuffer(RC_ARRAY_BUFFER, 1);
  note();
  rcBufferData(RC_ARRAY_BUFFER, sizeof kSmall.vertices, kSmall.vertices.data(), RC_STATIC_DRAW);
  note();
}

void ShortageProgram::drawStatics() {
  rcStaticSceneBegin();
  rcBindMaterial(1);
  rcEnable(RC_TEXTURE_2D);
  rcMaterialf(RC_FRONT_AND_BACK, RC_REFLECTION, 0.4f);
  rcVertexPointer(3, RC_FLOAT, 0, nullptr);
  rcTexCoordPointer(2, RC_FLOAT, 3 * sizeof(float), nullptr);
  rcEnableClientState(RC_TEXTURE_COORD_ARRAY);
  note();
  rcDrawArrays(RC_QUADS, 0, kSmall.kVertices);
  note();
  rcDisableClientState(RC_TEXTURE_COORD_ARRAY);
  rcBindBuffer(RC_ARRAY_BUFFER, 0);
  rcBindMaterial(0);
  rcStaticSceneEnd();
  note();
}

void ShortageProgram::drawFrame(int frame) {
  rcPushMatrix();
  note();
  rcTranslatef(0, 0.4f + 0.02f * float(frame), 0);
  rcScalef(0.3f, 0.3f, 0.3f);
  rcVertexPointer(3, RC_FLOAT, 0, mScene.large ? kLarge.vertices.data() : kSmall.vertices.data());
  rcDrawArrays(RC_QUADS, 0, mScene.large ? kLarge.kVertices : kSmall.kVertices);
  note();
  rcPopMatrix();
  rcGetError();                    // of a push that failed
  if (frame % 2 == 0) rcFinish();  // else in the background
  note();
  // A frame that cannot be traced is no frame that ends.
  if (!eglSwapBuffers(mDisplay, mSurface)) ++mShortages;
  eglGetError();
  RCfloat ignored = 0;
  rcGetFloatv(RC_FRAME_RAYS, &ignored);  // waits for the picture
  note();
}

// What calls that failed before may have left to others than the objects they meant.
void ShortageProgram::resetState() {
  rcSceneAllInit();
  rcMatrixMode(RC_MODELVIEW);
  rcLoadIdentity();
  rcBindBuffer(RC_ARRAY_BUFFER, 0);
  rcDisableClientState(RC_TEXTURE_COORD_ARRAY);
  rcBindMaterial(0);
  rcBindTexture(RC_TEXTURE_2D, 0);
  rcMaterialf(RC_FRONT_AND_BACK, RC_REFLECTION, 0);
  rcDisable(RC_TEXTURE_2D);
  note();
}

void ShortageProgram::draw() {
  mShortages = 0;
  mOther = RC_NO_ERROR;
  resetState();
  rcHint(RC_STRUCTURE_HINT, mScene.structure);
  rcClearColor(0.1f, 0.2f, 0.3f, 1);
  rcuPerspective(50, 1, 0.1f, 100);
  rcuLookAt(0.5f, 1.5f, 2.5f, 0, 0, 0, 0, 1, 0);
  rcEnable(RC_LIGHTING);
  rcEnable(RC_LIGHT0);
  rcEnableClientState(RC_VERTEX_ARRAY);
  note();
  loadTextures();
  loadBuffers();
  drawStatics();
  for (int frame = 0; frame < 3; ++frame) drawFrame(frame);
  mPicture.fill(0);
  rcReadPixels(0, 0, kShortageSide, kShortageSide, RC_RGBA, RC_UNSIGNED_BYTE, mPicture.data());
  note();
}

}  // namespace rc::test
