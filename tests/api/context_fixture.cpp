// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "api/context_fixture.h"

namespace rc::test {
namespace {

constexpr RCenum kNumbers[] = {RC_VIEWPORT,
                               RC_COLOR_CLEAR_VALUE,
                               RC_DEPTH_BOUNCE,
                               RC_MATRIX_MODE,
                               RC_MODELVIEW_MATRIX,
                               RC_PROJECTION_MATRIX,
                               RC_TEXTURE_MATRIX,
                               RC_MODELVIEW_STACK_DEPTH,
                               RC_CURRENT_COLOR,
                               RC_PROJECTION_STACK_DEPTH,
                               RC_MATERIAL_BINDING,
                               RC_TEXTURE_STACK_DEPTH,
                               RC_VERTEX_ARRAY_TYPE,
                               RC_VERTEX_ARRAY_STRIDE,
                               RC_NORMAL_ARRAY_TYPE,
                               RC_NORMAL_ARRAY_STRIDE,
                               RC_TEXTURE_BINDING_2D,
                               RC_TEXTURE_COORD_ARRAY_TYPE,
                               RC_TEXTURE_COORD_ARRAY_STRIDE};
constexpr RCenum kSwitches[] = {
    RC_LIGHTING,         RC_TEXTURE_2D,       RC_TEXTURE_2D_NORMAL,   RC_USE_SHADOW,
    RC_USE_COLOR_SHADOW, RC_USE_TEXTURE_ONLY, RC_LARGE_TEXTURES,      RC_USE_TRANSMITTANCE_SHADOW,
    RC_VERTEX_ARRAY,     RC_NORMAL_ARRAY,     RC_TEXTURE_COORD_ARRAY, RC_USE_TEXTURE_ALPHA_SHADOW};
constexpr RCenum kMaterialValues[] = {RC_AMBIENT,          RC_DIFFUSE,        RC_SPECULAR,   RC_EMISSION,
                                      RC_SHININESS,        RC_SPECULAR_LEVEL, RC_REFLECTION, RC_TRANSMITTANCE,
                                      RC_REFRACTION_INDEX, RC_ROUGHNESS};
constexpr RCenum kLightValues[] = {RC_AMBIENT,
                                   RC_DIFFUSE,
                                   RC_SPECULAR,
                                   RC_POSITION,
                                   RC_SPOT_DIRECTION,
                                   RC_SPOT_EXPONENT,
                                   RC_SPOT_INNER_CONE,
                                   RC_SPOT_OUTER_CONE,
                                   RC_ATTENUATION_RANGE,
                                   RC_CONSTANT_ATTENUATION,
                                   RC_LINEAR_ATTENUATION,
                                   RC_QUADRATIC_ATTENUATION};
constexpr RCenum kTextureValues[] = {RC_TEXTURE_WRAP_S,     RC_TEXTURE_WRAP_T,  RC_TEXTURE_MIN_FILTER,
                                     RC_TEXTURE_MAG_FILTER, RC_GENERATE_MIPMAP, RC_TEXTURE_OPAQUE_ALPHA};
constexpr RCenum kPointers[] = {RC_VERTEX_ARRAY_POINTER, RC_NORMAL_ARRAY_POINTER, RC_TEXTURE_COORD_ARRAY_POINTER};

}  // namespace

void MemorySurface::resize(int newWidth, int newHeight) {
  width = newWidth;
  height = newHeight;
  pixels.assign(size_t(width) * size_t(height), 0);
}

void ContextTest::useProfile(const std::string &profile) {
  Settings settings;
  settings.device = "cpu";
  settings.threads = 1;
  settings.profile = profile;
  context = std::make_unique<api::Context>(settings);
  context->attach(&surface);
  api::setCurrentContext(context.get());
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

std::vector<double> ContextTest::snapshot() const {
  std::vector<double> all;
  const auto append = [&](const auto &values) { all.insert(all.end(), std::begin(values), std::end(values)); };
  for (RCenum name : kNumbers) append(floats(name, 16));
  for (RCenum name : kSwitches) all.push_back(rcIsEnabled(name));
  for (RCenum name : kMaterialValues) append(material(name, 4));
  for (int i = 0; i < 8; ++i) {
    const RCenum name = RC_LIGHT0 + RCenum(i);
    all.push_back(rcIsEnabled(name));
    for (RCenum value : kLightValues) append(light(name, value, 4));
  }
  for (RCenum target : {RC_TEXTURE_2D, RC_TEXTURE_2D_NORMAL}) {
    for (RCenum name : kTextureValues) all.push_back(texParameter(name, RCenum(target)));
  }
  for (RCenum name : kPointers) {
    RCvoid *pointer = nullptr;
    rcGetPointerv(name, &pointer);
    all.push_back(static_cast<double>(reinterpret_cast<uintptr_t>(pointer)));
  }
  const api::State &state = context->state;
  const ddk::Camera &camera = state.view.camera;
  for (const Vec3 &axis : {camera.eye, camera.right, camera.up, camera.back}) {
    for (int i = 0; i < 3; ++i) all.push_back(axis[i]);
  }
  const ddk::Window &window = camera.window;
  append(std::array{window.left, window.right, window.bottom, window.top, window.near});
  const api::HintState &hints = state.hints;
  append(std::array{hints.mipmap, hints.rendering, hints.rayBounceThreshold, hints.fog, hints.generateMipmap,
                    hints.lineSmooth, hints.perspective, hints.pointSmooth});
  all.push_back(state.texture.alpha);
  all.push_back(double(context->scene.statics().triangles.size()));
  all.push_back(double(context->scene.dynamics().triangles.size()));
  for (RCuint name = 0; name < 520; ++name) all.push_back(rcIsMaterial(name) + 2 * rcIsTexture(name));
  return all;
}

}  // namespace rc::test
