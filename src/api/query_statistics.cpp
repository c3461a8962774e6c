// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Answers for what frames cost: rays by kind, times, memory, structures. [RC_RCX_frame_queries, _frame_statistics]
#include "api/query.h"
#include "rcddk/accel/shape.h"

namespace rc::api {
namespace {

template <uint64_t hal::RayCounts::*kind>
constexpr QueryRow rays(RCenum name) {
  return {name, QueryResult::Kind::Number, 1,
          [](const Context &c, double *v) { v[0] = double(c.lastFrame().rays.*kind); }};
}

// The workers' time in units. Asking turns the measurement on.
template <double hal::UnitTimes::*...unit>
constexpr QueryRow units(RCenum name) {
  return {name, QueryResult::Kind::Number, 1, [](const Context &c, double *v) {
            c.measureUnits();
            v[0] = 1e3 * ((c.lastFrame().rays.times.*unit) + ...);
          }};
}

// Of both structures: that of the static scene, and that of what moves.
template <auto member>
constexpr QueryRow structure(RCenum name) {
  return {name, QueryResult::Kind::Number, 1, [](const Context &c, double *v) {
            v[0] = double(ddk::shapeOf(c.scene.staticAccel()).*member) +
                   double(ddk::shapeOf(c.scene.dynamicAccel()).*member);
          }};
}

constexpr QueryRow number(RCenum name, void (*read)(const Context &, double *)) {
  return {name, QueryResult::Kind::Number, 1, read};
}

size_t bytesOfTriangles(const ddk::GeometrySet &set) {
  return set.triangles.capacity() * sizeof(hal::HotTriangle) +
         set.attributes.capacity() * sizeof(hal::TriangleAttributes) +
         set.captured.capacity() * sizeof(set.captured[0]);
}

size_t bytesOfTextures(const Context &context) {
  size_t bytes = 0;
  context.objects().textures.forEach([&](const ddk::Texture &texture) {
    if (!texture.loaded()) return;
    for (const ddk::Texels &level : texture.image->levels) bytes += level.size() * sizeof(uint32_t);
  });
  return bytes;
}

constexpr QueryRow kRows[] = {
    number(RC_FRAME_TRIANGLES,
           [](const Context &c, double *v) {
             v[0] = double(c.lastFrame().staticTriangles + c.lastFrame().dynamicTriangles);
           }),
    number(RC_FRAME_TRIANGLES_SKIPPED, [](const Context &c, double *v) { v[0] = double(c.lastFrame().skipped.all()); }),
    number(RC_FRAME_RAYS, [](const Context &c, double *v) { v[0] = double(c.lastFrame().rays.all()); }),
    rays<&hal::RayCounts::primary>(RC_FRAME_RAYS_PRIMARY),
    rays<&hal::RayCounts::shadow>(RC_FRAME_RAYS_SHADOW),
    rays<&hal::RayCounts::reflected>(RC_FRAME_RAYS_REFLECTED),
    rays<&hal::RayCounts::refracted>(RC_FRAME_RAYS_REFRACTED),
    rays<&hal::RayCounts::straight>(RC_FRAME_RAYS_STRAIGHT),
    number(RC_FRAME_BUILD_TIME, [](const Context &c, double *v) { v[0] = c.lastFrame().buildMilliseconds; }),
    number(RC_FRAME_TRACE_TIME, [](const Context &c, double *v) { v[0] = c.lastFrame().traceMilliseconds; }),
    number(RC_FRAME_TRANSFORM_TIME, [](const Context &c, double *v) { v[0] = c.lastFrame().transformMilliseconds; }),
    number(RC_FRAME_PRESENT_TIME, [](const Context &c, double *v) { v[0] = c.lastFrame().presentMilliseconds; }),
    units<&hal::UnitTimes::primary>(RC_FRAME_PRIMARY_TIME),
    units<&hal::UnitTimes::secondary>(RC_FRAME_SECONDARY_TIME),
    units<&hal::UnitTimes::shadow>(RC_FRAME_SHADOW_TIME),
    units<&hal::UnitTimes::shade>(RC_FRAME_SHADE_TIME),
    units<&hal::UnitTimes::generate, &hal::UnitTimes::store>(RC_FRAME_STORE_TIME),
    number(RC_STATIC_BUILD_TIME, [](const Context &c, double *v) { v[0] = c.scene.staticBuildMilliseconds(); }),
    number(RC_MEMORY_TRIANGLES,
           [](const Context &c, double *v) {
             v[0] = double(bytesOfTriangles(c.scene.statics()) + bytesOfTriangles(c.scene.dynamics()));
           }),
    number(RC_MEMORY_STRUCTURE,
           [](const Context &c, double *v) {
             v[0] = double(c.scene.staticAccel().bytes() + c.scene.dynamicAccel().bytes());
           }),
    number(RC_MEMORY_TEXTURES, [](const Context &c, double *v) { v[0] = double(bytesOfTextures(c)); }),
    structure<&ddk::AccelShape::nodes>(RC_STRUCTURE_NODES),
    structure<&ddk::AccelShape::leaves>(RC_STRUCTURE_LEAVES),
    structure<&ddk::AccelShape::cost>(RC_STRUCTURE_COST),
    number(RC_STRUCTURE_DEPTH,
           [](const Context &c, double *v) {
             v[0] = std::max(ddk::shapeOf(c.scene.staticAccel()).depth, ddk::shapeOf(c.scene.dynamicAccel()).depth);
           }),
};

}  // namespace

std::span<const QueryRow> statisticsQueries() { return kRows; }

}  // namespace rc::api
