#!/usr/bin/env python3
"""What a scene pays for a thing that its picture does not show: trace instructions of first_light with one thing more.

usage: bench/lean.py [--whittle PROGRAM] [--scene SCENE] [--isa v3] [--bar PERCENT]

Counts by callgrind (Debian package valgrind), which knows no AVX-512: no clock, the same numbers on every run. Counted are the instructions
between a tile's rays and its colours. Exit status 1 if a thing out of sight costs more than --bar per cent (0.5 if none is given), or fog that is too
thin to be seen more than --air (2): it lies before everything and has to be looked at.
"""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
THINGS = {
    "a black area light": "light_source { <1000, 1000, -1e5> rgb 0 area_light 5*x, 5*y, 5, 5 }",
    "a glass ball": "sphere { <0, 3000, -3000>, 1 pigment { rgbf 1 } interior { ior 1.5 } }",
    "a patterned ball": "sphere { <0, 3000, -3000>, 1 pigment { bozo } normal { bumps 1 } }",
    "a ball of patterned glass": "sphere { <0, 3000, -3000>, 1 pigment { bozo color_map { [0 rgbt 1] [1 rgb 1] } } }",
    "a texture map with mirrors": "sphere { <0, 3000, -3000>, 1 texture { bozo texture_map { [0 pigment { rgb 1 }] "
                                  "[1 pigment { rgb x } finish { reflection 0.3 }] } } }",
    "a ball of media": "sphere { <0, 3000, -3000>, 1 hollow pigment { rgbt 1 } interior { media { emission 0.1 absorption 0.1 } } }",
    "an isosurface": "isosurface { function { x*x + y*y + z*z - 1 } contained_by { sphere { 0, 1.1 } } translate <0, 3000, -3000> }",
}
AIR = {"thin fog": "fog { distance 1e12 rgb 0 }"}
COUNTED = ["trace::shade_tile*", "csg::World::nearest(csg::RayTile*"]


def instructions(program, text, isa, folder):
    """Trace instructions of a scene of 160x120 pixels on one thread."""
    scene = folder / "scene.pov"
    scene.write_text(text)
    command = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", *(f"--toggle-collect={name}" for name in COUNTED), program,
               f"+I{scene}", f"+O{folder / 'x.png'}", "+W160", "+H120", "-A", "-D", "+WT1", f"--isa={isa}", "--quiet"]
    run = subprocess.run(command, capture_output=True, text=True)
    found = re.search(r"Collected : (\d+)", run.stderr)
    if run.returncode != 0 or not found:
        sys.exit(f"lean.py: {' '.join(command)}: {run.stderr[-2000:]}")
    return int(found[1])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--whittle", default=str(ROOT / "build/release/whittle"))
    parser.add_argument("--scene", default=str(ROOT / "scenes/first_light.pov"))
    parser.add_argument("--isa", default="v3")
    parser.add_argument("--bar", type=float, default=0.5)
    parser.add_argument("--air", type=float, default=2.0)
    args = parser.parse_args()
    if shutil.which("valgrind") is None:
        sys.exit("lean.py: needs valgrind")
    text = pathlib.Path(args.scene).read_text()
    missed = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        base = instructions(args.whittle, text, args.isa, folder)
        print(f"{'nothing':28} {base / 1e6:9.1f} million")
        for thing, statement in (THINGS | AIR).items():
            count = instructions(args.whittle, text + "\n" + statement + "\n", args.isa, folder)
            more = 100.0 * (count / base - 1.0)
            print(f"{thing:28} {count / 1e6:9.1f} million {more:+6.1f} %")
            if more > (args.air if thing in AIR else args.bar):
                missed.append(thing)
    if missed:
        sys.exit(f"more than {args.bar:g} % (air: {args.air:g} %): {', '.join(missed)}")


if __name__ == "__main__":
    main()
