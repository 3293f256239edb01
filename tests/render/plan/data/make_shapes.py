#!/usr/bin/python3
"""Writes shapes.csv with the real POV-Ray: what extents, rays and points of the objects in shapes.txt answer.

usage: make_shapes.py [NAME...] [--povray CMD]

Rows `NAME,extent,min,max`, `NAME,ray,origin,direction,hit,point,raw normal`, `NAME,point,point,inside`. Rays aim into the
object's box from outside; points lie in it, grown a little. With names, the rows of the others stay as they are.
"""
import argparse
import pathlib
import random
import subprocess
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
RAYS, POINTS = 24, 16
HEADER = "name,question,values"
HEAD = '#version 3.7; global_settings { assumed_gamma 1 }\n#macro V(a) vstr(3, a, ",", 0, 12) #end\n#declare N = <0,0,0>;\n#fopen F "answers.txt" write\n'


def ask(povray, text):
    """What POV-Ray writes to F, line by line; raises if it refuses the scene."""
    with tempfile.TemporaryDirectory() as folder:
        scene = pathlib.Path(folder, "ask.pov")
        scene.write_text(text)
        done = subprocess.run([povray, "+Iask.pov", "-D", "-F", "+W1", "+H1"], cwd=folder, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
        written = pathlib.Path(folder, "answers.txt")
        if done.returncode != 0 or not written.exists():
            raise SystemExit(text + done.stdout)
        return written.read_text().splitlines()


def vector(v):
    return "<" + ",".join(repr(round(c, 6)) for c in v) + ">"


def rows_of(povray, name, sdl, patch):
    declared = HEAD + f"#declare S = {sdl}\n"
    lines = ask(povray, declared + '#write(F, concat(V(min_extent(S)), ",", V(max_extent(S)), "\\n"))\n')
    box = [float(v) for v in lines[0].split(",")]
    rows = [[name, "extent", *lines[0].split(",")]]
    low, high = [max(v, -3.0) for v in box[:3]], [min(v, 3.0) for v in box[3:]]
    middle = [(a + b) / 2 for a, b in zip(low, high)]
    size = max(b - a for a, b in zip(low, high))
    rng = random.Random(name)
    text, asked = declared, []
    for _ in range(RAYS):
        aim = [rng.uniform(a, b) for a, b in zip(low, high)]
        way = [rng.gauss(0, 1) for _ in range(3)]
        length = sum(c * c for c in way) ** 0.5
        start = [round(m + 2 * size * c / length, 4) for m, c in zip(middle, way)]
        along = [a - s for a, s in zip(aim, start)]
        length = sum(c * c for c in along) ** 0.5
        along = [round(c / length, 6) for c in along]
        text += f'#declare H = trace(S, {vector(start)}, {vector(along)}, N);\n'
        text += '#write(F, concat(str((vlength(N) > 0), 0, 0), ",", V(H), ",", V(N), "\\n"))\n'
        asked.append(["ray", *map(repr, start), *map(repr, along)])
    for _ in range(0 if patch else POINTS):
        p = [round(rng.uniform(a - 0.05 * size, b + 0.05 * size), 4) for a, b in zip(low, high)]
        text += f'#write(F, concat(str(inside(S, {vector(p)}), 0, 0), "\\n"))\n'
        asked.append(["point", *map(repr, p)])
    answers = ask(povray, text)
    assert len(answers) == len(asked), (name, len(answers))
    return rows + [[name, *question, *answer.split(",")] for question, answer in zip(asked, answers)]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("names", nargs="*")
    parser.add_argument("--povray", default="povray")
    args = parser.parse_args()
    table = HERE / "shapes.csv"
    kept = {}
    if table.exists():
        for line in table.read_text().splitlines()[1:]:
            kept.setdefault(line.split(",")[0], []).append(line)
    made = []
    for line in (HERE / "shapes.txt").read_text().splitlines():
        if not line or line.startswith("#"):
            continue
        name, kind, sdl = line.split("\t")
        if args.names and name not in args.names and name in kept:
            made += kept[name]
            continue
        made += [",".join(row) for row in rows_of(args.povray, name, sdl, kind == "patch")]
    table.write_text("\n".join([HEADER, *made]) + "\n")


if __name__ == "__main__":
    main()
