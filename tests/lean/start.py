#!/usr/bin/env python3
"""Whether the program starts as fast as it should: `--version` in 2 ms, a sphere in 80x60 pixels in 5 ms, from exec to exit.

usage: start.py WHITTLE

Counts instructions by callgrind, as instructions.py beside this file does: a clock tells of whatever else the machine does. LIMITS are today's counts
and a twentieth: of 2.29 and 7.13 million, before the program had the C++ runtime within, the first took 1.9 to 2.1 ms and the other 3.5 to 5, by
what else ran, where a page costs little when it is touched first.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from instructions import HERE, machine

SPHERE = """#version 3.7; global_settings { assumed_gamma 1 }
camera { location -4*z look_at 0 } light_source { <-5,9,-9> 1 } sphere { 0, 1 pigment { rgb 1 } }
"""
LIMITS = {"--version": 0.27e6, "a sphere": 4.75e6}


def instructions(whittle, *switches):
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "one.pov").write_text(SPHERE)
        command = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", whittle, *switches]
        run = subprocess.run(command, capture_output=True, text=True, cwd=folder)
    found = re.search(r"Collected : (\d+)", run.stderr)
    if run.returncode != 0 or not found:
        sys.exit(f"{' '.join(command)}\n{run.stderr[-2000:]}")
    return int(found[1])


def main():
    whittle = sys.argv[1]
    built = lambda text: text.split("\n")[:2]  # compiler and C library; the processor makes little difference here
    if shutil.which("valgrind") is None or built(machine(whittle)) != built((HERE / "machine.txt").read_text()):
        print("needs valgrind, and compiler and C library of machine.txt")
        sys.exit(77)
    counts = {"--version": instructions(whittle, "--version"),
              "a sphere": instructions(whittle, "+Ione.pov", "+Oone.png", "+W80", "+H60", "-A", "-D", "+WT1", "--isa=v3", "--quiet")}
    for what, count in counts.items():
        print(f"{what:12} {count / 1e6:6.2f} million, at most {LIMITS[what] / 1e6:.2f}")
    return 1 if any(count > LIMITS[what] for what, count in counts.items()) else 0


if __name__ == "__main__":
    sys.exit(main())
