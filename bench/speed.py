"""Trace times of scenes with POV-Ray and with Whittle in turn: what the benchmarks share."""
import argparse
import csv
import os
import pathlib
import re
import signal
import statistics
import subprocess
import sys
import tempfile
import threading
import time
import typing

HERE = pathlib.Path(__file__).resolve().parent
POVRAY_TRACE = re.compile(r"Trace Time:.*?\(([0-9.]+) seconds\)")
WHITTLE_TRACE = re.compile(r"\btrace ([0-9.]+) s\b")


class Failure(Exception):
    """A program that did not render, with the end of what it said."""


class Run(typing.NamedTuple):
    """What a program said and took."""
    said: str
    wall: float  # seconds from start to end
    cpu: float  # processor seconds, user and system, of all threads
    memory: int  # the most bytes that the process had


def execute(command, folder, limit=None):
    """Runs a program in a folder to its end, at most `limit` seconds."""
    with tempfile.TemporaryFile("w+", errors="replace") as said:
        began = time.monotonic()
        process = subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=said, stderr=subprocess.STDOUT)
        guard = threading.Timer(limit or threading.TIMEOUT_MAX, os.kill, (process.pid, signal.SIGKILL))
        guard.daemon = True
        guard.start()
        try:
            _, status, used = os.wait4(process.pid, 0)
        finally:
            guard.cancel()
        wall = time.monotonic() - began
        process.returncode = os.waitstatus_to_exitcode(status)
        said.seek(0)
        text = said.read()
    if process.returncode != 0:
        why = f"ended after {limit:g} s" if limit and wall >= limit else f"exit status {process.returncode}"
        raise Failure(f"{' '.join(map(str, command))}: {why}\n{text[-600:]}")
    return Run(text, wall, used.ru_utime + used.ru_stime, used.ru_maxrss * 1024)


def rendered(program, scene, size, threads, picture):
    """Renders once; what the program says, and the most memory that it had, in bytes."""
    command = [program, f"+I{scene.name}", f"+O{picture}", f"+W{size[0]}", f"+H{size[1]}", "-A", "-D", "-P",
               f"+WT{threads}", "+FN8"]
    run = execute(command, scene.parent)
    return run.said, run.memory


def seconds(said, pattern):
    """What of the time that a program tells the pattern finds."""
    found = pattern.search(said)
    if not found:
        raise Failure(f"no time in what was said:\n{said[-600:]}")
    return float(found.group(1))


def trace_seconds(program, pattern, scene, size, threads, picture):
    """Renders once and returns the seconds of tracing that the program itself reports."""
    return seconds(rendered(program, scene, size, threads, picture)[0], pattern)


def agreement(whittle, reference, actual):
    """Share of agreeing pixels as `whittle compare` measures it."""
    done = subprocess.run([whittle, "compare", reference, actual], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    found = re.search(r"agreeing\s+([0-9.]+) %", done.stdout)
    if not found:
        raise Failure(done.stdout)
    return float(found.group(1)) / 100, done.returncode == 0


def measure(options, scene, size, threads, folder):
    """One row of the table."""
    name = scene.stem
    theirs, ours = f"{folder}/{name}.povray.png", f"{folder}/{name}.whittle.png"
    povray_seconds, whittle_seconds = [], []
    for _ in range(options.runs):  # in turn, so that both see the same machine
        povray_seconds.append(trace_seconds(options.povray, POVRAY_TRACE, scene, size, threads, theirs))
        whittle_seconds.append(trace_seconds(options.whittle, WHITTLE_TRACE, scene, size, threads, ours))
    share, right = agreement(options.whittle, theirs, ours)
    povray, whittle = statistics.median(povray_seconds), statistics.median(whittle_seconds)
    ratio = povray / whittle if whittle > 0 else float("inf")
    return dict(scene=name, threads=threads, povray_s=round(povray, 3), whittle_s=round(whittle, 3),
                ratio=round(ratio, 2), agree=round(share, 4), ok=right and ratio >= options.bar)


def programs_from_here(options):
    """Makes paths of programs absolute: they are meant from here, not from the scene's folder."""
    for program in ("whittle", "povray"):
        if "/" in getattr(options, program):
            setattr(options, program, str(pathlib.Path(getattr(options, program)).resolve()))


def run(description, scenes, sizes, threads):
    """The command line of a benchmark: `sizes` names the scenes of the folder `scenes`, with (width, height). The exit status."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", metavar="SCENE")
    parser.add_argument("--bar", type=float, default=4.0)
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--threads", type=int, nargs="+", default=threads)
    parser.add_argument("--csv")
    parser.add_argument("--whittle", default=str(HERE.parent / "build/release/whittle"))
    parser.add_argument("--povray", default="povray")
    options = parser.parse_args()
    programs_from_here(options)
    unknown = set(options.scenes) - set(sizes)
    if unknown:
        parser.error(f"no such scene: {', '.join(sorted(unknown))}; there are {', '.join(sizes)}")

    rows = []
    print(f"{'scene':<16} {'threads':>7} {'POV-Ray s':>10} {'whittle s':>10} {'ratio':>7} {'agree':>7}")
    with tempfile.TemporaryDirectory() as folder:
        for name in options.scenes or sizes:
            for count in options.threads:
                try:
                    row = measure(options, scenes / f"{name}.pov", sizes[name], count, folder)
                except Failure as failure:
                    print(f"{name}: {failure}", file=sys.stderr)
                    row = dict(scene=name, threads=count, povray_s=0, whittle_s=0, ratio=0, agree=0, ok=False)
                rows.append(row)
                print(f"{row['scene']:<16} {row['threads']:>7} {row['povray_s']:>10.3f} {row['whittle_s']:>10.3f} "
                      f"{row['ratio']:>7.2f} {row['agree']:>7.4f}{'' if row['ok'] else '  below the bar or wrong'}", flush=True)
    if options.csv:
        with open(options.csv, "w", newline="") as file:
            writer = csv.DictWriter(file, fieldnames=rows[0].keys())
            writer.writeheader()
            writer.writerows(rows)
    ratios = [row["ratio"] for row in rows if row["ratio"] > 0]
    if ratios:
        print(f"geometric mean {statistics.geometric_mean(ratios):.2f}, least {min(ratios):.2f}, bar {options.bar:g}")
    return 0 if all(row["ok"] for row in rows) else 1
