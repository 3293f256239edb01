#!/usr/bin/env python3
"""Whether scenes still trace with as few instructions as recorded: what a new effect costs those that do not use it.

usage: instructions.py WHITTLE [--record]

Counts by callgrind (Debian package valgrind), which has no noise and knows no AVX-512: the instructions of the v3 kernel between a tile's rays
and its colours, one thread, 96x72 pixels. counts.csv beside this file holds what every scene took when it was recorded; a scene may take 0.5 %
more. A scene that takes less than four fifths is told too: functions that are counted by name may have gone into others, and a gain like that is
worth a new record. --record writes the file anew: for a change that is worth more than it costs, which its commit has to say. Exit status 77
(skipped) without valgrind, on a processor without AVX2, or where compiler, C library or processor are others than machine.txt says: they decide
the counts too, so that nothing would be compared but them.
"""
import csv
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
COUNTS = HERE / "counts.csv"
COUNTED = ["trace::shade_tile*", "csg::World::nearest(csg::RayTile*"]
MARGIN, LEAST = 0.005, 0.8


def instructions(whittle, scene, folder):
    picture = folder / (scene.replace("/", "_") + ".png")
    command = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", *(f"--toggle-collect={name}" for name in COUNTED), whittle,
               f"+I{ROOT / scene}", f"+O{picture}", "+W96", "+H72", "-A", "-D", "+WT1", "--isa=v3", "--quiet"]
    run = subprocess.run(command, capture_output=True, text=True)
    found = re.search(r"Collected : (\d+)", run.stderr)
    if run.returncode != 0 or not found:
        sys.exit(f"{' '.join(command)}\n{run.stderr[-2000:]}")
    return int(found[1])


def machine(whittle):
    """The program's compiler, the C library and the processor, a line each: the library chooses its functions by the processor."""
    compiler = re.search(r"^CMAKE_CXX_COMPILER:\w+=(.*)", (pathlib.Path(whittle).parent / "CMakeCache.txt").read_text(), re.M)[1]
    first = lambda *command: subprocess.run(command, capture_output=True, text=True).stdout.split("\n")[0]
    model = re.search(r"model name\s*: (.*)", pathlib.Path("/proc/cpuinfo").read_text())
    return f"{first(compiler, '--version')}\n{first('ldd', '--version')}\n{model[1] if model else 'unknown'}\n"


def main():
    if shutil.which("valgrind") is None or " avx2 " not in pathlib.Path("/proc/cpuinfo").read_text():
        print("needs valgrind and a processor with AVX2")
        sys.exit(77)
    record = "--record" in sys.argv[2:]
    known = HERE / "machine.txt"
    whittle = sys.argv[1]
    here = machine(whittle)
    if not record and here != known.read_text():
        print(f"counts.csv holds for\n{known.read_text()}alone, and this is\n{here}Nothing is compared.")
        sys.exit(77)
    with COUNTS.open() as file:
        recorded = {row["scene"]: int(row["instructions"]) for row in csv.DictReader(file)}
    with tempfile.TemporaryDirectory() as name, ThreadPoolExecutor(2) as pool:
        counts = dict(zip(recorded, pool.map(lambda scene: instructions(whittle, scene, pathlib.Path(name)), recorded)))
    over, under = [], []
    for scene, count in counts.items():
        change = count / recorded[scene] - 1.0 if recorded[scene] else 0.0
        print(f"{scene:32} {count / 1e6:9.2f} million {100.0 * change:+6.2f} %")
        if change > MARGIN:
            over.append(scene)
        if count < LEAST * recorded[scene]:
            under.append(scene)
    if record:
        known.write_text(here)
        COUNTS.write_text("scene,instructions\n" + "".join(f"{scene},{count}\n" for scene, count in counts.items()))
    elif over:
        sys.exit(f"more than {100.0 * MARGIN:g} % above counts.csv: {', '.join(over)}")
    elif under:
        sys.exit(f"less than {100.0 * LEAST:g} % of counts.csv: {', '.join(under)}")


if __name__ == "__main__":
    main()
