#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
"""Copies libhwy so that valgrind can run it, and prints the copy's folder, for LD_LIBRARY_PATH.

  valgrind_libraries.py PROGRAM FOLDER

Valgrind 3.19 does not know RDTSCP, with which libhwy takes the time once when it is loaded: the copy has RDTSC there.
Prints nothing if the program does not need libhwy."""
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


if __name__ == "__main__":
    if folder := copied(sys.argv[1], pathlib.Path(sys.argv[2])):
        print(folder)
