#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
"""Puts balls of glass and a light about a walking figure: walk_scene.py CesiumMan.glb walk.glb

The film of docs/numbers.md: raycore render walk.glb --ground mirror --frames 0-299 ...
"""
import json
import math
import struct
import sys

BALLS = [(-0.85, 0.3, 0.35), (0.8, 0.25, 0.5), (0.25, 0.14, 0.95)]  # x, radius, z: they lie on the ground
COLOURS = [(0.9, 0.97, 1), (1, 0.9, 0.8), (0.8, 1, 0.85)]
LIGHT = (2.5, 5, 3)
EXTENSIONS = {f"KHR_{name}" for name in ("materials_transmission", "materials_ior", "materials_volume", "lights_punctual")}


def read_glb(path):
    with open(path, "rb") as file:
        data = file.read()
    magic, _, _ = struct.unpack_from("<4sII", data)
    if magic != b"glTF":
        sys.exit(f"walk_scene.py: {path} is not a GLB file")
    length, _ = struct.unpack_from("<II", data, 12)
    document = json.loads(data[20 : 20 + length])
    start = 20 + length
    size, _ = struct.unpack_from("<II", data, start)
    return document, bytearray(data[start + 8 : start + 8 + size])


def write_glb(path, document, binary):
    text = json.dumps(document, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    binary += b"\0" * (-len(binary) % 4)
    with open(path, "wb") as file:
        file.write(struct.pack("<4sII", b"glTF", 2, 12 + 8 + len(text) + 8 + len(binary)))
        file.write(struct.pack("<I4s", len(text), b"JSON") + text)
        file.write(struct.pack("<I4s", len(binary), b"BIN\0") + binary)


def ball(n):
    """Vertices, which are normals too, and indices of a unit ball."""
    vertices, indices = [], []
    for i in range(n + 1):
        for j in range(2 * n + 1):
            a, b = math.pi * i / n, math.pi * j / n
            vertices.append((math.sin(a) * math.cos(b), math.cos(a), math.sin(a) * math.sin(b)))
    for i in range(n):
        for j in range(2 * n):
            k = i * (2 * n + 1) + j
            indices += [k, k + 1, k + 2 * n + 2, k, k + 2 * n + 2, k + 2 * n + 1]
    return vertices, indices


def add_accessor(document, binary, payload, component, kind, count, limits=None):
    binary += b"\0" * (-len(binary) % 4)
    document["bufferViews"].append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(payload)})
    binary += payload
    accessor = {"bufferView": len(document["bufferViews"]) - 1, "componentType": component, "type": kind, "count": count}
    document["accessors"].append(accessor | (limits or {}))
    return len(document["accessors"]) - 1


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    document, binary = read_glb(sys.argv[1])
    vertices, indices = ball(24)
    flat = [c for v in vertices for c in v]
    limits = {"min": [-1, -1, -1], "max": [1, 1, 1]}
    positions = add_accessor(document, binary, struct.pack(f"<{len(flat)}f", *flat), 5126, "VEC3", len(vertices), limits)
    normals = add_accessor(document, binary, struct.pack(f"<{len(flat)}f", *flat), 5126, "VEC3", len(vertices))
    order = add_accessor(document, binary, struct.pack(f"<{len(indices)}H", *indices), 5123, "SCALAR", len(indices))
    for (x, size, z), colour in zip(BALLS, COLOURS):
        glass = {
            "KHR_materials_transmission": {"transmissionFactor": 1},
            "KHR_materials_ior": {"ior": 1.5},
            "KHR_materials_volume": {"thicknessFactor": 2 * size},
        }
        surface = {"baseColorFactor": [*colour, 1], "metallicFactor": 0, "roughnessFactor": 0}
        document["materials"].append({"pbrMetallicRoughness": surface, "extensions": glass})
        primitive = {"attributes": {"POSITION": positions, "NORMAL": normals}, "indices": order}
        document["meshes"].append({"primitives": [primitive | {"material": len(document["materials"]) - 1}]})
        document["nodes"].append(
            {"mesh": len(document["meshes"]) - 1, "translation": [x, size, z], "scale": [size, size, size]}
        )
        document["scenes"][document.get("scene", 0)]["nodes"].append(len(document["nodes"]) - 1)
    document.setdefault("extensions", {})["KHR_lights_punctual"] = {"lights": [{"type": "point", "intensity": 100}]}
    document["nodes"].append({"translation": LIGHT, "extensions": {"KHR_lights_punctual": {"light": 0}}})
    document["scenes"][document.get("scene", 0)]["nodes"].append(len(document["nodes"]) - 1)
    document["buffers"][0]["byteLength"] = len(binary)
    document["extensionsUsed"] = sorted(EXTENSIONS | set(document.get("extensionsUsed", [])))
    write_glb(sys.argv[2], document, binary)


main()
