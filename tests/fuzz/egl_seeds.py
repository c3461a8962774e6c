#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
"""Makes inputs of fuzz_api of what no trace has: calls of EGL with the objects they are about, and questions.

    tests/fuzz/egl_seeds.py FOLDER"""
import pathlib
import struct
import sys

from trace_to_seeds import DRAW, IMAGE, PLAIN_CALL, SWAP, code_of, encoded, tokens

EGL = pathlib.Path("/usr/include/EGL")
TOKENS = tokens(EGL / "egl.h", EGL / "eglext.h")
# Of World::handle: of the two objects of the first step, and the last one of up to six.
DISPLAY, CONTEXT, SURFACE, LAST, NULL = 2, 64, 65, 120, 0
ASK = 250
TEXTURE_SURFACE = 0x80


def integer(value):
    return encoded("RCint", TOKENS.get(value, value))


def unsigned(value):
    return encoded("RCenum", TOKENS.get(value, value))


def attributes(*values):
    """A list, which the target ends with EGL_NONE."""
    if not values:
        return b"\x00"
    return bytes([len(values) + 1]) + b"".join(integer(value) for value in (*values, 0))


def call(name, *arguments):
    return struct.pack("<BH", PLAIN_CALL, code_of(name)) + b"".join(arguments)


def handle(choice):
    return bytes([choice])


OUT = b"\x01" + bytes([64])  # memory for a result
D, NONE = handle(DISPLAY), handle(NULL)
SURFACES = ["EGL_CONFIG_ID", "EGL_WIDTH", "EGL_HEIGHT", "EGL_LARGEST_PBUFFER", "EGL_TEXTURE_FORMAT", "EGL_TEXTURE_TARGET",
            "EGL_MIPMAP_TEXTURE", "EGL_MIPMAP_LEVEL", "EGL_RENDER_BUFFER", "EGL_SWAP_BEHAVIOR", "EGL_MULTISAMPLE_RESOLVE",
            "EGL_HORIZONTAL_RESOLUTION", "EGL_PIXEL_ASPECT_RATIO", "EGL_GL_COLORSPACE", "EGL_BUFFER_AGE_EXT"]
DRAWN = bytes([DRAW, 0, 0, SWAP])


def bound_texture(config):
    bind = call("eglBindTexImage", D, handle(SURFACE), integer("EGL_BACK_BUFFER"))
    release = call("eglReleaseTexImage", D, handle(SURFACE), integer("EGL_BACK_BUFFER"))
    image = call("rcBindTexture", unsigned("RC_TEXTURE_2D"), unsigned(1))
    steps = DRAWN + image + bind + bind + bytes([DRAW, 0, 0]) + release + bind + call("eglSwapBuffers", D, handle(SURFACE))
    return bytes([0, 0, TEXTURE_SURFACE, config, 0]) + steps + bytes([IMAGE, 1, 0]) + DRAWN + call("eglDestroySurface", D, handle(SURFACE))


def questions_of_egl():
    steps = b"".join(call("eglQueryString", D, integer(n)) + call("eglQueryString", NONE, integer(n))
                     for n in ["EGL_VENDOR", "EGL_VERSION", "EGL_CLIENT_APIS", "EGL_EXTENSIONS"])
    steps += b"".join(call("eglQuerySurface", D, handle(SURFACE), integer(n), OUT) for n in SURFACES)
    steps += b"".join(call("eglQueryContext", D, handle(CONTEXT), integer(n), OUT)
                      for n in ["EGL_CONFIG_ID", "EGL_CONTEXT_CLIENT_TYPE", "EGL_CONTEXT_CLIENT_VERSION", "EGL_RENDER_BUFFER"])
    steps += b"".join(call("eglSurfaceAttrib", D, handle(SURFACE), integer(n), integer(v)) for n, v in
                      [("EGL_MIPMAP_LEVEL", 1), ("EGL_SWAP_BEHAVIOR", "EGL_BUFFER_PRESERVED"), ("EGL_MULTISAMPLE_RESOLVE", 0)])
    return bytes(5) + DRAWN + steps + DRAWN


def fences(kind):
    suffix = "KHR" if kind else ""
    create = call(f"eglCreateSync{suffix}", D, b"\x01", attributes())
    steps = create + b"".join(call(f"eglGetSyncAttrib{suffix}", D, handle(LAST), integer(n), OUT)
                              for n in ["EGL_SYNC_TYPE", "EGL_SYNC_STATUS", "EGL_SYNC_CONDITION", "EGL_WIDTH"])
    steps += call(f"eglWaitSync{suffix}", D, handle(LAST), integer(0)) + bytes([DRAW, 0, 0])
    steps += call(f"eglClientWaitSync{suffix}", D, handle(LAST), integer("EGL_SYNC_FLUSH_COMMANDS_BIT"), b"\x05")
    return bytes(5) + bytes([DRAW, 0, 0]) + steps + call(f"eglDestroySync{suffix}", D, handle(LAST))


def images(kind):
    name = b"\x01" + struct.pack("<I", 3)
    lists = [("EGL_GL_TEXTURE_LEVEL", 0, "EGL_IMAGE_PRESERVED", 1), ("EGL_GL_TEXTURE_LEVEL", 9), ("EGL_WIDTH", 1), ()]
    texture = call("rcBindTexture", unsigned("RC_TEXTURE_2D"), unsigned(3)) + bytes([IMAGE, 7, 1])
    create = [call("eglCreateImage" + kind, D, handle(CONTEXT), unsigned("EGL_GL_TEXTURE_2D"), name, attributes(*l)) for l in lists]
    return bytes(5) + texture + b"".join(create) + call("eglDestroyImage" + kind, D, handle(LAST)) + DRAWN


def displays():
    lists = [("EGL_PLATFORM_X11_SCREEN_KHR", 0), ("EGL_WIDTH", 1), ()]
    platforms = ["EGL_PLATFORM_X11_KHR", "EGL_PLATFORM_SURFACELESS_MESA"]
    steps = b"".join(call("eglGetPlatformDisplay", unsigned(p), attributes(*l)) for p in platforms for l in lists)
    return bytes(5) + steps + call("eglChooseConfig", D, attributes("EGL_RED_SIZE", 8, "EGL_SAMPLES", 4), b"\x10\x01", OUT) + DRAWN


def questions(first, way):
    buffer = call("rcBindBuffer", unsigned("RC_ARRAY_BUFFER"), unsigned(2))
    buffer += call("rcBufferData", unsigned("RC_ARRAY_BUFFER"), b"\x01\x40", unsigned("RC_DYNAMIC_DRAW"), b"\x01\x01")
    buffer += call("rcBufferSubData", unsigned("RC_ARRAY_BUFFER"), b"\x01\x04", b"\x01\x08", b"\x01")
    return bytes(5) + bytes([IMAGE, 1, 0]) + buffer + DRAWN + DRAWN + b"".join(struct.pack("<BHB", ASK, first // 64 + page, way) for page in range(4))


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    seeds = {f"texture_of_surface_{config}": bound_texture(config) for config in range(6)}
    seeds |= {"questions_of_egl": questions_of_egl(), "displays": displays()}
    seeds |= {f"fences_{kind}": fences(kind) for kind in range(2)} | {f"images_{kind}": images(kind) for kind in ["", "KHR"]}
    tokens = [0x00, 0x0B, 0x0C, 0x0D, 0x11, 0x12, 0x19, 0x1F, 0x22, 0x24, 0x26, 0x28, 0x30, 0x40, 0x80, 0x81, 0x82, 0x84,
             0x85, 0x86, 0x87, 0x88, 0x8B]
    seeds |= {f"questions_{upper:02x}": questions(upper << 8, 0xFF) for upper in tokens}
    for name, seed in seeds.items():
        (folder / name).write_bytes(seed)


if __name__ == "__main__":
    main()
