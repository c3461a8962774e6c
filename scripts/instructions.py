#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
"""Instructions and cache misses a ray, ours beside Embree's, counted by callgrind: steadier than seconds.

  instructions.py [--bench build/release/bench/trace] [--scenes DIR] [--size 800x480] scene...

Valgrind 3.19 knows no AVX-512: both sides use AVX2 (and valgrind_libraries.py mends what else it does not know). The caches are simulated: the machine's first level, and its last.
Prints a Markdown table. Embree is built at its highest quality; the better of its two ways is shown.
"""

import re
import subprocess
import tempfile

from callgrind_bench import bench_arguments, rays_counted

KINDS = ["primary", "shadow", "from light", "mirror", "diffuse"]
SIDES = {"=raycore bvh": ["RaycoreTracer"], "embree high": ["Single", "Packets"]}
EVENTS = ["Ir", "Dr", "D1mr"]


def counts(arguments, scene, kind, who):
    """What each tracer of a side did, by event, and the number of rays."""
    with tempfile.NamedTemporaryFile() as out:
        rays = rays_counted(arguments, ["--cache-sim=yes", f"--callgrind-out-file={out.name}"], scene, kind, who)
        annotated = subprocess.run(["callgrind_annotate", "--inclusive=yes", "--threshold=100", f"--show={','.join(EVENTS)}",
                                    out.name], capture_output=True, text=True, check=True).stdout
    sums = {}
    for line in annotated.splitlines():
        tracer = re.search(r"\(anonymous namespace\)::(\w+)::trace\(", line)
        if not tracer or tracer[1] in sums:
            continue
        numbers = re.findall(r"([\d,]+) \(\s*[\d.]+%\)", line)
        sums[tracer[1]] = [int(number.replace(",", "")) for number in numbers[:len(EVENTS)]]
    return sums, rays


def per_ray(arguments, scene, side, tracers):
    """By kind: for each tracer what one ray costs. bench/trace traces the rays of a kind twice, and before them, with
    the first tracer, the primary ones once."""
    costs, primary = {}, None
    for kind in KINDS:
        sums, rays = counts(arguments, scene, kind, side)
        costs[kind] = {}
        for tracer in tracers:
            first = tracer == tracers[0]
            if kind == "primary":
                once = [value / (3 if first else 2) for value in sums[tracer]]
                primary = once if first else primary
            else:
                once = [(value - (p if first else 0)) / 2 for value, p in zip(sums[tracer], primary)]
            costs[kind][tracer] = [value / rays for value in once]
    return costs


def main():
    arguments = bench_arguments(__doc__, "800x480")
    print("| scene | rays | instructions | Embree | ratio | reads | Embree | misses of the first level | Embree |")
    print("|---|---|---:|---:|---:|---:|---:|---:|---:|")
    for scene in arguments.scene:
        ours, theirs = (per_ray(arguments, scene, side, tracers) for side, tracers in SIDES.items())
        for kind in KINDS:
            mine = ours[kind]["RaycoreTracer"]
            best = min(theirs[kind].values(), key=lambda cost: cost[0])
            print(f"| {scene} | {kind} | {mine[0]:.0f} | {best[0]:.0f} | **{best[0] / mine[0]:.2f}** | {mine[1]:.0f} | "
                  f"{best[1]:.0f} | {mine[2]:.2f} | {best[2]:.2f} |", flush=True)


if __name__ == "__main__":
    main()
