#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
"""Makes inputs of fuzz_api of pictures that take many calls in a row, which bytes hardly ever meet: panes behind each
other whose texels are there in part, and which mirror, break light, glow in fog, are cut or move between frames.

    tests/fuzz/layer_seeds.py FOLDER"""
import itertools
import pathlib
import sys

from egl_seeds import call, integer, unsigned
from trace_to_seeds import DRAW, IMAGE, SWAP, encoded

BEGIN = bytes(5)
PANE, IMAGE_WITH_ALPHA = bytes([DRAW, 0]), bytes([IMAGE, 7, 3])
PANES = 9
MOST_BOUNCES = 3  # of the target, which has to go on


def number(value):
    return encoded("RCfloat", value)


def numbers(*values):
    return bytes([len(values)]) + b"".join(number(value) for value in values)


def enable(*names):
    return b"".join(call("rcEnable", unsigned(name)) for name in names)


def translate(x, y, z):
    return call("rcTranslatef", number(x), number(y), number(z))


def material(name, *values):
    return call("rcMaterialfv", unsigned("RC_FRONT_AND_BACK"), unsigned(name), numbers(*values))


def lights(count):
    result = enable("RC_LIGHTING", "RC_USE_SHADOW", "RC_USE_COLOR_SHADOW", "RC_USE_TRANSMITTANCE_SHADOW",
                    "RC_USE_TEXTURE_ALPHA_SHADOW")
    for i in range(count):
        name = f"RC_LIGHT{i}"
        result += enable(name) + call("rcLightfv", unsigned(name), unsigned("RC_POSITION"), numbers(i - 1.5, 2, 3 - 2 * i, 1))
    return result


def texture():
    place = b"\x01" + (7).to_bytes(2, "little")
    coordinates = call("rcTexCoordPointer", integer(2), unsigned("RC_FLOAT"), integer(0), place)
    coordinates += call("rcEnableClientState", unsigned("RC_TEXTURE_COORD_ARRAY"))
    blend = call("rcBlendFunc", unsigned("RC_SRC_ALPHA"), unsigned("RC_ONE_MINUS_SRC_ALPHA"))
    without_levels = call("rcTexParameteri", unsigned("RC_TEXTURE_2D"), unsigned("RC_TEXTURE_MIN_FILTER"), integer("RC_LINEAR"))
    return IMAGE_WITH_ALPHA + without_levels + coordinates + enable("RC_BLEND") + blend


MATERIALS = {
    "mirrors": material("RC_REFLECTION", 0.25, 0.5, 0.25, 1),
    "glass": material("RC_TRANSMITTANCE", 0.5, 0.5, 0.5, 1) + call("rcMaterialf", unsigned("RC_FRONT_AND_BACK"),
                                                                   unsigned("RC_REFRACTION_INDEX"), number(1.5)),
    "both": material("RC_REFLECTION", 0.5, 0.5, 0.5, 1) + material("RC_TRANSMITTANCE", 0.5, 0.5, 0.5, 1),
}
EFFECTS = {
    "plain": b"",
    "cut_out": enable("RC_ALPHA_TEST") + call("rcAlphaFunc", unsigned("RC_GREATER"), number(0.5)),
    "fog": enable("RC_FOG") + call("rcFogf", unsigned("RC_FOG_DENSITY"), number(0.25)),
    "clipped": call("rcClipPlanef", unsigned("RC_CLIP_PLANE0"), numbers(1, 0, 0, 0.5)) + enable("RC_CLIP_PLANE0"),
}
# Between the panes of one picture: how the next one lies.
STEPS = {
    "behind": translate(0, 0, -0.25),
    "together": b"",
    "turned": call("rcRotatef", number(20), number(0), number(1), number(0)),
    "shrinking": call("rcScalef", number(0.75), number(0.75), number(0.75)),
}


def picture(surface, effect, step):
    prepared = texture() + lights(2) + MATERIALS[surface] + EFFECTS[effect] + call("rcDepthBounce", bytes([MOST_BOUNCES]))
    panes = b"".join(PANE + bytes([3 * i]) + STEPS[step] for i in range(PANES))
    again = call("rcLoadIdentity") + translate(0.25, 0, -3) + panes  # refitted
    return BEGIN + prepared + panes + bytes([SWAP]) + again + bytes([SWAP]) + call("rcFinish")


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for parts in itertools.product(MATERIALS, EFFECTS, STEPS):
        (folder / "_".join(("panes", *parts))).write_bytes(picture(*parts))


if __name__ == "__main__":
    main()
