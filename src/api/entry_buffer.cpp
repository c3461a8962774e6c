// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Entry points: buffer objects. [spec 3.6; reference 1.3, 4.7; OpenGL ES 1.1, 2.9]
#include <cstring>

#include "RC/rc.h"
#include "api/arrays.h"
#include "api/convert.h"
#include "api/guard.h"

using namespace rc;
using namespace rc::api;

namespace {

// More memory than any machine has: not worth asking for.
constexpr RCsizeiptr kLargestBuffer = RCsizeiptr{1} << 40;

// The binding of a target, or an error and null.
BufferBinding *findBinding(Context &context, RCenum target) {
  if (target == RC_ARRAY_BUFFER) return &context.state.arrays.arrayBuffer;
  if (target == RC_ELEMENT_ARRAY_BUFFER) return &context.state.arrays.elementBuffer;
  context.fail(RC_INVALID_ENUM, "target 0x%04X is not RC_ARRAY_BUFFER or RC_ELEMENT_ARRAY_BUFFER", target);
  return nullptr;
}

// The buffer that is bound to a target, or an error and null.
Buffer *findBound(Context &context, const BufferBinding &binding) {
  if (!binding.buffer) context.fail(RC_INVALID_OPERATION, "no buffer is bound");
  return binding.buffer.get();
}

// A deleted buffer leaves the bindings, and the arrays that read it have nothing to read.
void unbind(ArrayState &arrays, RCuint name) {
  for (BufferBinding *binding : {&arrays.arrayBuffer, &arrays.elementBuffer}) {
    if (binding->name == name) *binding = {};
  }
  for (const ArrayTokens &row : kArrays) {
    ClientArray &array = arrays.*row.member;
    if (array.bufferName != name) continue;
    array.bufferName = 0;
    array.buffer = nullptr;
    array.pointer = nullptr;
  }
}

}  // namespace

extern "C" {

void rcGenBuffers(RCsizei n, RCuint *buffers) {
  enter(Call("rcGenBuffers", n, buffers), [&](Context &context) {
    if (n < 0) return context.fail(RC_INVALID_VALUE, "n is %d, not 0 or more", n);
    for (RCsizei i = 0; buffers && i < n; ++i) buffers[i] = context.objects().buffers.generate();
  });
}

void rcDeleteBuffers(RCsizei n, const RCuint *buffers) {
  enter(Call("rcDeleteBuffers", n, list(buffers, n)), [&](Context &context) {
    if (n < 0) return context.fail(RC_INVALID_VALUE, "n is %d, not 0 or more", n);
    for (RCsizei i = 0; buffers && i < n; ++i) {
      if (buffers[i] == 0) continue;
      context.objects().buffers.remove(buffers[i]);
      unbind(context.state.arrays, buffers[i]);
    }
  });
}

void rcBindBuffer(RCenum target, RCuint buffer) {
  enter(Call("rcBindBuffer", target, buffer), [&](Context &context) {
    BufferBinding *binding = findBinding(context, target);
    if (!binding) return;
    *binding = {buffer, buffer == 0 ? nullptr : context.objects().buffers.bind(buffer)};
  });
}

RCboolean rcIsBuffer(RCuint buffer) {
  return enter(Call("rcIsBuffer", buffer), [&](Context &context) -> RCboolean {
    return context.objects().buffers.contains(buffer) ? RC_TRUE : RC_FALSE;
  });
}

void rcBufferData(RCenum target, RCsizeiptr size, const RCvoid *data, RCenum usage) {
  enter(Call("rcBufferData", target, size, data, usage), [&](Context &context) {
    const BufferBinding *binding = findBinding(context, target);
    if (!binding) return;
    if (usage != RC_STATIC_DRAW && usage != RC_DYNAMIC_DRAW) {
      return context.fail(RC_INVALID_ENUM, "usage 0x%04X is not RC_STATIC_DRAW or RC_DYNAMIC_DRAW", usage);
    }
    if (size < 0) return context.fail(RC_INVALID_VALUE, "size is %ld, not 0 or more", size);
    Buffer *buffer = findBound(context, *binding);
    if (!buffer) return;
    if (size > kLargestBuffer) return context.fail(RC_OUT_OF_MEMORY, "size is %ld, more than there can be", size);
    Array<std::byte> bytes(static_cast<size_t>(size));
    if (data && size > 0) std::memcpy(bytes.data(), data, bytes.size());
    buffer->bytes = std::move(bytes);
    buffer->usage = usage;
  });
}

void rcBufferSubData(RCenum target, RCintptr offset, RCsizeiptr size, const RCvoid *data) {
  enter(Call("rcBufferSubData", target, offset, size, data), [&](Context &context) {
    const BufferBinding *binding = findBinding(context, target);
    if (!binding) return;
    Buffer *buffer = findBound(context, *binding);
    if (!buffer) return;
    if (buffer->usage == RC_STATIC_DRAW) {
      return context.fail(RC_INVALID_OPERATION, "the buffer is RC_STATIC_DRAW; only RC_DYNAMIC_DRAW can be changed");
    }
    const auto available = static_cast<RCsizeiptr>(buffer->bytes.size());
    if (!data || offset < 0 || size <= 0 || offset > available || size > available - offset) {
      return context.fail(RC_INVALID_VALUE, "size is %ld at offset %ld: not within the %ld bytes of the buffer", size,
                          offset, available);
    }
    std::memcpy(buffer->bytes.data() + offset, data, static_cast<size_t>(size));
  });
}

void rcGetBufferParameteriv(RCenum target, RCenum pname, RCint *params) {
  enter(Call("rcGetBufferParameteriv", target, pname, params), [&](Context &context) {
    const BufferBinding *binding = findBinding(context, target);
    if (!binding) return;
    if (pname != RC_BUFFER_SIZE && pname != RC_BUFFER_USAGE) {
      return context.fail(RC_INVALID_ENUM, "pname 0x%04X is not RC_BUFFER_SIZE or RC_BUFFER_USAGE", pname);
    }
    const Buffer *buffer = findBound(context, *binding);
    if (!buffer || !params) return;
    *params = pname == RC_BUFFER_SIZE ? roundToInt(double(buffer->bytes.size())) : static_cast<RCint>(buffer->usage);
  });
}

}  // extern "C"
