#!/usr/bin/python3
"""What a job costs more as tasks than as one run: a still in 64 parts on two slots beside one run with two threads, and 200 frames as tasks
of several frames beside one process.

usage: farm_overhead.py [--program build/release/whittle] [--slots 2] [--runs 1] [JOB...]

Both ways in turn, by the clock and by processor seconds (of all processes, with reading, joining and the shells between). The scenes take
20 s and more on two threads; the frames 0.2 s each. Pictures are compared: the same bytes.
"""
import argparse
import os
import pathlib
import resource
import statistics
import subprocess
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
SCENES, EXAMPLES = ROOT / "bench/scenes/everyday", pathlib.Path("/usr/share/doc/povray/examples")  # of the package povray-examples
# name: scene, options, tasks, frames
JOBS = {"plain": (SCENES / "lens_and_area_light.pov", "+W1920 +H1440 +A0.1", 64, 0),
        "radiosity": (EXAMPLES / "radiosity/cornell.pov", "+W5120 +H3840 +A0.3", 64, 0),
        "frames": (SCENES / "glass_balls.pov", "+W160 +H120 +A0.3", 20, 200)}


def took(words, folder):
    """Seconds by the clock and processor seconds of a command and its children."""
    before, begun = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    subprocess.run(words, cwd=folder, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return time.monotonic() - begun, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def measure(program, job, slots, runs):
    scene, options, tasks, frames = job
    words = [str(scene), *options.split(), *([f"+KFF{frames}"] if frames else [])]
    alone, spread = [], []
    for _ in range(runs):
        with tempfile.TemporaryDirectory() as place:
            folder = pathlib.Path(place)
            (folder / "one").mkdir()
            (folder / "many").mkdir()
            alone.append(took([program, *words, "+Oa.png", f"+WT{slots}", "--quiet"], folder / "one"))
            subprocess.run([program, "farm", *words, "+Oa.png", "--for=shell", f"--tasks={tasks}", "-o", "job"], cwd=folder / "many",
                           check=True, stdout=subprocess.DEVNULL)
            spread.append(took(["bash", "job/submit", *["-"] * slots], folder / "many"))
            pictures = sorted(p.name for p in (folder / "one").glob("*.png"))
            assert len(pictures) == (frames or 1)
            for name in pictures:
                assert (folder / "one" / name).read_bytes() == (folder / "many" / name).read_bytes(), f"{name}: other bytes"
    return [[statistics.median(column) for column in zip(*rows)] for rows in (alone, spread)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=str(ROOT / "build/release/whittle"))
    parser.add_argument("--slots", type=int, default=min(2, os.cpu_count()))
    parser.add_argument("--runs", type=int, default=1)
    parser.add_argument("jobs", nargs="*")
    given = parser.parse_args()
    program = str(pathlib.Path(given.program).resolve())
    print("| job | one run s | tasks s | ratio | processor s | tasks' | ratio |\n|---|---:|---:|---:|---:|---:|---:|")
    for name in given.jobs or JOBS:
        (wall, cpu), (tasks_wall, tasks_cpu) = measure(program, JOBS[name], given.slots, given.runs)
        print(f"| {name} | {wall:.1f} | {tasks_wall:.1f} | {tasks_wall / wall:.2f} | {cpu:.1f} | {tasks_cpu:.1f} | {tasks_cpu / cpu:.2f} |",
              flush=True)


main()
