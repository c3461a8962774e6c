#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
"""Copies libhwy so that valgrind can run it, and prints the copy's folder, for LD_LIBRARY_PATH.

  valgrind_libraries.py PROGRAM FOLDER

Valgrind 3.19 does not know RDTSCP, with which libhwy takes the time once when it is loaded: the copy has RDTSC there.
Prints nothing if the program does not need libhwy."""
import pathlib
import re
import subprocess
import sys

RDTSCP, RDTSC_NOP = b"\x0f\x01\xf9", b"\x0f\x31\x90"


def main():
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    needed = subprocess.run(["ldd", program], capture_output=True, text=True, check=True).stdout
    found = re.search(r"(libhwy\.so\.\d+) => (\S+)", needed)
    if not found:
        return
    folder.mkdir(parents=True, exist_ok=True)
    (folder / found[1]).write_bytes(pathlib.Path(found[2]).read_bytes().replace(RDTSCP, RDTSC_NOP))
    print(folder.resolve())


main()
