#!/usr/bin/env python3
"""Whether --error is kept: levels of 255 that pictures are off by, beside those that were asked for.

usage: bench/error_kept.py [SCENE...] [--integrator path] [--shares .5 .25 .125 | --asked 8 4 2] [--seeds 3] [--truth 2048] [--keep FOLDER]

Each scene is asked for half, a quarter and an eighth of what eight samples a pixel are off by (so that every run has to decide), with several
seeds. The truth is the mean of two pictures of --truth samples a pixel with seeds of their own; half of what those are apart is what it is off by,
and as it is independent of what it judges, that is taken from what is measured (squares add). Exit status 1 if fewer than --kept per cent of the runs
are below what they were asked, or if half of them are below a third of it. --keep holds the truths for the next time.
"""
import argparse
import array
import concurrent.futures
import math
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent
SCENES = ["bench/scenes/cornell", "scenes/photons/glass_ball", "scenes/photons/ring_mirror", "scenes/photons/prism", "scenes/light/area_plain",
          "scenes/glass/ior", "scenes/glass/fade", "scenes/radiosity/garden", "scenes/radiosity/closed_room", "scenes/finish/reflection",
          "scenes/finish/ambient_emission", "scenes/light/area_circular", "bench/scenes/phases/glasses", "bench/scenes/phases/pawn",
          "bench/scenes/stiff/grazing_glass", "scenes/first_light"]


def read(path):
    """Levels of a PPM of 16 bits, not rounded to whole ones."""
    data = path.read_bytes()
    head = re.match(rb"P6\s(?:#[^\n]*\n|\s)*(\d+)\s+(\d+)\s+65535\s", data)
    values = array.array("H", data[head.end():])
    values.byteswap()
    return [v * 255.0 / 65535.0 for v in values]


def apart(a, b):
    return math.sqrt(sum((x - y) ** 2 for x, y in zip(a, b)) / len(a))


class Renders:
    def __init__(self, options, scene, folder):
        self.options, self.scene, self.folder = options, scene, folder

    def picture(self, name, *words):
        path = self.folder / f"{name}.ppm"
        told = None
        if not (path.exists() and name.startswith("truth")):
            command = [self.options.whittle.resolve(), f"+I{self.scene}", f"+O{path}", "+FP16", f"+W{self.options.width}", f"+H{self.options.height}", "-D",
                       f"+WT{self.options.threads}", f"--integrator={self.options.integrator}", *words]
            run = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
            if run.returncode != 0:
                sys.exit(f"error_kept.py: {' '.join(map(str, command))}: {run.stderr[-2000:]}")
            told = re.search(r"error\s+([0-9.]+) of 255", run.stderr), re.search(r"([0-9.]+) samples", run.stderr), run.stderr
        return read(path), told


def measured(options, path, folder):
    """Rows of a scene: seed, asked, achieved, told, paths a pixel; and what the truth is off by."""
    renders = Renders(options, path, folder)
    halves = [renders.picture(f"truth_{options.integrator}_{options.width}_{options.truth}_{seed}", f"--samples={options.truth}",
                              f"--seed={seed}")[0] for seed in (1001, 1002)]
    truth = [(a + b) / 2 for a, b in zip(*halves)]
    off = apart(*halves) / 2

    def error(picture):
        return math.sqrt(max(apart(picture, truth) ** 2 - off ** 2, 0.0))

    rows = []
    eight = error(renders.picture("eight", "--samples=8", "--seed=1000")[0])
    for asked in options.asked or [float(f"{eight * share:.2g}") for share in options.shares]:
        if not asked > 2 * off:
            continue  # too little to be told from what the truth lacks
        for seed in range(1, options.seeds + 1):
            picture, told = renders.picture("asked", f"--error={asked:g}", f"--seed={seed}")
            rows.append((seed, asked, error(picture), float(told[0][1]) if told[0] else math.nan, samples_of(told[2], options)))
    return eight, off, rows


def samples_of(said, options):
    found = re.search(r"camera (\d+)", said)
    return int(found[1]) / (options.width * options.height) if found else math.nan


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", metavar="SCENE", type=pathlib.Path)
    parser.add_argument("--integrator", choices=["path", "whitted"], default="path")
    parser.add_argument("--shares", nargs="+", type=float, default=[0.5, 0.25, 0.125])
    parser.add_argument("--asked", nargs="+", type=float)
    parser.add_argument("--seeds", type=int, default=3)
    parser.add_argument("--truth", type=int, default=2048)
    parser.add_argument("--width", type=int, default=40)
    parser.add_argument("--height", type=int, default=30)
    parser.add_argument("--kept", type=float, default=90)
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2, help="scenes at a time")
    parser.add_argument("--keep", type=pathlib.Path)
    parser.add_argument("--whittle", type=pathlib.Path, default=ROOT / "build/release/whittle")
    options = parser.parse_args()
    scenes = [path.resolve() for path in options.scenes] or [ROOT / f"{name}.pov" for name in SCENES]
    all_rows = []
    print(f"{'scene':<20} {'8 paths':>8} {'truth':>6} {'asked':>7}   off by (told, samples a pixel), seed after seed")
    with tempfile.TemporaryDirectory() as name, concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        def one(path):
            folder = (options.keep or pathlib.Path(name)) / path.stem
            folder.mkdir(parents=True, exist_ok=True)
            return measured(options, path, folder)
        for path, (eight, off, rows) in zip(scenes, pool.map(one, scenes)):
            all_rows += rows
            for asked in dict.fromkeys(row[1] for row in rows):
                cells = "  ".join(f"{row[2]:.3g}{'' if row[2] <= asked else '!'} ({row[3]:.3g}, {row[4]:.0f})" for row in rows if row[1] == asked)
                print(f"{path.stem:<20} {eight:>8.2f} {off:>6.2f} {asked:>7.3g}   {cells}", flush=True)
            if not rows:
                print(f"{path.stem:<20} {eight:>8.2f} {off:>6.2f}   the truth is not known well enough")
    kept = 100 * sum(row[2] <= row[1] for row in all_rows) / len(all_rows)
    middle = statistics.median(row[2] / row[1] for row in all_rows)
    worst = max(row[2] / row[1] for row in all_rows)
    print(f"{len(all_rows)} runs: {kept:.1f} % kept; off by {middle:.2f} of what was asked in the middle, {worst:.2f} at most")
    return 0 if kept >= options.kept and middle >= 1 / 3 else 1


if __name__ == "__main__":
    sys.exit(main())
