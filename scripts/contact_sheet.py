#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
"""Renders models of the test set into one picture, with their names below.

    contact_sheet.py TOOL SCENES OUT.ppm [--columns N] [--tile WxH] [--only NAME,...]

Without --only: all valid models whose licence is CC0, CC BY, MIT, Apache or the public domain and nothing else.
"""
import argparse
import pathlib
import re
import subprocess
import tempfile

FREE = re.compile(r"^(CC0-1\.0|CC-BY-4\.0|MIT|Apache-2\.0|Public domain)( \([^)]*\))?( \+ (CC0-1\.0|CC-BY-4\.0))*$")
# Boxes whose open side is behind.
VIEWS = {"cornell_box": "180,0", "cornell_box_multimaterial": "180,0"}
LETTER = (6, 13)
MARGIN = 3


def models(scenes):
    """(file, licence) of each row of the table of scenes."""
    text = (scenes / "MANIFEST.md").read_text()
    table = text[text.index("## Scenes"):text.index("## Pictures")]
    for row in re.findall(r"^\| `([^`]*)` \|[^|]*\| ([^|]*) \|", table, re.M):
        if not row[0].endswith(".json"):
            yield row


def letters():
    """The tool's own font, as rows of bits."""
    text = (pathlib.Path(__file__).parent.parent / "tools/raycore/output/font.inc").read_text()
    return [[int(byte, 16) for byte in re.findall(r"0x(..)", line)] for line in text.splitlines() if line.startswith("{")]


def write(picture, width, x, y, text, font):
    for i, letter in enumerate(text):
        glyph = font[ord(letter) - 32] if 32 <= ord(letter) < 127 else font[ord("?") - 32]
        for row in range(LETTER[1]):
            for column in range(LETTER[0]):
                if glyph[row] >> column & 1:
                    at = ((y + row) * width + x + i * LETTER[0] + column) * 3
                    picture[at:at + 3] = b"\x20\x20\x20"


def render(tool, model, size, folder):
    out = folder / "tile.ppm"
    command = [tool, "render", str(model), "-q", "-o", str(out), "--size", "%dx%d" % size, "--samples", "9",
               "--background", "gradient"]
    if model.stem in VIEWS:
        command += ["--angle", VIEWS[model.stem]]
    subprocess.run(command, check=True)
    return out.read_bytes().split(b"\n", 3)[3]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("tool")
    parser.add_argument("scenes", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--columns", type=int, default=8)
    parser.add_argument("--tile", default="160x120")
    parser.add_argument("--only", default="")
    arguments = parser.parse_args()
    size = tuple(int(side) for side in arguments.tile.split("x"))
    only = [name for name in arguments.only.split(",") if name]
    chosen = [scene for scene, licence in models(arguments.scenes)
              if (pathlib.Path(scene).stem in only if only else FREE.match(licence))]
    if only:
        chosen.sort(key=lambda scene: only.index(pathlib.Path(scene).stem))
    step = (size[0] + 2 * MARGIN, size[1] + LETTER[1] + 2 * MARGIN)
    width, height = arguments.columns * step[0], -(-len(chosen) // arguments.columns) * step[1]
    picture, font = bytearray(b"\xff" * (width * height * 3)), letters()
    with tempfile.TemporaryDirectory() as folder:
        for i, scene in enumerate(chosen):
            x, y = i % arguments.columns * step[0] + MARGIN, i // arguments.columns * step[1] + MARGIN
            tile = render(arguments.tool, arguments.scenes / scene, size, pathlib.Path(folder))
            for row in range(size[1]):
                at = ((y + row) * width + x) * 3
                picture[at:at + size[0] * 3] = tile[row * size[0] * 3:(row + 1) * size[0] * 3]
            write(picture, width, x, y + size[1] + 1, pathlib.Path(scene).stem[:size[0] // LETTER[0]], font)
    arguments.out.write_bytes(b"P6\n%d %d\n255\n" % (width, height) + picture)
    print(f"{len(chosen)} models")


if __name__ == "__main__":
    main()
