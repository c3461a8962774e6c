# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
"""bench/trace under callgrind, for the scripts that count what it does: instructions.py, embree_walks.py."""
import argparse
import os
import pathlib
import re
import subprocess
import sys

from valgrind_libraries import copied


def bench_arguments(description, size):
    """[--bench PROGRAM] [--scenes DIR] [--size WxH] scene..., and the folder of libraries that valgrind can run."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bench", default="build/release/bench/trace")
    parser.add_argument("--scenes", default="../shared/scenes")
    parser.add_argument("--size", default=size)
    parser.add_argument("scene", nargs="+")
    arguments = parser.parse_args()
    if not pathlib.Path(arguments.bench).is_file():
        parser.error(f"{arguments.bench} is not there: build it, or name it with --bench")
    arguments.libraries = copied(arguments.bench, pathlib.Path(arguments.bench).parent / "valgrind")
    return arguments


def rays_counted(arguments, options, scene, kind, who):
    """Traces the rays of one kind; callgrind counts, as options say. How many rays there are."""
    command = ["valgrind", "--tool=callgrind", "--toggle-collect=*traceShare*", *options, arguments.bench, "--scenes",
               arguments.scenes, "--only", scene, "--size", arguments.size, "--rounds", "1", "--threads", "1",
               "--kind", kind, "--who", who]
    environment = {**os.environ, "RAYCORE_INSTRUCTION_SET": "avx2", "LD_LIBRARY_PATH": arguments.libraries}
    run = subprocess.run(command, env=environment, capture_output=True, text=True)
    found = re.search(r"of (\d+) rays", run.stdout)
    if run.returncode != 0 or not found:
        sys.exit(f"{' '.join(command)}\n{run.stdout}{run.stderr[-2000:]}")
    return int(found[1])
