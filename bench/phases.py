#!/usr/bin/python3
"""Trace and parse times, and those of whole runs, against POV-Ray over whole collections of scenes.

usage: bench/phases.py [SCENE...] [--total] [--effects] [--folder FOLDER]... [--own-only] [--threads 1] [--runs 3]
                       [--clock cpu|wall] [--slow 0.2] [--size 320x240] [--antialias THRESHOLD] [--draw N --seed 1]
                       [--bar 6] [--least 2.5]
                       [--cache FILE] [--json FILE] [--markdown FILE] [--csv FILE]

Measured are the scenes of `scenes/phases`, the eight of `bench/run.py` and those of every FOLDER (that of the package
povray-examples if none is given) which POV-Ray traces for --slow seconds or more. A scene of a folder whose picture is
not POV-Ray's is left out and listed; one of ours that differs is a failure. bench/README.md says what each clock tells.
--total: what counts is the whole run, from its start to its end: reading, bounding or plan, photons, radiosity, tracing and
the file, for --slow too. The table has the peak memory beside it.
SCENE picks scenes by their name in the table; * and ? stand for any letters.
--draw: N scenes of the folders at random, the same for the same --seed, with --size and --antialias as people render them:
bench/README.md has the line. What does not end within --limit seconds in POV-Ray is told and does not count.
--effects: nine scenes of povray-examples whose light scatters and bounces, with one thread and two, medians of five
runs, and a bar of 5 for each of them; what else is given goes before that. The table names two whose pictures differ for a
cause that docs/parity.md tells.
Exit status 1 if the geometric mean of the ratios is below --bar, one of them below --least, a run fails or a scene of
ours is wrong.
"""
import argparse
import csv
import fnmatch
import json
import os
import pathlib
import random
import re
import shutil
import statistics
import sys
import tempfile
import typing

import run as eight
import speed
from phases_table import MATCH, markdown, plain, remark, summary

EXAMPLES = "/usr/share/doc/povray/examples"
# Those of --effects: media, radiosity, photons, light below surfaces, and all together. Some take POV-Ray a minute
# at SIZE.
EFFECTS = {"advanced/mediasky": None, "interior/media/media4": (640, 480), "radiosity/cornell": None,
           "radiosity/patio-radio_37": None, "advanced/blocks/stackerday": (160, 120),
           "advanced/grenadine/grenadine": None, "advanced/optics": None, "subsurface/subsurface": (160, 120),
           "advanced/benchmark/benchmark": (160, 120)}
# Two of them differ for a cause that docs/parity.md tells; what their pictures agree at least.
DIFFER = {"advanced/optics": 0.94, "advanced/benchmark/benchmark": 0.95}
OPTIONS = re.compile(r"^// bench:(.*)$", re.M)  # that line in a scene of ours
COMMON = ["-D", "-P", "+FN8"]
# A stage in POV-Ray's statistics: its name, wall seconds, then processor seconds of all threads.
STAGE = r"{} Time:.*?\(([0-9.]+) seconds\)\s*using \d+ thread\(s\) with ([0-9.]+) CPU-seconds"
PARSE, TRACE = ("Parse", "Bounding"), ("Photon", "Radiosity", "Trace")
NOISE = 0.01  # as docs/parity.md: so much less than POV-Ray with itself still matches


class Times(typing.NamedTuple):
    """Seconds of one run, and the most memory that it had in bytes."""
    parse: float  # all before tracing
    trace: float
    total: float
    memory: int


class NotByPovray(speed.Failure):
    """A scene that POV-Ray refuses, or does not end in time."""


class Scene:
    """A scene, its name in the table and the options that both programs render it with."""

    def __init__(self, name, path, options, own):
        self.name, self.path, self.options, self.own = name, path, options, own


def own_scenes():
    """Those of scenes/phases with the options of their own first lines, and the eight of run.py."""
    for path in sorted((speed.HERE / "scenes/phases").glob("*.pov")):
        found = OPTIONS.search(path.read_text())
        if not found:
            sys.exit(f"{path}: no line '// bench: OPTIONS'")
        yield Scene(path.stem, path, found.group(1).split(), True)
    for name, (width, height) in eight.SIZES.items():
        yield Scene(name, speed.HERE / f"scenes/{name}.pov", [f"+W{width}", f"+H{height}", "-A"], True)


def folder_scenes(folder, options):
    """The scenes of a folder, which have no line of options of their own."""
    antialias = f"+A{options.antialias}" if options.antialias else "-A"
    for path in sorted(folder.rglob("*.pov")):
        name = str(path.relative_to(folder).with_suffix(""))
        width, height = options.effects and EFFECTS.get(name) or options.size
        yield Scene(name, path, [f"+W{width}", f"+H{height}", antialias], False)


def drawn(folders, number, seed):
    """The same scenes of all folders for the same seed, whatever else is asked of them."""
    everything = [(root, scene) for root, scenes in folders for scene in scenes]
    chosen = set(random.Random(seed).sample(range(len(everything)), min(number, len(everything))))
    kept = [pair for place, pair in enumerate(everything) if place in chosen]
    return [(root, [scene for its, scene in kept if its == root]) for root, _ in folders]


def width_and_height(text):
    width, height = text.split("x")
    return int(width), int(height)


class Copies:
    """Copies of folders, one for each program: scenes may write files, and neither program may find the other's."""

    def __init__(self, scratch, who):
        self.scratch, self.who, self.made = scratch, who, {}

    def place(self, scene, root):
        """The path of the scene in the copy of its folder."""
        if root not in self.made:
            copy = pathlib.Path(self.scratch, f"{self.who}{len(self.made)}")
            shutil.copytree(root, copy, symlinks=False)
            self.made[root] = copy
        return self.made[root] / scene.path.relative_to(root)


def povray_seconds(said, stages, clock):
    """The sum of stages in POV-Ray's statistics; those that were not run are not told."""
    found = [re.search(STAGE.format(stage), said, re.S) for stage in stages]
    if not any(found):
        raise speed.Failure(f"no time in what was said:\n{said[-600:]}")
    return sum(float(stage.group(2 if clock == "cpu" else 1)) for stage in found if stage)


def povray_run(options, scene, path, threads, picture, more=(), clock=None):
    """Times of one run, by the clock of the options if none is named."""
    command = [options.povray, f"+I{path.name}", f"+O{picture}", *scene.options, *COMMON, f"+WT{threads}", *more]
    try:
        run = speed.execute(command, path.parent, options.limit)
    except speed.Failure as failure:
        raise NotByPovray(str(failure)) from None
    # A stage's text must not reach into the next one's: POV-Ray says "No photons" where none were shot.
    said = re.sub(r"(Photon|Radiosity) Time:\s+No \w+", "", run.said)
    clock = clock or options.clock
    parse, trace = (povray_seconds(said, stages, clock) for stages in (PARSE, TRACE))
    # By the wall, POV-Ray's whole run has most of a second in which it sleeps: its stages are what it does.
    return Times(parse, trace, run.cpu if clock == "cpu" else parse + trace, run.memory)


def whittle_run(options, scene, path, threads, picture):
    """Times of one run, and what it was warned of leaving out."""
    report = f"{picture}.json"
    command = [options.whittle, f"+I{path.name}", f"+O{picture}", *scene.options, *COMMON, f"+WT{threads}",
               f"--json={report}"]
    run = speed.execute(command, path.parent, options.limit)
    frame = json.loads(pathlib.Path(report).read_text())["frames"][0]
    seconds = "cpu_seconds" if options.clock == "cpu" else "seconds"
    parse, plan, trace, write = (frame["phases"][f"{phase}_{seconds}"] for phase in ("parse", "plan", "trace", "write"))
    left_out = sorted({message["text"].split(":")[0] for message in frame["messages"]
                       if message["severity"] == "warning" and "without it" in message["text"]})
    return Times(parse + plan, trace, run.cpu if options.clock == "cpu" else parse + plan + trace + write, run.memory), left_out


class Scan:
    """How long each scene takes POV-Ray, kept in a file: it does not change, and asking takes minutes."""

    def __init__(self, file):
        self.file = file
        self.known = json.loads(pathlib.Path(file).read_text()) if file and os.path.exists(file) else {}

    def entry(self, scene, phase, compute):
        """{"trace": s, "total": s} or {"error": text} of the scene; `compute` is called if the phase is not known."""
        state = scene.path.stat()
        key = f"{scene.path} {' '.join(scene.options)} {state.st_size} {int(state.st_mtime)}"
        if not {phase, "error"} & self.known.get(key, {}).keys():
            self.known[key] = compute()
            self.save()
        return self.known[key]

    def save(self):
        if self.file:
            part = f"{self.file}.part"
            pathlib.Path(part).write_text(json.dumps(self.known, indent=1))
            os.replace(part, self.file)


def slow_scenes(options, scenes, scan, copies, root, picture):
    """The scenes of a folder that take POV-Ray long enough."""
    for number, scene in enumerate(scenes, 1):
        def compute():
            try:
                times = povray_run(options, scene, copies.place(scene, root), 1, picture, clock="cpu")
                return dict(trace=times.trace, total=times.total)
            except speed.Failure as failure:
                return dict(error=str(failure))
        entry = scan.entry(scene, options.phase, compute)
        print(f"scan {number} of {len(scenes)}: {scene.name} {entry.get(options.phase, 'fails')}", file=sys.stderr)
        if entry.get(options.phase, 0) >= options.slow:
            yield scene, entry


def measure(options, scene, entry, paths, threads, folder):
    """A row of the table. `paths`: of POV-Ray's copy of the scene and of ours. `entry`: what the scan keeps of it."""
    theirs, ours = f"{folder}/povray.png", f"{folder}/whittle.png"
    for picture in (theirs, ours):
        pathlib.Path(picture).unlink(missing_ok=True)
    povray, whittle, row = [], [], dict(scene=scene.name, threads=threads, own=scene.own)
    for turn in range(options.runs):  # in turn, so that both see the same machine
        povray.append(povray_run(options, scene, paths[0], threads, theirs))
        times, left_out = whittle_run(options, scene, paths[1], threads, ours)
        whittle.append(times)
        if turn:
            continue
        agree = speed.agreement(options.whittle, theirs, ours)[0]
        whole = not left_out  # what is left out explains a difference: POV-Ray with itself need not be asked
        if agree < MATCH and whole and "self" not in entry:
            again = f"{folder}/again.png"
            povray_run(options, scene, paths[0], 1, again, ["+BS8"])
            entry["self"] = speed.agreement(options.whittle, theirs, again)[0]
        matches = agree >= MATCH or whole and agree >= entry["self"] - NOISE
        explained = not matches and options.effects and agree >= DIFFER.get(scene.name, MATCH)
        row.update(agree=round(agree, 4), own_agree=entry.get("self"), left_out=left_out, explained=explained,
                   matches=matches or explained)
        if not row["matches"] and not scene.own:
            break  # what is not the same picture has no speed
    for who, runs in (("povray", povray), ("whittle", whittle)):
        for phase in ("parse", "trace", "total"):
            row[f"{who}_{phase}_s"] = round(statistics.median(getattr(run, phase) for run in runs), 4)
        row[f"{who}_mb"] = round(max(run.memory for run in runs) / 2**20, 1)
    row["ratio"] = round(row[f"povray_{options.phase}_s"] / max(row[f"whittle_{options.phase}_s"], 1e-4), 2)
    return row


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", metavar="SCENE")
    parser.add_argument("--folder", type=pathlib.Path, action="append", metavar="FOLDER",
                        help=f"a collection of scenes ({EXAMPLES})")
    parser.add_argument("--total", dest="phase", action="store_const", const="total", default="trace", help="whole runs count, not tracing alone")
    parser.add_argument("--effects", action="store_true", help="nine scenes whose light scatters and bounces")
    parser.add_argument("--own-only", action="store_true", help="the scenes of this folder alone")
    parser.add_argument("--threads", type=int, nargs="+", help="(1)")
    parser.add_argument("--runs", type=int, help="of each, of which the median counts (3)")
    parser.add_argument("--clock", choices=["cpu", "wall"], default="cpu")
    parser.add_argument("--slow", type=float, default=0.2, help="POV-Ray's least seconds for a scene of a folder (0.2)")
    parser.add_argument("--size", type=width_and_height, default=(320, 240), help="of the pictures of a folder (320x240)")
    parser.add_argument("--antialias", type=float, metavar="THRESHOLD", help="of the pictures of a folder (none)")
    parser.add_argument("--draw", type=int, metavar="N", help="so many scenes of the folders at random, however long they take, and none of this folder")
    parser.add_argument("--seed", type=int, default=1, help="of the draw (1)")
    parser.add_argument("--limit", type=float, default=600, help="most seconds for a run (600)")
    parser.add_argument("--bar", type=float, help="least geometric mean (6)")
    parser.add_argument("--least", type=float, help="least ratio of a scene (2.5)")
    for kind in ("cache", "json", "markdown", "csv"):
        parser.add_argument(f"--{kind}", metavar="FILE")
    parser.add_argument("--whittle", default=str(speed.HERE.parent / "build/release/whittle"))
    parser.add_argument("--povray", default="povray")
    options = parser.parse_args()
    usual = dict(threads=[1], runs=3, bar=6.0, least=2.5)
    if options.effects:
        usual = dict(threads=[1, 2], runs=5, bar=5.0, least=5.0)
        options.scenes = options.scenes or list(EFFECTS)
        options.slow = 0.0
    for name, value in usual.items():
        if getattr(options, name) is None:
            setattr(options, name, value)
    speed.programs_from_here(options)
    return parser, options


def main():
    parser, options = arguments()
    folders = [] if options.own_only else [folder.resolve() for folder in options.folder or [pathlib.Path(EXAMPLES)]]

    def wanted(scene):
        return not options.scenes or any(fnmatch.fnmatchcase(scene.name, name) for name in options.scenes)

    groups = [(folder, [scene for scene in folder_scenes(folder, options) if wanted(scene)]) for folder in folders]
    if options.draw:
        groups = drawn(groups, options.draw, options.seed)
    else:
        groups.insert(0, (None, [scene for scene in own_scenes() if wanted(scene)]))
    if not any(scenes for _, scenes in groups):
        parser.error("no such scene")

    scan, rows, excluded, failures, skipped = Scan(options.cache), [], [], [], []
    with tempfile.TemporaryDirectory() as scratch:
        povrays, ours = Copies(scratch, "povray"), Copies(scratch, "whittle")
        for root, scenes in groups:
            if root is None or options.draw:
                picked = [(scene, {}) for scene in scenes]
            else:
                picked = list(slow_scenes(options, scenes, scan, povrays, root, f"{scratch}/scan.png"))
            for number, (scene, entry) in enumerate(picked, 1):
                place = root or speed.HERE / "scenes"
                paths = povrays.place(scene, place), ours.place(scene, place)
                for threads in options.threads:
                    print(f"{number} of {len(picked)} {scene.name} +WT{threads}", end=": ", file=sys.stderr, flush=True)
                    try:
                        row = measure(options, scene, entry, paths, threads, scratch)
                    except speed.Failure as failure:
                        print(failure, file=sys.stderr)
                        unmeasured = options.draw and isinstance(failure, NotByPovray)
                        (skipped if unmeasured else failures).append((scene.name, str(failure)))
                        continue
                    scan.save()
                    times = " / ".join(f"{row[f'{who}_{options.phase}_s']:.3f}" for who in ("povray", "whittle"))
                    print(f"{times} = {row['ratio']:.2f} {remark(row)}", file=sys.stderr)
                    (rows if row["matches"] or scene.own else excluded).append(row)

    rows.sort(key=lambda row: row["ratio"])
    excluded.sort(key=lambda row: row["agree"])
    told = summary(rows, options.phase)
    print(plain(rows, options.phase))
    print("\n".join(f"{title}: {value}" for title, value in told.items()))
    if excluded:
        print(f"left out, other pictures: {', '.join(row['scene'] for row in excluded)}")
    if skipped:
        print(f"left out, POV-Ray refuses them or does not end: {', '.join(name for name, _ in skipped)}")
    if options.markdown:
        text = markdown(rows, options.phase) + "\n\n" + "\n".join(f"- {title}: {value}" for title, value in told.items()) + "\n"
        if excluded:
            text += "\nLeft out, as their pictures differ:\n\n" + markdown(excluded, options.phase) + "\n"
        pathlib.Path(options.markdown).write_text(text)
    if options.json:
        pathlib.Path(options.json).write_text(json.dumps(dict(
            phase=options.phase, clock=options.clock, runs=options.runs, summary=told, scenes=rows, excluded=excluded,
            failures=[dict(scene=name, text=text) for name, text in failures]), indent=1) + "\n")
    if options.csv and rows:
        with open(options.csv, "w", newline="") as file:
            writer = csv.DictWriter(file, fieldnames=rows[0].keys())
            writer.writeheader()
            writer.writerows(dict(row, left_out=" ".join(row["left_out"])) for row in rows + excluded)
    good = bool(rows) and not failures and all(row["matches"] for row in rows)
    return 0 if good and told["geometric mean"] >= options.bar and rows[0]["ratio"] >= options.least else 1


if __name__ == "__main__":
    sys.exit(main())
