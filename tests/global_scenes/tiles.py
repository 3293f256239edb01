#!/usr/bin/python3
"""Whether scenes of docs/povray/data/global-scenes have the tile means that POV-Ray's have.

usage: tiles.py WHITTLE SCENE...

A tile's mean may be off POV-Ray's mean over nine runs by 1.5 times the spread of those, and by 1 in any case (spec 6, 7.3).
"""
import csv
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
DATA = ROOT / "docs/povray/data"
SIZE, TILE = (160, 120), 20


def picture(whittle, scene, folder):
    """Rows of bytes of the picture, three a pixel."""
    out = folder / f"{scene}.ppm"
    subprocess.run([*whittle.split(), f"+I{DATA / 'global-scenes' / scene}.pov", f"+O{out}", "+FP", f"+W{SIZE[0]}", f"+H{SIZE[1]}", "-A"],
                   check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    head, _, body = out.read_bytes().partition(b"\n255\n")
    assert head.split()[0] == b"P6" and len(body) == 3 * SIZE[0] * SIZE[1], "not the picture that was asked for"
    return [body[3 * SIZE[0] * y:3 * SIZE[0] * (y + 1)] for y in range(SIZE[1])]


def mean(rows, tile_x, tile_y):
    sums = [0, 0, 0]
    for row in rows[TILE * tile_y:TILE * (tile_y + 1)]:
        part = row[3 * TILE * tile_x:3 * TILE * (tile_x + 1)]
        for channel in range(3):
            sums[channel] += sum(part[channel::3])
    return [total / TILE ** 2 for total in sums]


def main():
    whittle, scenes = sys.argv[1], sys.argv[2:]
    with open(DATA / "06-global-scenes-tiles.csv", newline="") as table:
        known = [line for line in csv.DictReader(table) if line["scene"] in scenes]
    assert {line["scene"] for line in known} == set(scenes), "a scene has no tiles"
    failed = False
    with tempfile.TemporaryDirectory() as folder:
        for scene in scenes:
            rows = picture(whittle, scene, pathlib.Path(folder))
            tiles = [line for line in known if line["scene"] == scene]
            off, worst = 0, (0.0, "")
            for line in tiles:
                ours = mean(rows, int(line["tile_x"]), int(line["tile_y"]))
                far = max(abs(ours[i] - float(line[name])) for i, name in enumerate(("r_mean", "g_mean", "b_mean")))
                allowed = max(1.0, 1.5 * float(line["spread"]))
                off += far > allowed
                worst = max(worst, (far / allowed, f"tile {line['tile_x']},{line['tile_y']}: {far:.2f} of {allowed:.2f}"))
            print(f"{scene}: {len(tiles) - off} of {len(tiles)} tiles; the farthest is {worst[1]}")
            failed |= off > 0
    return failed


if __name__ == "__main__":
    sys.exit(main())
