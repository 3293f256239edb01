#!/usr/bin/python3
"""Signals at random moments of one large render: how soon it ends, and whether +C goes on to the same bytes.

usage: cancel_large.py WHITTLE [--size 4000x3000] [--signals 20] [--seed 17] [--at 0.05-1] [OPTION...]

Renders a scene with +AM2 +R9 whole, then over and over: SIGINT and SIGTERM by turns at a random part of that time, then
+C. The scene is light, so that the size itself is what costs: what is done has to be kept, and a picture of it written.
Options for the program (--isa=v3) may follow. Prints a line per signal; the exit status is 1 if one took longer than
half a second, by the clock and in work of its threads together (on a busy machine the end waits for its turn), if a
continued picture has other bytes, or if fewer than half of the signals came in time.
"""
import argparse
import os
import pathlib
import random
import signal
import statistics
import subprocess
import sys
import tempfile
import time

SCENE = """#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 0, -4> look_at 0 }
background { rgb <0.2, 0.3, 0.4> }
light_source { <-5, 5, -5>, 1 }
plane { y, -1 pigment { rgb 0.8 } }
sphere { 0, 1 pigment { rgb <1, 0.5, 0.25> } }
"""
MOST_SECONDS = 0.5  # README: a cancelled run ends in less


def cpu_seconds(process):
    """Of all threads so far, while it runs."""
    fields = pathlib.Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def stop(program, sent):
    """Returns (status, seconds from the signal to the end, seconds of work in that time)."""
    used, since = cpu_seconds(program.pid), time.monotonic()
    program.send_signal(sent)
    _, status, usage = os.wait4(program.pid, 0)
    program.returncode = os.waitstatus_to_exitcode(status)
    return program.returncode, time.monotonic() - since, usage.ru_utime + usage.ru_stime - used


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("whittle", type=os.path.abspath)
    parser.add_argument("--size", default="4000x3000")
    parser.add_argument("--signals", type=int, default=20)
    parser.add_argument("--seed", type=int, default=17)
    parser.add_argument("--at", default="0.05-1", help="range of the moments, parts of the whole render's time")
    options, more = parser.parse_known_args()
    width, height = options.size.split("x")
    first, last = map(float, options.at.split("-"))
    with tempfile.TemporaryDirectory() as name:
        words = [f"+W{width}", f"+H{height}", "+A0.2", "+AM2", "+R9", "-D", *more]
        return run(options, pathlib.Path(name), words, first, last)


def run(options, folder, words, first, last):
    (folder / "s.pov").write_text(SCENE)
    command = [options.whittle, "s.pov", *words]
    quiet = {"cwd": folder, "stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    begun = time.monotonic()
    subprocess.run([*command, "+Owhole.png"], check=True, **quiet)
    whole_seconds = time.monotonic() - begun
    whole = (folder / "whole.png").read_bytes()
    print(f"whole: {whole_seconds:.2f} s, {len(whole)} bytes", flush=True)
    pick, took, worked, other, late = random.Random(options.seed), [], [], 0, 0
    for i in range(options.signals):
        share = pick.uniform(first, last)
        sent = (signal.SIGINT, signal.SIGTERM)[i % 2]
        program = subprocess.Popen(command, **quiet)
        status, seconds, work = None, 0.0, 0.0
        try:
            status = program.wait(share * whole_seconds)
        except subprocess.TimeoutExpired:
            status, seconds, work = stop(program, sent)
            late += seconds > MOST_SECONDS and work > MOST_SECONDS
        state = folder / "s.whittle-state"
        kept = state.stat().st_size if state.exists() else 0
        again = subprocess.run([*command, "+C"], check=False, **quiet).returncode
        same = again == 0 and (folder / "s.png").read_bytes() == whole
        (folder / "s.png").unlink(missing_ok=True)
        if status == 2:
            took.append(seconds)
            worked.append(work)
        other += not same
        print(f"{i:3} {sent.name} at {share:.2f}: status {status} after {seconds:.3f} s, {work:.2f} s of work, "
              f"state of {kept} bytes, +C: {'same bytes' if same else f'OTHER, status {again}'}", flush=True)
    if took:
        print(f"{len(took)} of {options.signals} in time; to the end: median {statistics.median(took):.3f} s, "
              f"most {max(took):.3f} s; work: median {statistics.median(worked):.2f} s, "
              f"most {max(worked):.2f} s; other bytes: {other}")
    return int(other > 0 or late > 0 or 2 * len(took) < options.signals)


if __name__ == "__main__":
    sys.exit(main())
