#!/usr/bin/env python3
"""What a sample costs with antialiasing, beside a sample of the plain picture.

usage: bench/samples.py [SCENE...] [--runs 5] [--bar 1.3] [--whittle PROGRAM]

Renders each scene plain, with +A0.1 +AM1 and with +A0.1 +AM2 in turn, one thread, 320x240, and takes the least trace time of each. A sample is
a camera ray. Those of antialiasing lie where colours change, at outlines and in half-shadows, where each sends more rays on than a plain one that
may see the sky: time by all rays tells what is due to the order of work alone. Without SCENE: the scenes of scenes/phases.
Exit status 1 if the geometric mean of a method is above --bar times the plain picture's by samples.
"""
import argparse
import json
import math
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
WAYS = {"plain": ["-A"], "method 1": ["+A0.1", "+AM1"], "method 2": ["+A0.1", "+AM2"]}
BY = ("a sample", "a ray")


def nanoseconds(program, scene, switches, folder):
    """Of a camera ray, and of a ray of any kind."""
    told = folder / "told.json"
    command = [program, f"+I{scene}", f"+O{folder / 'picture.png'}", "+W320", "+H240", "+WT1", "-D", "--quiet", "--json", told, *switches]
    subprocess.run(command, cwd=scene.parent, check=True, capture_output=True)
    frame = json.loads(told.read_text())["frames"][0]
    counts, seconds = frame["counts"], frame["phases"]["trace_seconds"]
    rays = sum(counts[f"{kind}_rays"] for kind in ("camera", "shadow", "reflected", "refracted"))
    return seconds / counts["camera_rays"] * 1e9, seconds / rays * 1e9


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", metavar="SCENE", type=pathlib.Path)
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--bar", type=float, default=1.3)
    parser.add_argument("--whittle", type=pathlib.Path, default=HERE.parent / "build/release/whittle")
    options = parser.parse_args()
    scenes = options.scenes or sorted((HERE / "scenes/phases").glob("*.pov"))
    logs = {(way, what): [] for way in WAYS for what in BY}
    heads = [f"{way} {what}" for way in ("method 1", "method 2") for what in BY]
    print(f"{'scene':<24} {'plain ns':>9}" + "".join(f" {head:>16}" for head in heads))
    with tempfile.TemporaryDirectory() as name:
        for scene in scenes:
            least = dict.fromkeys(logs, math.inf)
            for _ in range(options.runs):
                for way, switches in WAYS.items():
                    took = nanoseconds(options.whittle.resolve(), scene.resolve(), switches, pathlib.Path(name))
                    for what, each in zip(BY, took):
                        least[way, what] = min(least[way, what], each)
            row = []
            for (way, what), took in least.items():
                logs[way, what].append(math.log(took / least["plain", what]))
                if way != "plain":
                    row.append(f" {took / least['plain', what]:>16.2f}")
            print(f"{scene.stem:<24} {least['plain', 'a sample']:>9.0f}" + "".join(row), flush=True)
    means = {key: math.exp(sum(each) / len(each)) for key, each in logs.items() if key[0] != "plain"}
    print(f"{'geometric mean':<34}" + "".join(f" {mean:>16.2f}" for mean in means.values()))
    return 0 if max(mean for (_, what), mean in means.items() if what == "a sample") <= options.bar else 1


if __name__ == "__main__":
    sys.exit(main())
