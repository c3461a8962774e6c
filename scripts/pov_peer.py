#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
"""One scene for raycore and for POV-Ray: pov_peer.py FOLDER [balls|panes] writes scene.gltf and scene.pov.

A plaster knot on a mirror floor, before a grey background; one light with shadows. Beside it a ball of glass and one that
mirrors, or before it two panes of glass and behind it a mirror. All are meshes. Then, no antialiasing, depth 14, and the
same view:

    raycore render scene.gltf -o ours.png --samples 1 --bounces 14 --background 0.3,0.35,0.4 \\
      --eye 0,2.2,5 --look-at 0,0.7,0 --fov 40          (RAYCORE_LOG=frame tells the time of tracing)
    povray -D -A +W800 +H480 +WT2 +Iscene.pov +Opov.png   (it prints the time of tracing)
"""
import base64
import json
import math
import pathlib
import struct
import sys

EYE, AT, FOV, ASPECT, LIGHT = (0, 2.2, 5), (0, 0.7, 0), 40, 800 / 480, (4, 7, 5)
BACKGROUND = (0.3, 0.35, 0.4)


def grid(rows, columns, point):
    """Vertices with normals from point(u, v), and triangles."""
    vertices, normals, triangles = [], [], []
    for i in range(rows + 1):
        for j in range(columns + 1):
            position, normal = point(i / rows, j / columns)
            vertices.append(position)
            normals.append(normal)
    for i in range(rows):
        for j in range(columns):
            k = i * (columns + 1) + j
            triangles += [(k, k + 1, k + columns + 2), (k, k + columns + 2, k + columns + 1)]
    return vertices, normals, triangles


def ball(centre, radius):
    def point(u, v):
        a, b = math.pi * (0.001 + 0.998 * u), 2 * math.pi * v
        normal = (math.sin(a) * math.cos(b), math.cos(a), math.sin(a) * math.sin(b))
        return tuple(c + radius * n for c, n in zip(centre, normal)), normal

    return grid(96, 192, point)


def unit(v):
    length = math.sqrt(sum(c * c for c in v))
    return tuple(c / length for c in v)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def knot(centre, size, thickness):
    def curve(t):
        r = 2 + math.cos(3 * t)
        return (r * math.cos(2 * t) / 3, r * math.sin(2 * t) / 3, math.sin(3 * t) / 3)

    def point(u, v):
        t, s = 2 * math.pi * u, 2 * math.pi * v
        here, there = curve(t), curve(t + 1e-3)
        side = unit(cross(unit(tuple(b - a for a, b in zip(here, there))), (0.3, 0.1, 1)))
        up = unit(cross(side, tuple(b - a for a, b in zip(here, there))))
        normal = tuple(math.cos(s) * a + math.sin(s) * b for a, b in zip(side, up))
        return tuple(c + size * h + thickness * n for c, h, n in zip(centre, here, normal)), normal

    return grid(400, 40, point)


def quad(corner, right, up):
    normal = unit(cross(right, up))

    def point(u, v):
        return tuple(c + v * r + u * h for c, r, h in zip(corner, right, up)), normal

    return grid(1, 1, point)


def joined(*meshes):
    vertices, normals, triangles = [], [], []
    for more, directions, corners in meshes:
        triangles += [tuple(len(vertices) + i for i in corner) for corner in corners]
        vertices += more
        normals += directions
    return vertices, normals, triangles


def box(lower, upper):
    (x, y, z), (w, h, d) = lower, (b - a for a, b in zip(lower, upper))
    right, up, front = (w, 0, 0), (0, h, 0), (0, 0, d)
    left, back = (-w, 0, 0), (0, 0, -d)
    return joined(
        quad((x, y, z + d), right, up),
        quad((x + w, y, z), left, up),
        quad((x + w, y, z + d), back, up),
        quad((x, y, z), front, up),
        quad((x, y + h, z + d), right, back),
        quad((x, y, z), right, front),
    )


# mesh, colour, metal, glass
FLOOR = (quad((-12, 0, 12), (24, 0, 0), (0, 0, -24)), (0.5, 0.5, 0.5), 0.5, False)
KNOT = (knot((0, 1.1, -0.9), 0.9, 0.14), (0.9, 0.6, 0.4), 0, False)
SCENES = {
    "balls": [
        FLOOR,
        (ball((-1.3, 0.72, 0.6), 0.7), (1, 1, 1), 0, True),
        (ball((1.4, 0.82, -0.4), 0.8), (0.9, 0.9, 0.9), 1, False),
        KNOT,
    ],
    "panes": [
        FLOOR,
        (box((-1.5, 0.02, 0.6), (-0.1, 1.7, 0.7)), (1, 1, 1), 0, True),
        (box((0.1, 0.02, 0.9), (1.3, 1.3, 1.0)), (1, 1, 1), 0, True),
        (quad((-2.5, 0.05, -3), (5, 0, 0), (0, 2.6, 0)), (0.9, 0.9, 0.9), 1, False),
        KNOT,
    ],
}


def write_gltf(path, things):
    binary, views, accessors, meshes, materials = bytearray(), [], [], [], []

    def add(payload, component, kind, count, limits=None):
        views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(payload)})
        accessors.append(
            {"bufferView": len(views) - 1, "componentType": component, "type": kind, "count": count} | (limits or {})
        )
        binary.extend(payload)
        return len(accessors) - 1

    for (vertices, normals, triangles), colour, metal, glass in things:
        limits = {"min": [min(c) for c in zip(*vertices)], "max": [max(c) for c in zip(*vertices)]}
        positions = add(b"".join(struct.pack("<3f", *v) for v in vertices), 5126, "VEC3", len(vertices), limits)
        directions = add(b"".join(struct.pack("<3f", *n) for n in normals), 5126, "VEC3", len(vertices))
        order = add(b"".join(struct.pack("<3I", *t) for t in triangles), 5125, "SCALAR", 3 * len(triangles))
        material = {
            "doubleSided": True,
            "pbrMetallicRoughness": {
                "baseColorFactor": [*colour, 1],
                "metallicFactor": metal,
                "roughnessFactor": 0 if metal or glass else 1,
            },
        }
        if glass:
            material["extensions"] = {
                "KHR_materials_transmission": {"transmissionFactor": 1},
                "KHR_materials_ior": {"ior": 1.5},
                "KHR_materials_volume": {"thicknessFactor": 1},
            }
        materials.append(material)
        attributes = {"POSITION": positions, "NORMAL": directions}
        meshes.append({"primitives": [{"attributes": attributes, "indices": order, "material": len(materials) - 1}]})
    lights = {"lights": [{"type": "point", "intensity": 1000}]}
    nodes = [{"mesh": i} for i in range(len(meshes))]
    nodes.append({"translation": LIGHT, "extensions": {"KHR_lights_punctual": {"light": 0}}})
    names = ["materials_transmission", "materials_ior", "materials_volume", "lights_punctual"]
    document = {
        "asset": {"version": "2.0"},
        "extensionsUsed": ["KHR_" + name for name in names],
        "extensions": {"KHR_lights_punctual": lights},
        "buffers": [
            {
                "byteLength": len(binary),
                "uri": "data:application/octet-stream;base64," + base64.b64encode(binary).decode(),
            }
        ],
        "bufferViews": views,
        "accessors": accessors,
        "materials": materials,
        "meshes": meshes,
        "nodes": nodes,
        "scenes": [{"nodes": list(range(len(nodes)))}],
        "scene": 0,
    }
    path.write_text(json.dumps(document))


def vector(v):
    return "<" + ",".join(f"{c:.6g}" for c in v) + ">"


def write_pov(path, things):
    # POV-Ray's x runs the other way round for one who looks along -z: mirrored by the sign of `right`.
    angle = 2 * math.degrees(math.atan(math.tan(math.radians(FOV / 2)) * ASPECT))
    with path.open("w") as out:
        out.write("#version 3.7;\nglobal_settings { max_trace_level 14 assumed_gamma 1.0 }\n")
        out.write(f"background {{ rgb {vector(BACKGROUND)} }}\n")
        out.write(f"camera {{ location {vector(EYE)} right -x*{ASPECT:.6f} up y angle {angle:.4f} look_at {vector(AT)} }}\n")
        out.write(f"light_source {{ {vector(LIGHT)} rgb 1 }}\n")
        for (vertices, normals, triangles), colour, metal, glass in things:
            lists = [("vertex_vectors", vertices), ("normal_vectors", normals), ("face_indices", triangles)]
            out.write("mesh2 {\n")
            for name, values in lists:
                out.write(f"{name} {{ {len(values)},\n" + ",\n".join(map(vector, values)) + " }\n")
            if glass:
                out.write("pigment { rgbf <1,1,1,0.92> } finish { ambient 0 diffuse 0 reflection 0.08 } interior { ior 1.5 }\n")
            else:
                out.write(f"pigment {{ rgb {vector(colour)} }} ")
                out.write(f"finish {{ ambient 0.1 diffuse {1 - metal} reflection {metal * colour[0]} }}\n")
            out.write("}\n")


def main():
    if len(sys.argv) not in (2, 3) or sys.argv[-1] not in SCENES and len(sys.argv) == 3:
        sys.exit(__doc__)
    things = SCENES[sys.argv[2] if len(sys.argv) == 3 else "balls"]
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    write_gltf(folder / "scene.gltf", things)
    write_pov(folder / "scene.pov", things)


main()
