#!/usr/bin/env python3
"""What a sample costs with antialiasing, beside a sample of the plain picture.

usage: bench/samples.py [SCENE...] [--runs 5] [--bar 1.3] [--whittle PROGRAM] [--povray PROGRAM]

Renders each scene plain, with +A0.1 +AM1 and with +A0.1 +AM2 in turn, one thread, 320x240, and takes the least trace time of each over the
plain picture's: by samples, by camera rays, by rays of any kind, by samples where all pixels have more of them (+A0.0), and POV-Ray's own by
samples of +A0.1 (one run). Samples are counted as POV-Ray counts its own, one a pixel and those that are added: what blocks trace beside
that and what two pixels have in common changes the time alone, and the camera rays. Samples of +A0.1 lie where colours change, at outlines
and in half-shadows, where each may cost more than one of the plain picture; those of +A0.0 lie where the plain picture's do, so that their
ratio is what antialiasing itself costs.
Without SCENE: the scenes of scenes/phases. Exit status 1 if the geometric mean of a method is above --bar by samples of +A0.1.
"""
import argparse
import json
import math
import pathlib
import re
import sys
import tempfile

import speed

METHODS = {"method 1": ["+AM1"], "method 2": ["+AM2"]}
WIDTH, HEIGHT = 320, 240
BY = ("sample", "camera", "ray", "all pixels", "POV-Ray's")


def render(program, scene, folder, more):
    size = [f"+W{WIDTH}", f"+H{HEIGHT}"]
    command = [program, f"+I{scene.name}", f"+O{folder / 'picture.png'}", *size, "+WT1", "-D", *more]
    return speed.execute(command, scene.parent).said


def whittle_seconds(program, scene, folder, switches):
    """Of a sample, of a camera ray, and of a ray of any kind."""
    told = folder / "told.json"
    render(program, scene, folder, ["--quiet", "--json", told, *switches])
    frame = json.loads(told.read_text())["frames"][0]
    counts, took = frame["counts"], frame["phases"]["trace_seconds"]
    rays = sum(counts[f"{kind}_rays"] for kind in ("camera", "shadow", "reflected", "refracted"))
    samples = WIDTH * HEIGHT + counts["supersamples"]
    return {"sample": took / samples, "camera": took / counts["camera_rays"], "ray": took / rays}


def povray_seconds(program, scene, folder, switches):
    """Of a sample: a pixel, or one more in it."""
    said = render(program, scene, folder, ["-P", *switches])
    samples = sum(int(re.search(rf"{what}:\s+(\d+)", said)[1]) for what in ("Pixels", "Samples"))
    return float(speed.POVRAY_TRACE.search(said)[1]) / samples


def measured(options, scene, folder):
    """Least seconds of the plain picture by what, and of methods by (method, what)."""
    least = {}

    def keep(key, took):
        least[key] = min(least.get(key, math.inf), took)

    for run in range(options.runs):
        for way, switches in {"plain": ["-A"], **{way: ["+A0.1", *more] for way, more in METHODS.items()}}.items():
            for what, took in whittle_seconds(options.whittle.resolve(), scene, folder, switches).items():
                keep((way, what), took)
            if run == 0:
                keep((way, "POV-Ray's"), povray_seconds(options.povray, scene, folder, switches))
        for way, more in METHODS.items():
            seconds = whittle_seconds(options.whittle.resolve(), scene, folder, ["+A0.0", "+R2", *more])
            keep((way, "all pixels"), seconds["sample"])
    least["plain", "all pixels"] = least["plain", "sample"]
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
    asked = [(way, what) for way in METHODS for what in BY]
    logs = {key: [] for key in asked}
    print(f"{'scene':<20} {'plain ns':>8}" + "".join(f" {way[-1] + ' ' + what:>12}" for way, what in asked))
    with tempfile.TemporaryDirectory() as folder:
        for scene in scenes:
            least = measured(options, scene.resolve(), pathlib.Path(folder))
            ratios = {(way, what): least[way, what] / least["plain", what] for way, what in asked}
            for key, ratio in ratios.items():
                logs[key].append(math.log(ratio))
            nanoseconds = least["plain", "sample"] * 1e9
            print(f"{scene.stem:<20} {nanoseconds:>8.0f}" + "".join(f" {ratio:>12.2f}" for ratio in ratios.values()), flush=True)
    means = {key: math.exp(sum(each) / len(each)) for key, each in logs.items()}
    print(f"{'geometric mean':<29}" + "".join(f" {mean:>12.2f}" for mean in means.values()))
    return 0 if max(means[way, "sample"] for way in METHODS) <= options.bar else 1


if __name__ == "__main__":
    sys.exit(main())
