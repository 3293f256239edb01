#!/usr/bin/python3
"""Scenes as people wrote them, changed in a few places: Whittle against POV-Ray.

usage: mutants.py run [--seeds A-B] [--scenes FOLDER...]    both programs render the scenes of seeds A to B, 80x60; prints what differs
       mutants.py print SEED                                 what the seed changes, line by line
       mutants.py cut SEED...                                the fewest of its changes by which the pictures still differ

A seed draws one of the scenes in the folders (POV-Ray's examples and ours) and changes numbers, words and blocks of it. What uses chance in POV-Ray
is left out, and so is a scene that differs unchanged. A picture agrees as in differential.py. Scenes that POV-Ray alone refuses are counted.
"""
import argparse
import collections
import concurrent.futures
import difflib
import os
import pathlib
import re
import sys
import tempfile

import alone
import programs
from mutation import change
from rng import Rng

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
SCENES = [pathlib.Path("/usr/share/doc/povray/examples"), ROOT / "scenes", ROOT / "bench/scenes/everyday"]
SIZE = (80, 60)
LIMIT = 30  # seconds for one picture
CHANCE = re.compile(r"\b(crand|jitter|aperture|subsurface|photons\s*\{|now\b|radiosity\s*\{|material_map|bump_map|#fopen|rad_def)")
OURS = re.compile(r"[Ww]hittle")  # scenes that show other things there


def bases(folders):
    """The scenes that may be changed, in order."""
    found = [path for folder in folders for path in sorted(folder.rglob("*.pov")) if "povray38" not in path.parts]
    texts = {path: path.read_text("latin1") for path in found}
    return [path for path in found if not CHANCE.search(texts[path]) and not OURS.search(texts[path])]


def mutant(options, seed):
    """The scene that a seed changes, and its text afterwards."""
    rng = Rng("mutants", seed)
    base = rng.pick(*options.bases)
    return base, change.changed(rng, base.read_text("latin1"))


def verdict(options, name, base, text):
    """(state, detail) of a text in the place of the scene `base`."""
    (options.folder / f"{name}.pov").write_text(text, "latin1")
    beside = f" +L{base.parent}"
    ours = programs.render(options.whittle + beside, options.folder, name, SIZE, "whittle", LIMIT)
    theirs = programs.render(options.povray + beside, options.folder, name, SIZE, "povray", LIMIT)
    if theirs.error and not ours.error:
        return "lenient", theirs.error
    state, detail = programs.verdict(ours, theirs)
    if state == "differ" and programs.same_text(ours, theirs):
        state, detail = alone.verdict(ours, options.povray + beside, options.folder, name, SIZE, theirs)
    return state, detail


def compare_one(options, seed):
    base, text = mutant(options, seed)
    if CHANCE.search(text):
        return seed, base, "left out", ""
    name = f"mutant_{seed}"
    state, detail = verdict(options, name, base, text)
    if state in ("differ", "fault") and verdict(options, f"base_{seed}", base, base.read_text("latin1"))[0] != "agree":
        state = "base differs"
    if state not in ("differ", "fault"):
        for left in [*options.folder.glob(f"{name}.*"), *options.folder.glob(f"base_{seed}.*")]:
            left.unlink()
    return seed, base, state, detail


def run(options):
    first, _, last = options.seeds.partition("-")
    counts = collections.Counter()
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for seed, base, state, detail in pool.map(lambda seed: compare_one(options, seed), range(int(first), int(last or first) + 1)):
            counts[state] += 1
            if state in ("differ", "fault"):
                print(f"{seed}: {state}: {detail} ({base})", flush=True)
    print(", ".join(f"{count} {state}" for state, count in counts.most_common()))
    return 1 if counts["differ"] + counts["fault"] else 0


def difference(base, text):
    """Which lines a mutant has in place of which."""
    return "\n".join(list(difflib.unified_diff(base.read_text("latin1").splitlines(), text.splitlines(), lineterm="", n=1))[2:])


def cut(options, seed):
    """Takes back one change after the other as long as the pictures differ."""
    base, text = mutant(options, seed)
    before, after = change.TOKEN.findall(base.read_text("latin1")), change.TOKEN.findall(text)
    kept = [op for op in difflib.SequenceMatcher(None, before, after, autojunk=False).get_opcodes() if op[0] != "equal"]

    def built(changes):
        out, at = [], 0
        for _, begin, end, low, high in changes:
            out += before[at:begin] + after[low:high]
            at = end
        return "".join(out + before[at:])

    name = f"cut_{seed}"
    wanted = verdict(options, name, base, text)[0]
    if wanted not in ("differ", "fault"):
        return f"{seed}: {wanted}"
    shorter = True
    while shorter:
        shorter = False
        for one in list(kept):
            fewer = [op for op in kept if op is not one]
            if verdict(options, name, base, built(fewer))[0] == wanted:
                kept, shorter = fewer, True
    state, detail = verdict(options, name, base, built(kept))
    return f"{seed}: {state}: {detail} ({base}, {options.folder / name}.pov)\n{difference(base, built(kept))}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--whittle", default=str(ROOT / "build/release/whittle"))
    parser.add_argument("--povray", default="povray")
    parser.add_argument("--folder", type=pathlib.Path, default=pathlib.Path(tempfile.gettempdir()) / "mutants")
    parser.add_argument("--scenes", type=pathlib.Path, nargs="+", default=SCENES)
    commands = parser.add_subparsers(dest="command", required=True)
    each = commands.add_parser("run")
    each.add_argument("--seeds", default="0-99")
    each.add_argument("--jobs", type=int, default=4 * (os.cpu_count() or 1))
    commands.add_parser("print").add_argument("seed", type=int)
    commands.add_parser("cut").add_argument("seeds", type=int, nargs="+")
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    options.bases = bases(options.scenes)
    if not options.bases:
        sys.exit("no scenes in " + ", ".join(map(str, options.scenes)))
    if options.command == "run":
        return run(options)
    if options.command == "print":
        base, text = mutant(options, options.seed)
        print(base, difference(base, text), sep="\n")
    else:
        for seed in options.seeds:
            print(cut(options, seed), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
