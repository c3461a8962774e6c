// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Names of objects, texels, buffers, and the picture as an array. Row 0 of a picture is its top, as numpy's
// libraries have it; row 0 of a texture is at v = 0, as the API has it.
#include "core.h"

namespace raycore {
namespace {

using namespace py::literals;

using Texels = Array<RCubyte>;

Texels texels(const py::object &object) {
  const py::array any = numbers(object, "pixels");
  if (any.ndim() != 3 || (any.shape(2) != 3 && any.shape(2) != 4)) {
    throw py::value_error("pixels: shape (height, width, 3 or 4) expected, got " + describe(any));
  }
  if (any.dtype().kind() == 'f') throw py::type_error("pixels: dtype uint8 expected, got " + describe(any));
  return Texels(any);
}

RCenum formatOf(const Texels &pixels) { return pixels.shape(2) == 4 ? RC_RGBA : RC_RGB; }

// Calls with rows as tightly packed as numpy's.
template <class Load>
void packed(Load &&load) {
  RCint alignment = 1;
  rcGetIntegerv(RC_UNPACK_ALIGNMENT, &alignment);
  throwIfFailed();
  rcPixelStorei(RC_UNPACK_ALIGNMENT, 1);
  load();
  rcPixelStorei(RC_UNPACK_ALIGNMENT, alignment);
  throwIfFailed();
}

void addTexels(py::module_ &m) {
  m.def(
      "tex_image_2d",
      [](const py::object &object, RCenum target) {
        const Texels pixels = texels(object);
        packed([&] {
          rcTexImage2D(target, 0, RCint(formatOf(pixels)), RCsizei(pixels.shape(1)), RCsizei(pixels.shape(0)), 0,
                       formatOf(pixels), RC_UNSIGNED_BYTE, pixels.data());
        });
      },
      "pixels"_a, "target"_a = RC_TEXTURE_2D);
  m.def(
      "tex_sub_image_2d",
      [](const py::object &object, RCint x, RCint y, RCenum target) {
        const Texels pixels = texels(object);
        packed([&] {
          rcTexSubImage2D(target, 0, x, y, RCsizei(pixels.shape(1)), RCsizei(pixels.shape(0)), formatOf(pixels),
                          RC_UNSIGNED_BYTE, pixels.data());
        });
      },
      "pixels"_a, "x"_a, "y"_a, "target"_a = RC_TEXTURE_2D);
  m.def(
      "compressed_tex_image_2d",
      [](RCenum internalformat, RCsizei width, RCsizei height, const py::bytes &data, RCint level, RCenum target) {
        const std::string bytes = data;
        rcCompressedTexImage2D(target, level, internalformat, width, height, 0, RCsizei(bytes.size()), bytes.data());
        throwIfFailed();
      },
      "internalformat"_a, "width"_a, "height"_a, "data"_a, "level"_a = 0, "target"_a = RC_TEXTURE_2D);
  m.def(
      "copy_tex_image_2d",
      [](RCenum internalformat, RCint x, RCint y, RCsizei width, RCsizei height, RCenum target) {
        rcCopyTexImage2D(target, 0, internalformat, x, y, width, height, 0);
        throwIfFailed();
      },
      "internalformat"_a, "x"_a, "y"_a, "width"_a, "height"_a, "target"_a = RC_TEXTURE_2D);
  m.def(
      "copy_tex_sub_image_2d",
      [](RCint xoffset, RCint yoffset, RCint x, RCint y, RCsizei width, RCsizei height, RCenum target) {
        rcCopyTexSubImage2D(target, 0, xoffset, yoffset, x, y, width, height);
        throwIfFailed();
      },
      "xoffset"_a, "yoffset"_a, "x"_a, "y"_a, "width"_a, "height"_a, "target"_a = RC_TEXTURE_2D);
}

// The picture, or a part of it counted from the lower left corner; the top row first.
Array<RCubyte> readPixels(RCint x, RCint y, RCsizei width, RCsizei height, RCenum format) {
  const py::ssize_t channels = format == RC_RGB ? 3 : 4;
  Array<RCubyte> picture(std::vector<py::ssize_t>{std::max(height, 0), std::max(width, 0), channels});
  std::fill_n(picture.mutable_data(), picture.size(), RCubyte{0});
  RCint alignment = 4;
  rcGetIntegerv(RC_PACK_ALIGNMENT, &alignment);
  throwIfFailed();
  rcPixelStorei(RC_PACK_ALIGNMENT, 1);
  rcReadPixels(x, y, width, height, format, RC_UNSIGNED_BYTE, picture.mutable_data());
  rcPixelStorei(RC_PACK_ALIGNMENT, alignment);
  throwIfFailed();
  return Array<RCubyte>(picture[py::slice(py::none(), py::none(), py::int_(-1))]);
}

// What the primary rays of pixels meet, counted from the lower left corner; the top row first.
Array<float> readRays(RCint x, RCint y, RCsizei width, RCsizei height, RCenum pname) {
  Array<float> rays(std::vector<py::ssize_t>{std::max(height, 0), std::max(width, 0)});
  std::fill_n(rays.mutable_data(), rays.size(), -1.0f);
  rcReadRaysRCX(x, y, width, height, pname, rays.mutable_data());
  throwIfFailed();
  return Array<float>(rays[py::slice(py::none(), py::none(), py::int_(-1))]);
}

void addNames(py::module_ &m) {
  const auto names = [&](const char *gen, void (*make)(RCsizei, RCuint *)) {
    m.def(
        gen,
        [make](RCsizei n) {
          std::vector<RCuint> made(size_t(std::max(n, 0)));
          make(n, made.data());
          throwIfFailed();
          return made;
        },
        "n"_a = 1);
  };
  names("gen_textures", rcGenTextures);
  names("gen_materials", rcGenMaterials);
  names("gen_buffers", rcGenBuffers);
  const auto removal = [&](const char *name, void (*remove)(RCsizei, const RCuint *)) {
    m.def(
        name,
        [remove](const std::vector<RCuint> &gone) {
          remove(RCsizei(gone.size()), gone.data());
          throwIfFailed();
        },
        "names"_a);
  };
  removal("delete_textures", rcDeleteTextures);
  removal("delete_materials", [](RCsizei n, const RCuint *gone) { rcDeleteMaterials(n, const_cast<RCuint *>(gone)); });
  removal("delete_buffers", rcDeleteBuffers);
  const auto question = [&](const char *name, RCboolean (*is)(RCuint)) {
    m.def(
        name,
        [is](RCuint one) {
          const bool answer = is(one);
          throwIfFailed();
          return answer;
        },
        "name"_a);
  };
  question("is_texture", rcIsTexture);
  question("is_material", rcIsMaterial);
  question("is_buffer", rcIsBuffer);
}

void addBuffers(py::module_ &m) {
  m.def(
      "buffer_data",
      [](RCenum target, const py::object &data, RCenum usage) {
        const py::array packed = py::array::ensure(numbers(data, "data"), py::array::c_style);
        rcBufferData(target, packed.nbytes(), packed.data(), usage);
        throwIfFailed();
      },
      "target"_a, "data"_a, "usage"_a = RC_STATIC_DRAW);
  m.def(
      "buffer_sub_data",
      [](RCenum target, RCintptr offset, const py::object &data) {
        const py::array packed = py::array::ensure(numbers(data, "data"), py::array::c_style);
        rcBufferSubData(target, offset, packed.nbytes(), packed.data());
        throwIfFailed();
      },
      "target"_a, "offset"_a, "data"_a);
  m.def(
      "get_buffer_parameter",
      [](RCenum target, RCenum pname) {
        RCint value = 0;
        rcGetBufferParameteriv(target, pname, &value);
        throwIfFailed();
        return value;
      },
      "target"_a, "pname"_a);
}

}  // namespace

void addImages(py::module_ &module) {
  addTexels(module);
  addNames(module);
  addBuffers(module);
  module.def("read_pixels", readPixels, "x"_a, "y"_a, "width"_a, "height"_a, "format"_a = RC_RGB);
  module.def("read_rays", readRays, "x"_a, "y"_a, "width"_a, "height"_a, "pname"_a);
}

}  // namespace raycore
