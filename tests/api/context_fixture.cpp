// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "api/context_fixture.h"

namespace rc::test {
void MemorySurface::resize(int newWidth, int newHeight) {
  width = newWidth;
  height = newHeight;
  pixels.assign(size_t(width) * size_t(height), 0);
}

void ContextTest::useProfile(const std::string &profile) {
  Settings settings;
  settings.profile = profile;
  useSettings(settings);
}

void ContextTest::useSettings(Settings settings) {
  settings.threads = 1;
  context = std::make_unique<api::Context>(settings);
  context->attach(&surface);
  api::setCurrentContext(context.get());
  const auto keep = [](RCenum, RCenum, RCuint, RCenum, RCsizei length, const RCchar *text, const RCvoid *kept) {
    static_cast<std::string *>(const_cast<RCvoid *>(kept))->assign(text, size_t(length));
  };
  rcDebugMessageCallbackRCX(keep, &message);
}

void ContextTest::TearDown() {
  api::setCurrentContext(nullptr);
  context.reset();
}

void ContextTest::pixelCamera() {
  rcViewport(0, 0, kWidth, kHeight);
  rcFrustumf(-kWidth / 2, kWidth / 2, -kHeight / 2, kHeight / 2, 64, 1000);
  rcuLookAt(kWidth / 2, kHeight / 2, 64, kWidth / 2, kHeight / 2, 0, 0, 1, 0);
}

void ContextTest::paint(float red, float green, float blue) {
  const float ambient[] = {red, green, blue}, diffuse[] = {0, 0, 0};
  rcMaterialfv(RC_FRONT_AND_BACK, RC_AMBIENT, ambient);
  rcMaterialfv(RC_FRONT_AND_BACK, RC_DIFFUSE, diffuse);
}

void ContextTest::drawQuad(const Rect &r, float z) {
  const float vertices[] = {r.x0, r.y0, z, r.x1, r.y0, z, r.x1, r.y1, z, r.x0, r.y1, z};
  rcEnableClientState(RC_VERTEX_ARRAY);
  rcVertexPointer(3, RC_FLOAT, 0, vertices);
  rcDrawArrays(RC_QUADS, 0, 4);
  rcVertexPointer(3, RC_FLOAT, 0, nullptr);
  rcDisableClientState(RC_VERTEX_ARRAY);
}

void ContextTest::drawClockwiseQuad(const Rect &r, float z) { drawQuad({r.x1, r.y0, r.x0, r.y1}, z); }

void ContextTest::drawColouredQuad(const Rect &rect, const std::vector<float> &colours, float z) {
  rcEnableClientState(RC_COLOR_ARRAY);
  rcColorPointer(4, RC_FLOAT, 0, colours.data());
  drawQuad(rect, z);
  rcColorPointer(4, RC_FLOAT, 0, nullptr);
  rcDisableClientState(RC_COLOR_ARRAY);
}

void ContextTest::drawTexturedQuad(const Rect &rect, float u, float v, float z) {
  const float coordinates[] = {0, 0, u, 0, u, v, 0, v};
  rcEnableClientState(RC_TEXTURE_COORD_ARRAY);
  rcTexCoordPointer(2, RC_FLOAT, 0, coordinates);
  drawQuad(rect, z);
  rcTexCoordPointer(2, RC_FLOAT, 0, nullptr);
  rcDisableClientState(RC_TEXTURE_COORD_ARRAY);
}

void ContextTest::drawTriangles(const std::vector<float> &vertices) {
  rcEnableClientState(RC_VERTEX_ARRAY);
  rcVertexPointer(3, RC_FLOAT, 0, vertices.data());
  rcDrawArrays(RC_TRIANGLES, 0, static_cast<RCsizei>(vertices.size() / 3));
  rcVertexPointer(3, RC_FLOAT, 0, nullptr);
  rcDisableClientState(RC_VERTEX_ARRAY);
}

void ContextTest::loadColumns(const Colour &low, const Colour &high) {
  std::vector<RCubyte> texels;
  for (int i = 0; i < 16 * 16; ++i) {
    for (int channel : i % 16 < 8 ? low : high) texels.push_back(static_cast<RCubyte>(channel));
  }
  rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGB, 16, 16, 0, RC_RGB, RC_UNSIGNED_BYTE, texels.data());
}

void ContextTest::loadRgba(int red, int green, int blue, int alpha) {
  std::vector<RCubyte> texels;
  for (int i = 0; i < 16 * 16; ++i) {
    for (int channel : {red, green, blue, alpha}) texels.push_back(static_cast<RCubyte>(channel));
  }
  rcTexImage2D(RC_TEXTURE_2D, 0, RC_RGBA, 16, 16, 0, RC_RGBA, RC_UNSIGNED_BYTE, texels.data());
}

void ContextTest::lightFrom(float x, float y, float z, float w, float diffuse) {
  const float position[] = {x, y, z, w}, black[] = {0, 0, 0, 0}, strength[] = {diffuse, diffuse, diffuse, 0};
  rcLightfv(RC_LIGHT0, RC_POSITION, position);
  rcLightfv(RC_LIGHT0, RC_AMBIENT, black);
  rcLightfv(RC_LIGHT0, RC_DIFFUSE, strength);
  rcEnable(RC_LIGHTING);
  rcEnable(RC_LIGHT0);
}

void ContextTest::paintDiffuse(float red, float green, float blue) {
  const float ambient[] = {0, 0, 0}, diffuse[] = {red, green, blue};
  rcMaterialfv(RC_FRONT_AND_BACK, RC_AMBIENT, ambient);
  rcMaterialfv(RC_FRONT_AND_BACK, RC_DIFFUSE, diffuse);
}

void ContextTest::trace() {
  rcFinish();
  context->endFrame();
}

Colour ContextTest::pixel(int x, int yFromBottom) const {
  const uint32_t rgba = surface.pixels[size_t(surface.height - 1 - yFromBottom) * size_t(surface.width) + size_t(x)];
  return {int(rgba & 255), int(rgba >> 8 & 255), int(rgba >> 16 & 255)};
}

RCint ContextTest::integer(RCenum pname) const {
  RCint values[16] = {-12345};
  rcGetIntegerv(pname, values);
  return values[0];
}

std::vector<float> ContextTest::floats(RCenum pname, size_t count) const {
  std::vector<float> values(16, -12345);
  rcGetFloatv(pname, values.data());
  values.resize(count);
  return values;
}

std::vector<float> ContextTest::material(RCenum pname, size_t count) const {
  std::vector<float> values(4, -12345);
  rcGetMaterialfv(RC_FRONT_AND_BACK, pname, values.data());
  values.resize(count);
  return values;
}

std::vector<float> ContextTest::light(RCenum name, RCenum pname, size_t count) const {
  std::vector<float> values(4, -12345);
  rcGetLightfv(name, pname, values.data());
  values.resize(count);
  return values;
}

RCint ContextTest::texParameter(RCenum pname, RCenum target) const {
  RCint values[4] = {-12345};
  rcGetTexParameteriv(target, pname, values);
  return values[0];
}

std::array<float, 16> ContextTest::modelview() const {
  std::array<float, 16> values;
  rcGetFloatv(RC_MODELVIEW_MATRIX, values.data());
  return values;
}

std::vector<float> ContextTest::clipPlane(RCenum plane) const {
  std::vector<float> values(4, -12345);
  rcGetClipPlanef(plane, values.data());
  return values;
}

std::vector<float> ContextTest::texEnv(RCenum pname, size_t count, RCenum target) const {
  std::vector<float> values(4, -12345);
  rcGetTexEnvfv(target, pname, values.data());
  values.resize(count);
  return values;
}

}  // namespace rc::test
