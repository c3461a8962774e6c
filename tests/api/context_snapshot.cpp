// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// ContextTest::snapshot(): the whole state of a context. Every token of the API is tried as a name of state.
#include <algorithm>
#include <set>

#include "api/context_fixture.h"

namespace rc::test {
namespace {

constexpr RCenum kAllTokens[] = {
#define RC_TOKEN(name, value) value,
#include "headers/token_values.inc"
#undef RC_TOKEN
};

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
constexpr RCenum kTextureValues[] = {
    RC_TEXTURE_WRAP_S,  RC_TEXTURE_WRAP_T,       RC_TEXTURE_MIN_FILTER,        RC_TEXTURE_MAG_FILTER,
    RC_GENERATE_MIPMAP, RC_TEXTURE_OPAQUE_ALPHA, RC_TEXTURE_MAX_ANISOTROPY_EXT};
constexpr RCenum kTextureEnvValues[] = {RC_TEXTURE_ENV_MODE, RC_TEXTURE_ENV_COLOR, RC_COMBINE_RGB,  RC_COMBINE_ALPHA,
                                        RC_RGB_SCALE,        RC_ALPHA_SCALE,       RC_SRC0_RGB,     RC_SRC1_RGB,
                                        RC_SRC2_RGB,         RC_SRC0_ALPHA,        RC_SRC1_ALPHA,   RC_SRC2_ALPHA,
                                        RC_OPERAND0_RGB,     RC_OPERAND1_RGB,      RC_OPERAND2_RGB, RC_OPERAND0_ALPHA,
                                        RC_OPERAND1_ALPHA,   RC_OPERAND2_ALPHA};
constexpr RCenum kPointers[] = {RC_VERTEX_ARRAY_POINTER,           RC_NORMAL_ARRAY_POINTER,
                                RC_TEXTURE_COORD_ARRAY_POINTER,    RC_COLOR_ARRAY_POINTER,
                                RC_MATRIX_INDEX_ARRAY_POINTER_OES, RC_WEIGHT_ARRAY_POINTER_OES,
                                RC_POINT_SIZE_ARRAY_POINTER_OES};

// Lights beyond the guide's eight are left out for speed; figures of a frame are no state.
bool isLeftOut(RCenum name) {
  return (name > RC_LIGHT7 && name <= RC_LIGHT1023) || name == RC_FRAME_RAYS || name == RC_FRAME_TRIANGLES ||
         name == RC_FRAME_TRIANGLES_SKIPPED;
}

// The names that rcGetFloatv knows, found once in a context of their own.
const std::vector<RCenum> &stateNames() {
  static const std::vector<RCenum> names = [] {
    api::Context *const current = api::currentContext();
    api::Context probe{Settings{}};
    api::setCurrentContext(&probe);
    std::vector<RCenum> known;
    for (const RCenum name : std::set<RCenum>(std::begin(kAllTokens), std::end(kAllTokens))) {
      float values[16];
      rcGetFloatv(name, values);
      if (rcGetError() == RC_NO_ERROR && !isLeftOut(name)) known.push_back(name);
    }
    api::setCurrentContext(current);
    return known;
  }();
  return names;
}

class Snapshot {
 public:
  std::vector<double> values;

  void add(double value) { values.push_back(value); }
  template <class Range>
  void addAll(const Range &range) {
    values.insert(values.end(), std::begin(range), std::end(range));
  }
  // A number for many bytes.
  void addSum(const void *data, size_t size) {
    const auto *bytes = static_cast<const unsigned char *>(data);
    uint32_t sum = 2166136261u;  // FNV-1a
    for (size_t i = 0; i < size; ++i) sum = (sum ^ bytes[i]) * 16777619u;
    add(double(size));
    add(sum);
  }
  void addBuffer(const api::BufferBinding &binding) {
    if (!binding.buffer) return;
    add(binding.buffer->usage);
    addSum(binding.buffer->bytes.data(), binding.buffer->bytes.size());
  }
  // Of large images the first texels of each level.
  void addTexture(const ddk::Texture &texture) {
    add(int(texture.format));
    if (!texture.loaded()) return;
    addAll(std::array{texture.image->width, texture.image->height});
    for (const auto &level : texture.image->levels) {
      addSum(level.data(), std::min<size_t>(level.size(), 1024) * sizeof(uint32_t));
    }
  }
  void addGeometry(const ddk::GeometrySet &set) {
    const ddk::SkippedTriangles &skipped = set.skipped;
    addAll(std::array{set.triangles.size(), set.captured.size(), skipped.degenerate, skipped.notFinite, skipped.noData,
                      skipped.clipped});
  }
};

}  // namespace

std::vector<double> ContextTest::snapshot() const {
  Snapshot all;
  all.values.reserve(8192);
  for (RCenum name : stateNames()) all.addAll(floats(name, 16));
  for (RCenum name : kMaterialValues) all.addAll(material(name, 4));
  for (RCenum name = RC_LIGHT0; name <= RC_LIGHT7; ++name) {
    for (RCenum value : kLightValues) all.addAll(light(name, value, 4));
  }
  for (RCenum target : {RC_TEXTURE_2D, RC_TEXTURE_2D_NORMAL}) {
    for (RCenum name : kTextureValues) all.add(texParameter(name, RCenum(target)));
  }
  for (RCenum name : kTextureEnvValues) all.addAll(texEnv(name, 4));
  all.addAll(texEnv(RC_COORD_REPLACE_OES, 1, RC_POINT_SPRITE_OES));
  for (RCenum plane = RC_CLIP_PLANE0; plane <= RC_CLIP_PLANE5; ++plane) all.addAll(clipPlane(plane));
  for (RCenum name : kPointers) {
    RCvoid *pointer = nullptr;
    rcGetPointerv(name, &pointer);
    all.add(static_cast<double>(reinterpret_cast<uintptr_t>(pointer)));
  }
  for (RCuint name = 0; name < 520; ++name) {
    all.add(rcIsMaterial(name) + 2 * rcIsTexture(name) + 4 * rcIsBuffer(name));
  }

  // What has no get.
  const api::State &state = context->state;
  const ddk::Camera &camera = state.view.camera;
  for (const Vec3 &axis : {camera.eye, camera.right, camera.up, camera.back}) {
    for (int i = 0; i < 3; ++i) all.add(axis[i]);
  }
  const ddk::Window &window = camera.window;
  all.addAll(std::array{window.left, window.right, window.bottom, window.top, window.near, double(window.parallel)});
  const api::HintState &hints = state.hints;
  all.addAll(std::array{hints.mipmap, hints.rendering, hints.rayBounceThreshold, hints.fog, hints.generateMipmap,
                        hints.lineSmooth, hints.perspective, hints.pointSmooth, hints.structure});
  all.addAll(std::array<double, 3>{state.pathTracing.lightRadius, double(state.pathTracing.diffuseRate),
                                   double(state.pathTracing.sampleCount)});
  all.add(state.texture.alpha);
  all.add(double(state.texture.last));
  for (const api::TextureBinding &binding : state.texture.bound) {
    all.add(binding.name);
    all.addTexture(*binding.texture);
  }
  all.addBuffer(state.arrays.arrayBuffer);
  all.addBuffer(state.arrays.elementBuffer);
  all.add(state.palette.current);
  all.addSum(state.palette.matrices.data(), state.palette.matrices.size() * sizeof(Mat4));
  all.add(context->scene.inStaticScene());
  all.addGeometry(context->scene.statics());
  all.addGeometry(context->scene.dynamics());
  all.add(double(context->objects().changes));  // another picture would be traced
  return std::move(all.values);
}

}  // namespace rc::test
