#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
"""Nodes and triangles that one ray after the other meets in Embree's tree (HIGH), on the rays of bench/walks: callgrind
counts how often the instructions run that test eight boxes, and four triangles.

  embree_walks.py [--bench build/release/bench/trace] [--scenes DIR] [--size 200x120] scene...

Where these instructions lie is known for Embree 3.13.5 of Debian 12, x86-64, with AVX2."""
import os
import re
import subprocess
import sys
import tempfile

from callgrind_bench import bench_arguments, rays_counted

LIBRARY = "libembree3.so.3.13.5"
BUILD = "ce263e1a14b1dbde5b9d85e80cec8947a8f6411f"
# In the kernel of single rays through nodes of eight: the first instruction of each.
RAY, NODE, LEAF, FOUR_TRIANGLES = 0x19886D0, 0x198898C, 0x1988A5B, 0x1988B08
WHAT = [RAY, NODE, LEAF, FOUR_TRIANGLES]
KINDS = ["primary", "mirror", "diffuse"]


def executions(lines):
    """By address, of the library's instructions; the format is callgrind's (positions: instr)."""
    counts, objects, inside, address, is_call = {}, {}, False, 0, False
    for line in lines:
        if name := re.match(r"(c?)ob=\((\d+)\)(?: (.*))?$", line):
            if name[3]:
                objects[name[2]] = name[3]
            if not name[1]:
                inside = objects[name[2]].endswith(LIBRARY)
        elif line.startswith("calls="):
            is_call = True
        elif cost := re.match(r"(0x[0-9a-f]+|[+-]\d+|\*)(?: \S+)? (\d+)$", line):
            at = cost[1]
            address = address if at == "*" else int(at, 16) if at.startswith("0x") else address + int(at)
            if inside and not is_call:
                counts[address] = counts.get(address, 0) + int(cost[2])
            is_call = False
    return counts


def counted(arguments, scene, kind):
    with tempfile.NamedTemporaryFile("r") as out:
        rays_counted(arguments, ["--dump-instr=yes", f"--callgrind-out-file={out.name}"], scene, kind, "=embree high")
        counts = executions(line.rstrip("\n") for line in out)
    return [counts.get(address, 0) for address in WHAT]


def main():
    arguments = bench_arguments(__doc__, "200x120")
    needed = subprocess.run(["ldd", arguments.bench], capture_output=True, text=True).stdout
    library = (re.findall(r"=> (\S+/libembree3\.so\S*)", needed) or [""])[0]
    notes = subprocess.run(["readelf", "-n", os.path.realpath(library)], capture_output=True, text=True).stdout
    if BUILD not in notes:
        sys.exit(f"this Embree ({library or 'none'}) is not the one whose instructions are known: {LIBRARY} of Debian 12")
    print("| scene | rays | nodes of eight a ray | leaves | four triangles at a time |\n|---|---|---:|---:|---:|")
    for scene in arguments.scene:
        # The bench traces the rays of a kind twice; before those of others, the primary ones once.
        primary = None
        for kind in KINDS:
            counts = counted(arguments, scene, kind)
            if kind == "primary":
                once = primary = [count // 3 for count in counts]
            else:
                once = [(count - first) // 2 for count, first in zip(counts, primary)]
            if once[0] == 0:
                sys.exit("the kernel whose instructions are known did not run: this processor has no AVX2?")
            print(f"| {scene} | {kind} | " + " | ".join(f"{count / once[0]:.2f}" for count in once[1:]) + " |", flush=True)


if __name__ == "__main__":
    main()
