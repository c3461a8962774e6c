#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
"""Makes inputs of fuzz_api of the calls that programs and tests make.

    RAYCORE_TRACE=calls.txt build/release/tests/api/api_test
    tests/fuzz/trace_to_seeds.py calls.txt FOLDER

Draw calls and images, whose memory a trace does not show, become the target's own."""
import pathlib
import re
import struct
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
CALLS_A_SEED = 40
PLAIN_CALL, SWAP, DRAW, IMAGE = 0, 227, 228, 229  # codes of fuzz_api.cpp's steps
STEPS = {"rcDrawArrays": DRAW, "rcDrawElements": DRAW, "rcTexImage2D": IMAGE}


def code_of(name):
    value = 2166136261
    for char in name.encode():
        value = (value ^ char) * 16777619 & 0xFFFFFFFF
    return value >> 16


def parameters():
    text = (ROOT / "src/api/functions.inc").read_text()
    rows = re.findall(r"^RC_FUNCTION\([^,]*, (\w+), \(([^)]*)\)", text, re.M)
    return {name: [] if given == "void" else given.split(", ") for name, given in rows}


def tokens(*headers):
    """Of our header of tokens, and of others."""
    text = "".join(header.read_text() for header in (ROOT / "include/RC/rctokens.h", *headers))
    return {name: int(value, 0)
            for name, value in re.findall(r"^#define ((?:RC|EGL)_\w+)\s+(0x[0-9A-Fa-f]+|\d+)\b", text, re.M)}


def number_in(text, names):
    text = text.strip()
    if text in names:
        return names[text]
    if re.fullmatch(r"-?[\d.]+(e[-+]?\d+)?x", text):
        return round(float(text[:-1]) * 65536)
    return int(text, 0) if re.fullmatch(r"-?(0x[0-9A-Fa-f]+|\d+)", text) else float(text)


def encoded(kind, value):
    if kind in ("RCenum", "RCuint", "RCbitfield"):
        value = int(value) & 0xFFFFFFFF
        return struct.pack("<H", value) if value < 0xFFFF else struct.pack("<HI", 0xFFFF, value)
    if kind in ("RCfloat", "RCclampf", "RCdouble"):
        code = float(value) * 8 + 96
        return bytes([int(code)]) if code == code // 1 and 0 <= code < 192 else b"\xff" + struct.pack("<f", value)
    if kind in ("RCubyte", "RCboolean"):
        return bytes([int(value) & 255])
    if kind in ("RCint", "RCsizei", "RCfixed", "RCclampx"):
        value = (int(value) + 2**31) % 2**32 - 2**31
        return bytes([value + 64]) if -64 <= value <= 127 else b"\xff" + struct.pack("<i", value)
    raise ValueError(kind)


def split(text):
    """Arguments between commas that stand in no braces."""
    return [part.split(" = ", 1)[1] for part in re.findall(r"\w+ = (?:\{[^}]*\}|[^,{]*)", text)]


def call_in(line, kinds, names):
    found = re.match(r"frame \d+: (rc\w+)\((.*?)\)(?::|$| =)", line)
    if not found or re.match(r"rc(Read|Debug)", found[1]):
        return None
    name = found[1]
    if name in STEPS:
        return bytes([STEPS[name], 0, 0])
    result = struct.pack("<BH", PLAIN_CALL, code_of(name))
    for parameter, value in zip(kinds[name], split(found[2])):
        kind, pointer = parameter.replace("const ", "").split(" ", 1)[0], "*" in parameter
        if not pointer:
            result += encoded(kind, number_in(value, names))
        elif "const" not in parameter:
            result += bytes([1]) + (b"" if kind == "RCvoid" else encoded(kind, 0))
        elif value.startswith("{"):
            values = [number_in(v, names) for v in value[1:-1].split(",") if v.strip()]
            result += bytes([len(values)]) + b"".join(encoded(kind, v) for v in values)
        else:
            return None
    return result


def main():
    kinds, names = parameters(), tokens()
    folder = pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    calls = []
    for line in open(sys.argv[1], errors="replace"):
        try:
            call = call_in(line.rstrip("\n"), kinds, names)
        except (ValueError, KeyError, OverflowError):
            continue
        if call and (not calls or call != calls[-1]):
            calls.append(call)
    for start in range(0, len(calls), CALLS_A_SEED):
        seed = bytes(5) + b"".join(calls[start:start + CALLS_A_SEED]) + bytes([SWAP])
        (folder / f"calls_{start:06d}").write_bytes(seed)
    print(f"{len(calls)} calls")


if __name__ == "__main__":
    main()
