"""POV-Ray's pictures and texts of some seeds, kept beside the generator: references/CLASS.png is a sheet of pictures from left
to right and from above, references/CLASS.json what each was made from and what it printed."""
import concurrent.futures
import hashlib
import json
import pathlib
import re
import subprocess
import sys
import tempfile

import png
import programs
import scenes

FOLDER = pathlib.Path(__file__).resolve().parent / "references"
SEEDS = 20       # a class: those from 0 on that POV-Ray does not refuse
COLUMNS = 5
SIZE = (40, 30)  # of one picture
VERSION = "3.7.0.10"

# Scenes of the recorded seeds that do not agree yet, and why (docs/parity.md). One that agrees again has to leave the list.
KNOWN: dict[tuple[str, int], str] = {
    ("copies", 17): "an opaque merge with a clear part filters light twice where POV-Ray remembers it as what blocked light last (spec 3, 13.3)",
}


def digest(text):
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def pictures(program, kind, seeds, jobs, tag):
    """Renders scenes of a class; gives the results in the order of the seeds."""
    def one(seed):
        name = f"{kind}_{seed}"
        (folder / f"{name}.pov").write_text(scenes.text(kind, seed))
        return programs.render(program, folder, name, SIZE, tag)

    with tempfile.TemporaryDirectory() as temporary, concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        folder = pathlib.Path(temporary)
        scenes.write_companions(folder)
        return list(pool.map(one, seeds))


def record(options):
    done = subprocess.run([options.povray, "--version"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    found = re.search(r"POV-Ray (\S+)", done.stdout)
    if not found or not found.group(1).startswith(VERSION):
        sys.exit(f"{options.povray} is {found.group(1) if found else 'not POV-Ray'}; the references are made by {VERSION}")
    FOLDER.mkdir(exist_ok=True)
    for kind in options.classes or scenes.CLASSES:
        results = pictures(options.povray, kind, range(2 * SEEDS), 16, "povray")
        kept = [(seed, result) for seed, result in enumerate(results) if not result.error][:SEEDS]
        blank = [bytearray(3 * SIZE[0])] * SIZE[1]
        tiles = [result.rows for _, result in kept] + [blank] * (-len(kept) % COLUMNS)
        rows = [b"".join(tile[y] for tile in tiles[at:at + COLUMNS]) for at in range(0, len(tiles), COLUMNS) for y in range(SIZE[1])]
        png.write(FOLDER / f"{kind}.png", COLUMNS * SIZE[0], rows)
        entries = [{"seed": seed, "scene": digest(scenes.text(kind, seed)), **({"prints": result.printed} if result.printed else {})}
                   for seed, result in kept]
        (FOLDER / f"{kind}.json").write_text(json.dumps({"version": found.group(0), "scenes": entries}, indent=1) + "\n")
        print(f"{kind}: {len(kept)} scenes recorded with {found.group(0)}")
    return 0


def check(options):
    """Compares Whittle with what was recorded: all agree but those that KNOWN names, and these do not."""
    faults = 0
    for kind in options.classes or scenes.CLASSES:
        entries = json.loads((FOLDER / f"{kind}.json").read_text())["scenes"]
        _, _, sheet = png.read(FOLDER / f"{kind}.png")
        results = pictures(options.whittle, kind, [entry["seed"] for entry in entries], 2, "whittle")
        agreeing = 0
        for at, (entry, ours) in enumerate(zip(entries, results)):
            if digest(scenes.text(kind, entry["seed"])) != entry["scene"]:
                print(f"{kind} {entry['seed']}: the generator makes another scene now; run differential.py record")
                continue
            x, y = 3 * SIZE[0] * (at % COLUMNS), SIZE[1] * (at // COLUMNS)
            theirs = programs.Result([row[x:x + 3 * SIZE[0]] for row in sheet[y:y + SIZE[1]]], "", entry.get("prints", ""))
            state, detail = programs.verdict(ours, theirs)
            known = KNOWN.get((kind, entry["seed"]))
            agreeing += (state == "agree") != bool(known)
            if known:
                print(f"{kind} {entry['seed']}: {detail}: known: {known}" + (", but agrees: take it from KNOWN" if state == "agree" else ""))
            elif state != "agree":
                print(f"{kind} {entry['seed']}: {state}: {detail}")
        print(f"{kind}: {agreeing} of {len(entries)} as expected")
        faults += len(entries) - agreeing
    return 1 if faults else 0
