#!/usr/bin/env python3
"""What a sample costs with antialiasing, beside a sample of the plain picture.

usage: bench/samples.py [SCENE...] [--runs 5] [--bar 1.3] [--whittle PROGRAM] [--povray PROGRAM]

Renders each scene plain, with +A0.1 +AM1 and with +A0.1 +AM2 in turn, one thread, 320x240, and takes the least trace time of each over the
plain picture's: by samples (camera rays), by rays of any kind, and POV-Ray's own by samples (one run). Those of antialiasing lie
where colours change, at outlines and in half-shadows, where each may see more than one of the plain picture: POV-Ray's ratio tells how much
of ours is that. Without SCENE: the scenes of scenes/phases. Exit status 1 if the geometric mean of a method is above --bar by samples.
"""
import argparse
import json
import math
import pathlib
import re
import sys
import tempfile

import speed

WAYS = {"plain": ["-A"], "method 1": ["+A0.1", "+AM1"], "method 2": ["+A0.1", "+AM2"]}
BY = ("sample", "ray", "POV-Ray's")


def render(program, scene, folder, more):
    command = [program, f"+I{scene.name}", f"+O{folder / 'picture.png'}", "+W320", "+H240", "+WT1", "-D", *more]
    return speed.execute(command, scene.parent).said


def whittle_seconds(program, scene, folder, switches):
    """Of a camera ray, and of a ray of any kind."""
    told = folder / "told.json"
    render(program, scene, folder, ["--quiet", "--json", told, *switches])
    frame = json.loads(told.read_text())["frames"][0]
    counts, took = frame["counts"], frame["phases"]["trace_seconds"]
    rays = sum(counts[f"{kind}_rays"] for kind in ("camera", "shadow", "reflected", "refracted"))
    return took / counts["camera_rays"], took / rays


def povray_seconds(program, scene, folder, switches):
    """Of a sample: a pixel, or one more in it."""
    said = render(program, scene, folder, ["-P", *switches])
    samples = sum(int(re.search(rf"{what}:\s+(\d+)", said)[1]) for what in ("Pixels", "Samples"))
    return float(speed.POVRAY_TRACE.search(said)[1]) / samples


def measured(options, scene, folder):
    """Least seconds by way and by what."""
    least = {(way, what): math.inf for way in WAYS for what in BY}
    for run in range(options.runs):
        for way, switches in WAYS.items():
            took = [*whittle_seconds(options.whittle.resolve(), scene, folder, switches)]
            if run == 0:
                took.append(povray_seconds(options.povray, scene, folder, switches))
            for what, each in zip(BY, took):
                least[way, what] = min(least[way, what], each)
    return least


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", metavar="SCENE", type=pathlib.Path)
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--bar", type=float, default=1.3)
    parser.add_argument("--whittle", type=pathlib.Path, default=speed.HERE.parent / "build/release/whittle")
    parser.add_argument("--povray", default="povray")
    options = parser.parse_args()
    scenes = options.scenes or sorted((speed.HERE / "scenes/phases").glob("*.pov"))
    asked = [(way, what) for way in ("method 1", "method 2") for what in BY]
    logs = {key: [] for key in asked}
    print(f"{'scene':<20} {'plain ns':>8}" + "".join(f" {way[-1] + ' ' + what:>11}" for way, what in asked))
    with tempfile.TemporaryDirectory() as folder:
        for scene in scenes:
            least = measured(options, scene.resolve(), pathlib.Path(folder))
            ratios = {(way, what): least[way, what] / least["plain", what] for way, what in asked}
            for key, ratio in ratios.items():
                logs[key].append(math.log(ratio))
            nanoseconds = least["plain", "sample"] * 1e9
            print(f"{scene.stem:<20} {nanoseconds:>8.0f}" + "".join(f" {ratio:>11.2f}" for ratio in ratios.values()), flush=True)
    means = {key: math.exp(sum(each) / len(each)) for key, each in logs.items()}
    print(f"{'geometric mean':<29}" + "".join(f" {mean:>11.2f}" for mean in means.values()))
    return 0 if max(means[way, "sample"] for way in ("method 1", "method 2")) <= options.bar else 1


if __name__ == "__main__":
    sys.exit(main())
