#!/usr/bin/env python3
"""Whether --time is kept: wall seconds of whole runs that were given one second and five.

usage: bench/time_kept.py [SCENE...] [--seconds 1 5] [--bar 10] [--whittle PROGRAM]

320x240, both integrators, all threads. Exit status 1 if a run took more than --bar per cent more or less than it was given. Without SCENE:
first_light, nine of scenes/phases and a room with radiosity.
"""
import argparse
import pathlib
import re
import sys
import tempfile

import speed

HERE = speed.HERE
PHASES = ["antialias_method_1", "area_17_jitter", "area_50", "flange", "focal_blur", "glasses", "julias", "layered_mirrors", "pawn"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", metavar="SCENE", type=pathlib.Path)
    parser.add_argument("--seconds", nargs="+", type=float, default=[1, 5])
    parser.add_argument("--bar", type=float, default=10)
    parser.add_argument("--whittle", type=pathlib.Path, default=HERE.parent / "build/release/whittle")
    options = parser.parse_args()
    scenes = options.scenes or [HERE.parent / "scenes/first_light.pov", *(HERE / f"scenes/phases/{name}.pov" for name in PHASES),
                                HERE / "scenes/cornell.pov"]
    farthest = 0.0
    print(f"{'scene':<22} {'integrator':<10} {'given s':>8} {'taken s':>8} {'error told, of 255':>19}")
    with tempfile.TemporaryDirectory() as folder:
        for scene in scenes:
            for integrator in ("whitted", "path"):
                for given in options.seconds:
                    command = [options.whittle.resolve(), f"+I{scene.resolve()}", f"+O{folder}/picture.png", "+W320", "+H240", "-D",
                               f"--time={given:g}s", f"--integrator={integrator}"]
                    run = speed.execute(command, HERE.parent)
                    told = re.search(r"error\s+([0-9.]+) of 255", run.said)
                    farthest = max(farthest, abs(run.wall / given - 1) * 100)
                    print(f"{scene.stem:<22} {integrator:<10} {given:>8g} {run.wall:>8.2f} {told[1] if told else 'not known':>19}", flush=True)
    print(f"farthest off: {farthest:.1f} %")
    return 0 if farthest <= options.bar else 1


if __name__ == "__main__":
    sys.exit(main())
