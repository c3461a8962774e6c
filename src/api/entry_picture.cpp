// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: which part of the picture is written, and reading it back. [spec 3.8; OpenGL ES 1.1, 4.1.2, 4.2.2, 4.3]
#include <cstring>

#include "RC/rc.h"
#include "api/guard.h"
#include "api/picture.h"

using namespace rc;
using namespace rc::api;

namespace {

struct ReadFormat {
  RCenum format, type;
  size_t bytes;  // of a pixel
};
constexpr ReadFormat kReadFormats[] = {{RC_RGBA, RC_UNSIGNED_BYTE, 4}, {RC_RGB, RC_UNSIGNED_BYTE, 3}};

// The format, or an error and null.
const ReadFormat *findReadFormat(Context &context, RCenum format, RCenum type) {
  for (const ReadFormat &row : kReadFormats) {
    if (row.format == format && row.type == type) return &row;
  }
  const bool known = (format == RC_RGBA || format == RC_RGB) && type != RC_UNSIGNED_BYTE;
  const bool isType = type >= RC_BYTE && type <= RC_FLOAT;
  const bool packed =
      type == RC_UNSIGNED_SHORT_4_4_4_4 || type == RC_UNSIGNED_SHORT_5_5_5_1 || type == RC_UNSIGNED_SHORT_5_6_5;
  context.fail(known && (isType || packed) ? RC_INVALID_OPERATION : RC_INVALID_ENUM,
               "format 0x%04X and type 0x%04X cannot be read; RC_RGBA and RC_RGB of RC_UNSIGNED_BYTE can", format,
               type);
  return nullptr;
}

void readPixels(Context &context, const hal::PixelRect &part, const ReadFormat &format, RCvoid *pixels) {
  if (part.columns < 0 || part.rows < 0) {
    return context.fail(RC_INVALID_VALUE, "width x height is %d x %d, not 0 or more", part.columns, part.rows);
  }
  const hal::Target picture = context.picture();
  if (!picture.pixels) return context.fail(RC_INVALID_OPERATION, "there is no surface to read from");
  if (!pixels) return;
  const size_t alignment = size_t(context.state.pixelStore.packAlignment);
  const size_t rowBytes = (size_t(part.columns) * format.bytes + alignment - 1) / alignment * alignment;
  // What lies beside the picture is left as it is in memory.
  const hal::PixelRect inside = hal::common(part, {0, 0, picture.width, picture.height});
  for (int row = inside.row; row < inside.row + inside.rows; ++row) {
    auto *to = static_cast<RCubyte *>(pixels) + size_t(int64_t{row} - part.row) * rowBytes;
    for (int column = inside.column; column < inside.column + inside.columns; ++column) {
      const auto place = size_t(int64_t{column} - part.column);
      std::memcpy(to + place * format.bytes, &hal::pixelAt(picture, column, row), format.bytes);
    }
  }
}

struct RayValue {
  RCenum pname;
  RCfloat (*of)(const ddk::RayAnswer &answer);
};
constexpr RayValue kRayValues[] = {
    {RC_RAY_DISTANCE, [](const ddk::RayAnswer &a) { return RCfloat(a.distance); }},
    {RC_RAY_MATERIAL, [](const ddk::RayAnswer &a) { return RCfloat(a.material); }},
    {RC_RAY_BOXES, [](const ddk::RayAnswer &a) { return RCfloat(a.boxes); }},
    {RC_RAY_TRIANGLES, [](const ddk::RayAnswer &a) { return RCfloat(a.triangles); }},
};

// Rays go through pixels of the viewport, which begins where the picture does: its x and y are not used. [spec 3.1]
void readRays(Context &context, const hal::PixelRect &part, const RayValue &value, RCfloat *values) {
  if (part.columns < 0 || part.rows < 0) {
    return context.fail(RC_INVALID_VALUE, "width x height is %d x %d, not 0 or more", part.columns, part.rows);
  }
  if (!context.picture().pixels) return context.fail(RC_INVALID_OPERATION, "there is no surface to look through");
  if (!values) return;
  const ViewState &view = context.state.view;
  const hal::PixelRect inside = hal::common(part, {0, 0, view.width, view.height});
  context.probe(inside, [&](int column, int row, const ddk::RayAnswer &answer) {
    const size_t place = size_t(int64_t{row} - part.row) * size_t(part.columns);
    values[place + size_t(int64_t{column} - part.column)] = value.of(answer);
  });
}

}  // namespace

extern "C" {

void rcScissor(RCint x, RCint y, RCsizei width, RCsizei height) {
  enter(Call("rcScissor", x, y, width, height), [&](Context &context) {
    if (width < 0 || height < 0)
      return context.fail(RC_INVALID_VALUE, "width x height is %d x %d, not 0 or more", width, height);
    PictureState &picture = context.state.picture;
    picture.scissorX = x;
    picture.scissorY = y;
    picture.scissorWidth = width;
    picture.scissorHeight = height;
    context.touch();
  });
}

void rcColorMask(RCboolean red, RCboolean green, RCboolean blue, RCboolean alpha) {
  enter(Call("rcColorMask", red, green, blue, alpha), [&](Context &context) {
    context.state.picture.colorMask = {red != 0, green != 0, blue != 0, alpha != 0};
    context.touch();
  });
}

void rcPixelStorei(RCenum pname, RCint param) {
  enter(Call("rcPixelStorei", pname, param), [&](Context &context) {
    PixelStoreState &store = context.state.pixelStore;
    if (pname != RC_PACK_ALIGNMENT && pname != RC_UNPACK_ALIGNMENT) {
      return context.fail(RC_INVALID_ENUM, "pname 0x%04X is not RC_UNPACK_ALIGNMENT or RC_PACK_ALIGNMENT", pname);
    }
    if (param != 1 && param != 2 && param != 4 && param != 8) {
      return context.fail(RC_INVALID_VALUE, "param is %d, not 1, 2, 4 or 8", param);
    }
    (pname == RC_PACK_ALIGNMENT ? store.packAlignment : store.unpackAlignment) = param;
  });
}

void rcReadPixels(RCint x, RCint y, RCsizei width, RCsizei height, RCenum format, RCenum type, RCvoid *pixels) {
  enter(Call("rcReadPixels", x, y, width, height, format, type, pixels), [&](Context &context) {
    if (const ReadFormat *row = findReadFormat(context, format, type)) {
      readPixels(context, {x, y, width, height}, *row, pixels);
    }
  });
}

void rcReadRaysRCX(RCint x, RCint y, RCsizei width, RCsizei height, RCenum pname, RCfloat *values) {
  enter(Call("rcReadRaysRCX", x, y, width, height, pname, values), [&](Context &context) {
    for (const RayValue &row : kRayValues) {
      if (row.pname == pname) return readRays(context, {x, y, width, height}, row, values);
    }
    context.fail(RC_INVALID_ENUM, "pname 0x%04X is nothing that a ray tells", pname);
  });
}

}  // extern "C"
