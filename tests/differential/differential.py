#!/usr/bin/python3
"""Random scenes, the same for both programs: Whittle against POV-Ray.

usage: differential.py run [CLASS...] [--seeds A-B]     both programs render scenes of seeds A to B, 80x60; prints what differs
       differential.py print CLASS SEED                 the scene's text
       differential.py reduce SCENE.pov                 the shortest text found for which both still differ
       differential.py record [CLASS...]                POV-Ray's pictures and texts of the seeds that ./check asks, 40x30
       differential.py check [CLASS...]                 Whittle against what was recorded; needs no POV-Ray

A picture agrees when at least 99 % of its pixels are within 3/255 in every channel; what a scene prints has to be the same
text. A picture that differs agrees too where enough of its pixels do once POV-Ray draws each of them alone (alone.py). `run`
leaves the scenes that differ, with both pictures, in --folder. The exit status is 1 when fewer than --share of the scenes
agree. See README.md.
"""
import argparse
import collections
import concurrent.futures
import os
import pathlib
import sys
import tempfile

import alone
import noisy
import programs
import recorded
import reduce
import scenes

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent


def compare_one(options, folder, kind, seed):
    """Renders one scene with both; keeps its files only if they differ. Returns (kind, seed, state, detail)."""
    name = f"{kind}_{seed}"
    (folder / f"{name}.pov").write_text(scenes.text(kind, seed))
    if kind in scenes.NOISY:
        state, detail = noisy.verdict(options, folder, name)
        return kind, seed, state, detail
    whittle, povray = (options.whittle + " --povray=3.8", options.povray38) if kind in scenes.NEWER else (options.whittle, options.povray)
    ours = programs.render(whittle, folder, name, (80, 60), "whittle")
    theirs = programs.render(povray, folder, name, (80, 60), "povray")
    state, detail = programs.verdict(ours, theirs)
    if state == "differ" and programs.same_text(ours, theirs):
        state, detail = alone.verdict(ours, povray, folder, name, (80, 60), theirs)
    if state == "agree" and not options.keep:
        for left in folder.glob(f"{name}.*"):
            left.unlink()
    return kind, seed, state, detail


def run(options):
    folder = options.folder
    folder.mkdir(parents=True, exist_ok=True)
    scenes.write_companions(folder)
    first, _, last = options.seeds.partition("-")
    seeds = range(int(first), int(last or first) + 1)
    jobs = [(kind, seed) for kind in options.classes or scenes.CLASSES for seed in seeds]
    counts = collections.defaultdict(collections.Counter)
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for kind, seed, state, detail in pool.map(lambda job: compare_one(options, folder, *job), jobs):
            counts[kind][state] += 1
            if state != "agree":
                print(f"{kind} {seed}: {state}: {detail}", flush=True)
    enough = True
    for kind, states in counts.items():
        asked = sum(states.values()) - states["refused"]
        agreeing = states["agree"] + states["alone"]
        enough = enough and agreeing >= options.share * asked
        print(f"{kind}: {agreeing} of {asked} agree"
              + (f", {states['alone']} of them where POV-Ray draws a pixel alone" if states["alone"] else "")
              + (f"; {states['refused']} refused by both" if states["refused"] else ""))
    return 0 if enough else 1


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--whittle", default=str(ROOT / "build/release/whittle"), help="may carry options, as in \"whittle --isa=v3\"")
    parser.add_argument("--povray", default="povray")
    parser.add_argument("--povray38", help="command of POV-Ray 3.8, which the classes for it are compared with")
    commands = parser.add_subparsers(dest="command", required=True)
    each = commands.add_parser("run")
    each.add_argument("classes", nargs="*", choices=[[], *scenes.CLASSES, *scenes.NEWER, *scenes.NOISY])
    each.add_argument("--seeds", default="0-24")
    each.add_argument("--folder", type=pathlib.Path, default=pathlib.Path(tempfile.gettempdir()) / "differential")
    each.add_argument("--jobs", type=int, default=8 * (os.cpu_count() or 1))  # POV-Ray's start is half a second of waiting
    each.add_argument("--share", type=float, default=0.995)
    each.add_argument("--keep", action="store_true", help="keep the files of all scenes")
    shown = commands.add_parser("print")
    shown.add_argument("kind", choices=[*scenes.CLASSES, *scenes.NEWER, *scenes.NOISY])
    shown.add_argument("seed", type=int)
    shorter = commands.add_parser("reduce")
    shorter.add_argument("scene", type=pathlib.Path)
    shorter.add_argument("--jobs", type=int, default=4 * (os.cpu_count() or 1))
    made = commands.add_parser("record")
    made.add_argument("classes", nargs="*", choices=[[], *scenes.CLASSES])
    again = commands.add_parser("check")
    again.add_argument("classes", nargs="*", choices=[[], *scenes.CLASSES])
    options = parser.parse_args()
    if options.command == "run" and any(kind in scenes.NEWER for kind in options.classes) and not options.povray38:
        sys.exit("this class needs --povray38")
    if options.command == "run":
        return run(options)
    if options.command == "print":
        print(scenes.text(options.kind, options.seed), end="")
        return 0
    if options.command == "reduce":
        return reduce.reduce(options)
    return recorded.record(options) if options.command == "record" else recorded.check(options)


if __name__ == "__main__":
    sys.exit(main())
