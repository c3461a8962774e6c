#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
"""Copies libhwy so that valgrind can run it, and prints the copy's folder, for LD_LIBRARY_PATH.

  valgrind_libraries.py PROGRAM FOLDER

Valgrind 3.19 does not know RDTSCP, with which libhwy takes the time once when it is loaded: the copy has RDTSC there.
Prints nothing if the program does not need libhwy."""
import argparse
import os
import pathlib
import re
import subprocess
import sys

RDTSCP, RDTSC_NOP = b"\x0f\x01\xf9", b"\x0f\x31\x90"


def copied(program, folder):
    """The folder of the copy; empty if the program does not need libhwy."""
    needed = subprocess.run(["ldd", program], capture_output=True, text=True, check=True).stdout
    found = re.search(r"(libhwy\.so\.\d+) => (\S+)", needed)
    if not found:
        return ""
    folder.mkdir(parents=True, exist_ok=True)
    # Never written where it lies: another program may have it mapped.
    fresh = folder / f"{found[1]}.{os.getpid()}"
    fresh.write_bytes(pathlib.Path(found[2]).read_bytes().replace(RDTSCP, RDTSC_NOP))
    fresh.replace(folder / found[1])
    return str(folder.resolve())


def bench_arguments(description, size):
    """Of the scripts that count what bench/trace does."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bench", default="build/release/bench/trace")
    parser.add_argument("--scenes", default="../shared/scenes")
    parser.add_argument("--size", default=size)
    parser.add_argument("scene", nargs="+")
    return parser.parse_args()


def callgrind(arguments, options, scene, kind, who):
    """What bench/trace prints when callgrind counts what it does for one kind of ray."""
    libraries = copied(arguments.bench, pathlib.Path(arguments.bench).parent / "valgrind")
    command = ["valgrind", "--tool=callgrind", "--toggle-collect=*traceShare*", *options, arguments.bench, "--scenes",
               arguments.scenes, "--only", scene, "--size", arguments.size, "--rounds", "1", "--threads", "1",
               "--kind", kind, "--who", who]
    environment = {**os.environ, "RAYCORE_INSTRUCTION_SET": "avx2", "LD_LIBRARY_PATH": libraries}
    run = subprocess.run(command, env=environment, capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(f"{' '.join(command)}\n{run.stdout}{run.stderr[-2000:]}")
    return run.stdout


if __name__ == "__main__":
    if folder := copied(sys.argv[1], pathlib.Path(sys.argv[2])):
        print(folder)
