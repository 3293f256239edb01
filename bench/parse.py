#!/usr/bin/python3
"""Speed of reading scenes against POV-Ray.

usage: bench/parse.py [SCENE...] [--bar 10] [--mean 30] [--runs 5] [--whittle CMD] [--povray CMD] [--examples FOLDER]
       bench/parse.py --distribution [SCENE...] [--cache FILE] [--whittle CMD] [--povray CMD] [--examples FOLDER]

Both programs read each scene in turn, `--runs` times. POV-Ray's time is the processor time of its parsing alone, as it
prints it; Whittle's is that of a whole `--parse-only` run, start and end included. The median of the runs counts. What the
scenes print must be equal. Peak memory is that of the whole process. Exit status 1 if a ratio is below the bar, the geometric
mean of all is below --mean, memory is above POV-Ray's or the text differs.

--distribution: every scene of POV-Ray's own, twice, the least counts; exit status 1 if one is read more slowly where POV-Ray
needs 20 ms or more. Only those are listed that are slower than half of POV-Ray's time. Names pick scenes (parts of their
paths). --cache keeps POV-Ray's times in a file, so that a run that was interrupted goes on where it was.
"""
import argparse
import json
import math
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import sys
import tempfile

import parse_inputs

HERE = pathlib.Path(__file__).resolve().parent
PARSE = re.compile(r"Parse Time:.*?\(([0-9.]+) seconds\)\s*using 1 thread\(s\) with ([0-9.]+) CPU-seconds", re.S)
SIZE = ["+W320", "+H240"]
OURS = sorted(path.stem for path in (HERE / "parse").glob("*.pov"))
EXAMPLES = {"tracevines": "language/tracevines.pov", "mesh_camera": "camera/mesh_camera/meshcam_persp_demo.pov"}
LEAST_SECONDS = 0.02  # what POV-Ray reads faster is not compared


def run(command, folder, may_fail=False):
    """Text, processor seconds and peak kilobytes of a program; no text if it failed and may."""
    with tempfile.TemporaryFile("w+", errors="replace") as said:
        process = subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=said, stderr=subprocess.STDOUT)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        said.seek(0)
        text = said.read()
    if process.returncode != 0:
        if not may_fail:
            sys.exit(f"{' '.join(map(str, command))}: exit status {process.returncode}\n{text[-600:]}")
        text = ""
    return text, usage.ru_utime + usage.ru_stime, usage.ru_maxrss


def read_by_povray(args, source, folder, may_fail=False):
    """Text, seconds of its parsing (nothing if it failed) and kilobytes."""
    command = [args.povray, f"+I{source.name}", *SIZE, "-D", "-P", "-F", "+WT1", "+SR1", "+ER1", "+Q0"]  # reads all, traces next to nothing
    text, _, memory = run(command, folder, may_fail)
    seconds = PARSE.search(text)
    return text, float(seconds.group(2)) if seconds else None, memory


def read_by_whittle(args, source, folder, may_fail=False):
    return run([args.whittle, "--parse-only", f"+I{source.name}", *SIZE, "+L/usr/share/povray-3.7/include"], folder, may_fail)


def printed(text):
    """The lines that #debug of our own scenes prints."""
    return re.findall(r"^(?:total|sum) .*", text, re.M)


def compare(args, name, source, scratch):
    """Reads one scene by both, prints its row; its ratio and whether all is well but the ratio."""
    folder = pathlib.Path(scratch, name)  # these scenes write files: beside a copy of themselves
    shutil.copytree(source.parent, folder)
    if name in parse_inputs.MAKERS and name in OURS:  # apart: the memory of this program counts as that of those it starts
        subprocess.run([sys.executable, str(HERE / "parse_inputs.py"), str(folder), name], check=True)
    theirs, ours, their_memory, our_memory, well = [], [], [], [], True
    for _ in range(args.runs):
        text, seconds, memory = read_by_povray(args, source, folder)
        theirs.append(seconds)
        their_memory.append(memory)
        said, seconds, memory = read_by_whittle(args, source, folder)
        ours.append(seconds)
        our_memory.append(memory)
        if printed(text) != printed(said):
            print(f"{name}: the scene prints {printed(said)}, with POV-Ray {printed(text)}")
            well = False
    shutil.rmtree(folder)
    their_seconds, our_seconds = statistics.median(theirs), max(statistics.median(ours), 1e-6)
    well = well and min(our_memory) <= min(their_memory)
    print(f"{name:18} {their_seconds:10.3f} {our_seconds:10.3f} {their_seconds / our_seconds:7.1f}"
          f" {min(their_memory) / 1024:11.1f} {min(our_memory) / 1024:11.1f}", flush=True)
    return their_seconds / our_seconds, well


def read_distribution(args):
    """Whether no scene of POV-Ray's own is read more slowly than by it."""
    scenes = sorted(pathlib.Path(args.examples).glob("**/*.pov"))
    if args.scenes:
        scenes = [source for source in scenes if any(name in str(source.relative_to(args.examples)) for name in args.scenes)]
    cache = pathlib.Path(args.cache) if args.cache else None
    known = json.loads(cache.read_text()) if cache and cache.exists() else {}
    compared = slower = failed = 0
    for source in scenes:
        with tempfile.TemporaryDirectory() as scratch:
            folder = pathlib.Path(scratch, "scene")
            shutil.copytree(source.parent, folder)
            name = str(source.relative_to(args.examples))
            theirs = known.get(name) or [read_by_povray(args, source, folder, True)[1] for _ in range(2)]
            if cache and name not in known:
                known[name] = theirs
                cache.write_text(json.dumps(known, indent=0))
            if None in theirs:
                failed += 1
                continue
            if min(theirs) < LEAST_SECONDS:
                continue
            compared += 1
            ours = min(read_by_whittle(args, source, folder, True)[1] for _ in range(2))
            slower += ours > min(theirs)
            if 2.0 * ours > min(theirs):
                print(f"{name}: POV-Ray {min(theirs):.3f} s, Whittle {ours:.3f} s", flush=True)
    print(f"{len(scenes)} scenes, POV-Ray fails on {failed}, needs {LEAST_SECONDS} s or more for {compared}; slower than it: {slower}")
    return 1 if slower else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("scenes", nargs="*")
    parser.add_argument("--bar", type=float, default=10)
    parser.add_argument("--mean", type=float, default=30)
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--whittle", default=str(HERE.parent / "build/release/whittle"))
    parser.add_argument("--povray", default="povray")
    parser.add_argument("--examples", default="/usr/share/doc/povray/examples")
    parser.add_argument("--distribution", action="store_true")
    parser.add_argument("--cache")
    args = parser.parse_args()
    if args.distribution:
        return read_distribution(args)
    print(f"{'scene':18} {'POV-Ray s':>10} {'Whittle s':>10} {'ratio':>7} {'POV-Ray MB':>11} {'Whittle MB':>11}")
    with tempfile.TemporaryDirectory() as scratch:
        rows = [compare(args, name, HERE / f"parse/{name}.pov" if name in OURS else pathlib.Path(args.examples, EXAMPLES[name]), scratch)
                for name in args.scenes or OURS + list(EXAMPLES)]
    ratios = [ratio for ratio, _ in rows]
    mean = math.exp(sum(map(math.log, ratios)) / len(ratios))
    print(f"geometric mean {mean:.1f} (wanted {args.mean:g}), least {min(ratios):.1f} (wanted {args.bar:g})")
    return 0 if mean >= args.mean and min(ratios) >= args.bar and all(well for _, well in rows) else 1


if __name__ == "__main__":
    sys.exit(main())
