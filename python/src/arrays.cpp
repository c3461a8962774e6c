// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Vertex arrays and draw calls. C reads the program's memory during the draw call: so arrays are kept alive while
// they are set, and a draw that would read past their end is refused.
#include <EGL/egl.h>

#include <algorithm>
#include <map>

#include "core.h"

namespace raycore {
namespace {

using namespace py::literals;

// The arrays of each context, by their token. Guarded by Python's global lock.
struct Held {
  py::object array;
  py::ssize_t vertices;
};
std::map<std::pair<void *, RCenum>, Held> &heldArrays() {
  static auto *const held = new std::map<std::pair<void *, RCenum>, Held>();  // outlives the interpreter's end
  return *held;
}

struct ArrayKind {
  const char *function, *name;
  RCenum token;
  py::ssize_t columns;
  void (*point)(RCenum type, RCsizei stride, const RCvoid *pointer);
};
constexpr ArrayKind kKinds[] = {
    {"vertex_pointer", "vertices", RC_VERTEX_ARRAY, 3,
     [](RCenum type, RCsizei stride, const RCvoid *pointer) { rcVertexPointer(3, type, stride, pointer); }},
    {"normal_pointer", "normals", RC_NORMAL_ARRAY, 3, rcNormalPointer},
    {"tex_coord_pointer", "texcoords", RC_TEXTURE_COORD_ARRAY, 2,
     [](RCenum type, RCsizei stride, const RCvoid *pointer) { rcTexCoordPointer(2, type, stride, pointer); }},
    {"color_pointer", "colors", RC_COLOR_ARRAY, 4,
     [](RCenum type, RCsizei stride, const RCvoid *pointer) { rcColorPointer(4, type, stride, pointer); }},
};

bool bufferIsBound() {
  RCint bound = 0;
  rcGetIntegerv(RC_ARRAY_BUFFER_BINDING, &bound);
  throwIfFailed();
  return bound != 0;
}

// `columns` values a vertex from numpy, or an offset into the bound buffer.
template <class Value, class Point>
void setPointer(const char *name, RCenum token, py::ssize_t columns, RCenum ownType, const py::object &source,
                RCenum type, RCsizei stride, Point &&point) {
  const auto key = std::make_pair(static_cast<void *>(eglGetCurrentContext()), token);
  const bool offset = py::isinstance<py::int_>(source), buffer = bufferIsBound();
  if (offset != buffer) {
    throw py::value_error(std::string(name) + (buffer ? ": an offset expected, since an array buffer is bound"
                                                      : ": an array expected, since no array buffer is bound"));
  }
  if (offset) {
    point(type, stride, reinterpret_cast<const RCvoid *>(source.cast<size_t>()));
    throwIfFailed();
    heldArrays().erase(key);
    return;
  }
  const py::array any = numbers(source, name);
  const py::ssize_t wanted = columns > 0 ? columns : (any.ndim() == 2 ? any.shape(1) : 0);
  if (any.ndim() != 2 || any.shape(1) != wanted || wanted == 0) {
    throw py::value_error(std::string(name) + ": shape (n, " + (columns > 0 ? std::to_string(columns) : "k") +
                          ") expected, got " + describe(any));
  }
  const Array<Value> packed(any);
  point(ownType, 0, packed.data());
  throwIfFailed();
  heldArrays()[key] = {packed, packed.shape(0)};
}

// Refuses vertices that an enabled array does not have.
void checkVertices(py::ssize_t needed) {
  void *const context = eglGetCurrentContext();
  for (const auto &[key, held] : heldArrays()) {
    if (key.first != context || needed <= held.vertices || !rcIsEnabled(key.second)) continue;
    char text[96];
    std::snprintf(text, sizeof text, "%zd vertices are needed, array 0x%04X has %zd", needed, key.second,
                  held.vertices);
    throw py::value_error(text);
  }
}

void drawArrays(RCenum mode, RCint first, RCsizei count) {
  if (first >= 0 && count > 0) checkVertices(py::ssize_t{first} + count);
  rcDrawArrays(mode, first, count);
  throwIfFailed();
}

void drawElements(RCenum mode, const py::object &indices) {
  const py::array any = numbers(indices, "indices");
  if (any.dtype().kind() == 'f') throw py::type_error("indices: dtype int expected, got " + describe(any));
  const Array<int64_t> given(any);
  std::vector<RCuint> packed;
  packed.reserve(static_cast<size_t>(given.size()));
  RCuint largest = 0;
  for (const int64_t *at = given.data(), *end = at + given.size(); at != end; ++at) {
    if (*at < 0 || *at > 0x7FFFFFFF) {
      throw py::value_error("indices: 0 ... 2147483647 expected, got " + std::to_string(*at));
    }
    packed.push_back(static_cast<RCuint>(*at));
    largest = std::max(largest, packed.back());
  }
  if (packed.empty()) return;
  checkVertices(py::ssize_t{largest} + 1);
  RCint bound = 0;
  rcGetIntegerv(RC_ELEMENT_ARRAY_BUFFER_BINDING, &bound);
  throwIfFailed();
  if (bound) throw py::value_error("indices: an element buffer is bound; unbind it to draw from numpy");
  rcDrawElements(mode, static_cast<RCsizei>(packed.size()), RC_UNSIGNED_INT, packed.data());
  throwIfFailed();
}

}  // namespace

void forgetArrays(void *context) {
  std::erase_if(heldArrays(), [&](const auto &entry) { return entry.first.first == context; });
}

void addArrays(py::module_ &module) {
  for (const ArrayKind &kind : kKinds) {
    module.def(
        kind.function,
        [&kind](const py::object &source, RCenum type, RCsizei stride) {
          setPointer<float>(kind.name, kind.token, kind.columns, RC_FLOAT, source, type, stride, kind.point);
        },
        "source"_a, "type"_a = RC_FLOAT, "stride"_a = 0);
  }
  // The palette's arrays have as many values a vertex as the array has columns.
  module.def(
      "weight_pointer",
      [](const py::object &source, RCint size, RCenum type, RCsizei stride) {
        const RCint columns = py::isinstance<py::int_>(source) ? size : RCint(py::array(source).shape(1));
        setPointer<float>("weights", RC_WEIGHT_ARRAY_OES, 0, RC_FLOAT, source, type, stride,
                          [=](RCenum t, RCsizei s, const RCvoid *p) { rcWeightPointerOES(columns, t, s, p); });
      },
      "source"_a, "size"_a = 1, "type"_a = RC_FLOAT, "stride"_a = 0);
  module.def(
      "matrix_index_pointer",
      [](const py::object &source, RCint size, RCenum type, RCsizei stride) {
        const RCint columns = py::isinstance<py::int_>(source) ? size : RCint(py::array(source).shape(1));
        setPointer<RCubyte>("matrix_indices", RC_MATRIX_INDEX_ARRAY_OES, 0, RC_UNSIGNED_BYTE, source, type, stride,
                            [=](RCenum t, RCsizei s, const RCvoid *p) { rcMatrixIndexPointerOES(columns, t, s, p); });
      },
      "source"_a, "size"_a = 1, "type"_a = RC_UNSIGNED_BYTE, "stride"_a = 0);
  module.def(
      "point_size_pointer",
      [](const py::object &source, RCenum type, RCsizei stride) {
        setPointer<float>("sizes", RC_POINT_SIZE_ARRAY_OES, 1, RC_FLOAT, source, type, stride, rcPointSizePointerOES);
      },
      "source"_a, "type"_a = RC_FLOAT, "stride"_a = 0);
  module.def("draw_arrays", drawArrays, "mode"_a, "first"_a, "count"_a);
  module.def("draw_elements", drawElements, "mode"_a, "indices"_a);
}

}  // namespace raycore
