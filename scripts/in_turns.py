#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
"""Compares builds of the library to half a percent on a machine that others use too: they take turns, two frames each,
on one core and one thread. For each scene and build: the median over several starts of the median ratio to the first
build of the turn, the ratios of the starts, and the least milliseconds of a frame.

    before=$(mktemp -d); cp -a build/release/src/egl/libRayCoreAPI.so* "$before"    # then change and build
    scripts/in_turns.py "$before" build/release/src/egl

Name the first build twice (copied) to see what the noise is.
"""
import argparse
import os
import pathlib
import statistics
import subprocess
import sys


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bench", default="build/release/bench/turns")
    parser.add_argument("--scenes", default="../shared/scenes")
    parser.add_argument("--only", default="cornell,bunny,sponza")
    parser.add_argument("--size", default="800x480")
    parser.add_argument("--starts", type=int, default=6)
    parser.add_argument("--rounds", type=int, default=24)
    parser.add_argument("builds", nargs="+", metavar="FOLDER", help="with libRayCoreAPI.so")
    given = parser.parse_args()
    for folder in given.builds:
        if not (pathlib.Path(folder) / "libRayCoreAPI.so").exists():
            parser.error(f"{folder} holds no libRayCoreAPI.so")
    if not pathlib.Path(given.bench).is_file():
        parser.error(f"{given.bench} is not there: build it, or name it with --bench")
    return given


class Build:
    def __init__(self, given, folder, scene):
        environment = {**os.environ, "LD_LIBRARY_PATH": str(pathlib.Path(folder).resolve())}
        command = [given.bench, "--scenes", given.scenes, "--only", scene, "--size", given.size]
        self.program = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
                                        env=environment)

    def draw(self, frames):
        self.program.stdin.write(f"{frames}\n")
        self.program.stdin.flush()
        line = self.program.stdout.readline()
        if not line:
            sys.exit(f"the bench ended with code {self.program.wait()}")
        return float(line)

    def end(self):
        self.program.stdin.close()
        self.program.wait()


def take_turns(given, scene):
    """By build: the ratios of the rounds, and the least milliseconds."""
    builds = [Build(given, folder, scene) for folder in given.builds]
    for build in builds:
        build.draw(3)
    ratios, least = [[] for _ in builds], [float("inf")] * len(builds)
    for turn in range(given.rounds):
        order = range(len(builds)) if turn % 2 == 0 else reversed(range(len(builds)))
        times = {i: builds[i].draw(2) for i in order}
        for i, time in times.items():
            ratios[i].append(time / times[0])
            least[i] = min(least[i], time)
    for build in builds:
        build.end()
    return [statistics.median(of) for of in ratios], least


def main():
    given = arguments()
    os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
    for scene in given.only.split(","):
        starts = [take_turns(given, scene) for _ in range(given.starts)]
        for i, folder in enumerate(given.builds):
            ratios = [medians[i] for medians, _ in starts]
            print(f"{scene:13} {statistics.median(ratios):.3f}  {min(least[i] for _, least in starts):7.2f} ms  "
                  f"{folder}  ({' '.join(f'{ratio:.3f}' for ratio in ratios)})", flush=True)


main()
