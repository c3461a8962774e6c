// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Vertices in every format, in memory of exactly the size that the call may read, and in buffer objects with indices
// and offsets beyond their ends; matrices, palettes and clip planes of any numbers; all of it traced.
#include <memory>
#include <string>

#include "context_session.h"
#include "input.h"

namespace rc::fuzz {
namespace {

constexpr RCenum kTypes[] = {RC_BYTE,  RC_UNSIGNED_BYTE, RC_SHORT,        RC_UNSIGNED_SHORT,
                             RC_FLOAT, RC_FIXED,         RC_UNSIGNED_INT, RC_INT};
constexpr RCenum kModes[] = {RC_TRIANGLES, RC_QUADS, RC_TRIANGLE_FAN, RC_TRIANGLE_STRIP, RC_LINES};
constexpr RCenum kIndexTypes[] = {RC_UNSIGNED_BYTE, RC_UNSIGNED_SHORT, RC_UNSIGNED_INT, RC_BYTE, RC_SHORT, RC_INT};
constexpr RCuint kBuffers = 4;

size_t bytesOf(RCenum type) {
  switch (type) {
    case RC_BYTE:
    case RC_UNSIGNED_BYTE:
      return 1;
    case RC_SHORT:
    case RC_UNSIGNED_SHORT:
      return 2;
    default:
      return 4;
  }
}

// Memory that ends where the caller's promise ends.
class Memory {
 public:
  Memory(size_t size, Input &in) : mSize(size), mBytes(new std::byte[size]) {
    const size_t kind = in.below(3);
    if (kind == 2) {
      fillBytes(in);
    } else {
      fillFloats(in, kind == 0 ? 1 : 8);
    }
  }
  std::byte *data() { return mBytes.get(); }
  size_t size() const { return mSize; }

 private:
  // Small numbers, and every few a wild one.
  void fillFloats(Input &in, uint32_t wildEvery) {
    Spread random(in.byte());
    const float wild = in.number(), scale = in.number();
    for (size_t at = 0; at + sizeof(float) <= mSize; at += sizeof(float)) {
      const float value = random.next() % (16 * wildEvery) == 0 ? wild : scale * random.unit();
      std::memcpy(mBytes.get() + at, &value, sizeof value);
    }
  }
  void fillBytes(Input &in) {
    Spread random(in.byte());
    for (size_t i = 0; i < mSize; ++i) mBytes[i] = std::byte(in.empty() ? random.next() & 255 : in.byte());
  }

  size_t mSize;
  std::unique_ptr<std::byte[]> mBytes;
};

// An array that a draw call will set just before it draws, with memory for just the vertices it names.
struct Array {
  RCenum name;
  RCint size;
  RCenum plainType;  // one that it may have
  void (*point)(RCint size, RCenum type, RCsizei stride, const RCvoid *pointer);
  bool on = false;
  RCenum type = RC_FLOAT;
  RCsizei stride = 0;
  RCuint buffer = 0;
  size_t offset = 0;
  std::unique_ptr<Memory> memory;

  void choose(Input &in) {
    on = in.byte() % 8 != 0;
    type = in.below(2) ? RCenum(RC_FLOAT) : in.oneOf(kTypes);
    stride = RCsizei(in.below(3) ? 0 : in.below(3) ? in.byte() : uint32_t(in.integer()));
    buffer = RCuint(in.below(3) == 0 ? in.below(kBuffers + 1) : 0);
    offset = in.below(4) ? 4 * in.below(16) : uint32_t(in.integer());
    const bool ofPalette = name == RC_MATRIX_INDEX_ARRAY_OES || name == RC_WEIGHT_ARRAY_OES;
    if (ofPalette && in.below(4) == 0) size = RCint(in.below(6));
  }

  // Whatever set() does, no call may find memory of an earlier draw.
  void forget() {
    rcBindBuffer(RC_ARRAY_BUFFER, 0);
    const bool palette = rcIsEnabled(RC_MATRIX_PALETTE_OES);
    rcEnable(RC_MATRIX_PALETTE_OES);
    point(std::max(size, 1), plainType, 0, nullptr);
    if (!palette) rcDisable(RC_MATRIX_PALETTE_OES);
    memory.reset();
  }

  void set(size_t vertices, Input &in) {
    forget();
    rcBindBuffer(RC_ARRAY_BUFFER, buffer);
    (on ? rcEnableClientState : rcDisableClientState)(name);
    const size_t element = size_t(std::max(size, 0)) * bytesOf(type), step = stride > 0 ? size_t(stride) : element;
    constexpr size_t kMost = 1 << 16;
    if (buffer != 0 || vertices > kMost || (vertices > 0 ? vertices - 1 : 0) * step > kMost) {
      return point(size, type, stride, reinterpret_cast<const RCvoid *>(buffer != 0 ? offset : 0));
    }
    memory = std::make_unique<Memory>(vertices == 0 ? 0 : (vertices - 1) * step + element, in);
    point(size, type, stride, memory->data());
  }
};

void setNormals(RCint, RCenum type, RCsizei stride, const RCvoid *pointer) { rcNormalPointer(type, stride, pointer); }

struct Geometry {
  Input &in;
  ContextSession session{settingsOf(in.byte())};
  Array arrays[6] = {
      {RC_VERTEX_ARRAY, 3, RC_FLOAT, rcVertexPointer},
      {RC_NORMAL_ARRAY, 3, RC_FLOAT, setNormals},
      {RC_TEXTURE_COORD_ARRAY, 2, RC_FLOAT, rcTexCoordPointer},
      {RC_COLOR_ARRAY, 4, RC_FLOAT, rcColorPointer},
      {RC_MATRIX_INDEX_ARRAY_OES, 2, RC_UNSIGNED_BYTE, rcMatrixIndexPointerOES},
      {RC_WEIGHT_ARRAY_OES, 2, RC_FLOAT, rcWeightPointerOES},
  };

  void setArrays(size_t vertices) {
    for (Array &array : arrays) array.set(vertices, in);
  }
};

void chooseArray(Geometry &g) { g.in.oneOf(g.arrays).choose(g.in); }

void drawArrays(Geometry &g) {
  const RCenum mode = g.in.oneOf(kModes);
  const RCint first = g.in.below(4) ? 0 : g.in.integer();
  const RCsizei count = g.in.below(8) ? RCsizei(g.in.byte()) : std::min(g.in.integer(), 5000);
  const int64_t last = int64_t{first} + count;
  g.setArrays(first >= 0 && count > 0 && last > 0 ? size_t(last) : 0);
  rcDrawArrays(mode, first, count);
}

// Indices that name more vertices than there are belong into buffer objects.
void drawElements(Geometry &g) {
  const RCenum mode = g.in.oneOf(kModes), type = g.in.oneOf(kIndexTypes);
  const size_t count = g.in.byte(), vertices = 1 + g.in.below(64);
  const RCuint buffer = RCuint(g.in.below(4) ? 0 : g.in.below(kBuffers + 1));
  g.setArrays(vertices);
  rcBindBuffer(RC_ELEMENT_ARRAY_BUFFER, buffer);
  if (buffer != 0) {
    // Whatever the buffer's bytes say may be read: client memory would have to be endless.
    for (const Array &array : g.arrays) {
      if (array.buffer == 0) rcDisableClientState(array.name);
    }
    const size_t offset = g.in.below(4) ? 4 * g.in.below(32) : uint32_t(g.in.integer());
    return rcDrawElements(mode, RCsizei(count), type, reinterpret_cast<const RCvoid *>(offset));
  }
  const size_t bytes = bytesOf(type);
  const std::unique_ptr<std::byte[]> indices(new std::byte[count * bytes]);
  Spread random(g.in.byte());
  for (size_t i = 0; i < count; ++i) {
    const uint32_t index = random.next() % uint32_t(vertices);
    std::memcpy(indices.get() + i * bytes, &index, bytes);
  }
  rcDrawElements(mode, RCsizei(count), type, indices.get());
}

void fillBuffer(Geometry &g) {
  const RCenum target = g.in.flag() ? RC_ARRAY_BUFFER : RC_ELEMENT_ARRAY_BUFFER;
  rcBindBuffer(target, RCuint(1 + g.in.below(kBuffers)));
  Memory bytes(g.in.below(1024), g.in);
  if (g.in.below(4) > 0) {
    rcBufferData(target, RCsizeiptr(bytes.size()), g.in.below(8) ? bytes.data() : nullptr, RC_STATIC_DRAW);
  } else {
    const RCintptr offset = g.in.below(2) ? RCintptr(g.in.byte()) : RCintptr(g.in.raw<int64_t>());
    rcBufferSubData(target, offset, RCsizeiptr(bytes.size()), bytes.data());
  }
}

void deleteBuffer(Geometry &g) {
  const RCuint name = RCuint(g.in.below(kBuffers + 1));
  rcDeleteBuffers(1, &name);
}

void changeMatrix(Geometry &g) {
  constexpr RCenum kMatrices[] = {RC_MODELVIEW, RC_TEXTURE, RC_PROJECTION, RC_MATRIX_PALETTE_OES};
  rcMatrixMode(g.in.oneOf(kMatrices));
  const float x = g.in.number(), y = g.in.number(), z = g.in.number();
  switch (g.in.below(5)) {
    case 0:
      return rcTranslatef(x, y, z);
    case 1:
      return rcScalef(x, y, z);
    case 2:
      return rcRotatef(g.in.number(), x, y, z);
    case 3:
      return rcLoadIdentity();
    default:
      RCfloat matrix[16];
      for (RCfloat &value : matrix) value = g.in.number();
      return g.in.flag() ? rcLoadMatrixf(matrix) : rcMultMatrixf(matrix);
  }
}

void changePalette(Geometry &g) {
  (g.in.below(4) ? rcEnable : rcDisable)(RC_MATRIX_PALETTE_OES);
  rcCurrentPaletteMatrixOES(g.in.below(4) ? RCuint(g.in.below(130)) : g.in.token());
  if (g.in.flag()) rcLoadPaletteFromModelViewMatrixOES();
}

void changeClipping(Geometry &g) {
  const RCenum plane = RC_CLIP_PLANE0 + RCenum(g.in.below(7));
  const RCfloat equation[] = {g.in.number(), g.in.number(), g.in.number(), g.in.number()};
  rcClipPlanef(plane, equation);
  (g.in.below(4) ? rcEnable : rcDisable)(plane);
}

void changeSurface(Geometry &g) {
  constexpr RCenum kCaps[] = {RC_CULL_FACE, RC_ALPHA_TEST,   RC_TEXTURE_2D, RC_TEXTURE_2D_NORMAL,
                              RC_LIGHTING,  RC_LIGHT0,       RC_USE_SHADOW, RC_USE_TRANSMITTANCE_SHADOW,
                              RC_FOG,       RC_SCISSOR_TEST, RC_NORMALIZE,  RC_USE_COLOR_SHADOW};
  (g.in.below(4) ? rcEnable : rcDisable)(g.in.oneOf(kCaps));
  rcShadeModel(g.in.flag() ? RC_FLAT : RC_SMOOTH);
  rcFrontFace(g.in.flag() ? RC_CW : RC_CCW);
}

void changeMaterial(Geometry &g) {
  constexpr RCenum kNames[] = {RC_AMBIENT,       RC_DIFFUSE,  RC_SPECULAR,  RC_REFLECTION,
                               RC_TRANSMITTANCE, RC_EMISSION, RC_SHININESS, RC_REFRACTION_INDEX};
  const RCfloat values[] = {g.in.number(), g.in.number(), g.in.number(), g.in.number()};
  rcBindMaterial(RCuint(g.in.below(3)));
  rcMaterialfv(RC_FRONT_AND_BACK, g.in.oneOf(kNames), values);
}

void changeView(Geometry &g) {
  Input &in = g.in;
  const float a = in.number(), b = in.number(), c = in.number(), d = in.number(), e = in.number(), f = in.number();
  switch (in.below(4)) {
    case 0:
      return rcFrustumf(a, b, c, d, e, f);
    case 1:
      return rcOrthof(a, b, c, d, e, f);
    case 2:
      return rcuPerspective(a, b, c, d);
    default:
      const float x = in.number(), y = in.number(), z = in.number();
      return rcuLookAt(a, b, c, d, e, f, x, y, z);
  }
}

void changeScene(Geometry &g) {
  switch (g.in.below(4)) {
    case 0:
      return rcStaticSceneBegin();
    case 1:
      return rcStaticSceneEnd();
    case 2:
      return rcSceneAllInit();
    default:
      constexpr RCenum kStructures[] = {RC_DONT_CARE, RC_STRUCTURE_KD_TREE, RC_STRUCTURE_BVH, RC_STRUCTURE_NONE};
      return rcHint(RC_STRUCTURE_HINT, g.in.oneOf(kStructures));
  }
}

void trace(Geometry &g) {
  g.in.flag() ? rcFinish() : g.session.showFrame();
  if (g.in.below(4)) return;
  RCfloat distances[16];
  rcReadRaysRCX(RCint(g.in.below(16)), 8, 4, 4, RC_RAY_DISTANCE, distances);
}

constexpr void (*kActions[])(Geometry &) = {
    chooseArray,   drawArrays,     drawElements, fillBuffer,  deleteBuffer, changeMatrix, changePalette, changeClipping,
    changeSurface, changeMaterial, changeView,   changeScene, trace,        chooseArray,  drawArrays,    drawElements};

}  // namespace

void run(Input in) {
  Geometry geometry{in};
  rcuPerspective(60, 1.25f, 1, 100);
  rcuLookAt(0, 0, 3, 0, 0, 0, 0, 1, 0);
  rcDepthBounce(2);
  geometry.arrays[0].on = true;
  for (int actions = 0; actions < 40 && !in.empty(); ++actions) in.oneOf(kActions)(geometry);
  geometry.session.showFrame();
}

}  // namespace rc::fuzz
