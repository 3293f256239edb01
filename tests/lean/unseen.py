#!/usr/bin/env python3
"""What a picture does not show costs nothing: neither a byte of it nor, beyond 0.5 %, an instruction of tracing changes.

usage: unseen.py WHITTLE

A small scene is rendered without and with one thing more of each kind, and the instructions of the v3 kernel between a tile's rays and its
colours are counted by callgrind (Debian package valgrind). With --no-lean the bytes are the same too. Exit status 77 (skipped) without
valgrind or AVX2.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

COUNTED = ["trace::shade_tile*", "csg::World::nearest(csg::RayTile*"]
MARGIN = 0.005
BASE = """#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.4, 0> angle 40 }
light_source { <-5, 8, -6> rgb 1 }
light_source { <6, 4, -3> rgb 0.3 }
box { <-4, -0.2, -4>, <4, 0, 4> pigment { checker rgb 0.8, rgb 0.3 } }
sphere { <1.2, 0.7, 0>, 0.7 pigment { rgb <0.8, 0.3, 0.2> } finish { phong 0.6 reflection 0.2 } }
#declare Carved = difference { box { <-1.8, 0, -0.6>, <-0.4, 1.2, 0.6> } sphere { <-1.1, 1.2, -0.6>, 0.5 } MORE pigment { rgb <0.3, 0.5, 0.7> } }
object { Carved }
"""
BALL = "sphere { <0, 0.8, -1.2>, 0.5 pigment { rgbf 1 } finish { reflection 0.1 } interior { ior 1.5 } }\n"
# Kind: a statement at the end, or an operand of the carved box.
THINGS = {
    "unused declarations": ("#declare Glass = texture { pigment { rgbf 0.9 } finish { reflection 0.1 } }\n"
                            "#declare Smoke = interior { media { scattering { 1, 0.2 } } }\n"
                            "#declare Ball = sphere { 0, 1 texture { Glass } interior { Smoke } }\n"
                            "#declare Haze = fog { distance 4 rgb 0.5 }\n"
                            "#declare Lamp = light_source { 0, rgb 1 area_light x, y, 9, 9 }\n", ""),
    "an unreachable branch of CSG": ("", "union { intersection { sphere { <30, 0, 0>, 1 } torus { 1, 0.2 translate 20*x } } "
                                         "sphere { <-40, 0, 0>, 1 } }"),
    "an operand that cannot matter": ("", "torus { 1, 0.25 translate <9, 3, 0> }"),
    "an object with nothing to draw": ("intersection { sphere { 0, 1 } sphere { 9*x, 1 } pigment { rgb 1 } }", ""),
    "a black light": ("light_source { <3, 9, -3> rgb 0 area_light x, y, 5, 5 }", ""),
    "a light of a group without objects": ("light_group { light_source { <3, 9, -3> rgb 1 } }", ""),
    "a spotlight on nothing": ("light_source { <0, 9, 0> rgb 1 spotlight radius 20 falloff 30 point_at <0, 20, 0> }", ""),
    "bounds around what they hold": ("", "bounded_by { box { <-3, -1, -2>, <3, 4, 3> } }"),
    "black media in the air": ("media { emission 0 absorption 0 }", ""),
    "photons without a target": ("global_settings { photons { spacing 0.02 } }", ""),
    "a patterned ball out of sight": ("sphere { <0, 60, -90>, 1 pigment { bozo } normal { bumps 1 } }", ""),
    "iridescence out of sight": ("sphere { <0, 60, -90>, 1 pigment { rgb 1 } finish { irid { 0.3 } } }", ""),
    "a slope pattern out of sight": ("sphere { <0, 60, -90>, 1 pigment { slope y } }", ""),
    "surface coordinates out of sight": ("sphere { <0, 60, -90>, 1 pigment { uv_mapping checker } }", ""),
    "patterned glass out of sight": ("sphere { <0, 60, -90>, 1 pigment { bozo color_map { [0 rgbt 1] [1 rgb 1] } } }", ""),
    "media out of sight": ("sphere { <0, 60, -90>, 1 hollow pigment { rgbt 1 } interior { media { emission 0.1 absorption 0.1 } } }", ""),
    "glass out of sight": ("sphere { <0, 60, -90>, 1 pigment { rgbf 1 } interior { ior 1.5 fade_distance 1 fade_power 2 } }", ""),
}
# The same in a scene with a ball of glass in its middle, whose rays ask what they are inside of.
BESIDE_GLASS = ["media out of sight", "glass out of sight"]


def scene(thing=("", ""), more=""):
    return BASE.replace("MORE", thing[1]) + more + thing[0] + "\n"


def run(whittle, text, folder, name, counted, more=()):
    """The picture's bytes, and its trace instructions where they are counted."""
    source, picture = folder / f"{name}.pov", folder / f"{name}.ppm"  # no text of the scene's own in it
    source.write_text(text)
    valgrind = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", *(f"--toggle-collect={f}" for f in COUNTED)]
    done = subprocess.run([*(valgrind if counted else []), whittle, f"+I{source}", f"+O{picture}", "+FP", "+W96", "+H72", "-A", "-D", "+WT1",
                           "--isa=v3", "--quiet", *more], capture_output=True, text=True)
    found = re.search(r"Collected : (\d+)", done.stderr)
    if done.returncode != 0 or (counted and not found):
        sys.exit(f"{name}: {done.stderr[-2000:]}")
    return picture.read_bytes(), int(found[1]) if counted else 0


def main():
    if shutil.which("valgrind") is None or " avx2 " not in pathlib.Path("/proc/cpuinfo").read_text():
        print("needs valgrind and a processor with AVX2")
        sys.exit(77)
    whittle, wrong = sys.argv[1], []
    with tempfile.TemporaryDirectory() as name, ThreadPoolExecutor(2) as pool:
        folder = pathlib.Path(name)
        things = [(what, thing, "") for what, thing in THINGS.items()]
        things += [(f"{what} beside glass", THINGS[what], BALL) for what in BESIDE_GLASS]
        plain = {more: run(whittle, scene(more=more), folder, "nothing", True) for more in ("", BALL)}
        jobs = [(what, more, pool.submit(run, whittle, scene(thing, more), folder, what.replace(" ", "_"), True),
                 pool.submit(run, whittle, scene(thing, more), folder, what.replace(" ", "_") + "_full", False, ["--no-lean"]))
                for what, thing, more in things]
        for what, more, lean, full in jobs:
            base, least = plain[more]
            bytes_lean, count = lean.result()
            change = count / least - 1.0
            print(f"{what:36} {count / 1e6:8.2f} million {100 * change:+6.2f} %")
            if bytes_lean != base or full.result()[0] != base:
                wrong.append(f"{what}: the picture differs")
            if change > MARGIN:
                wrong.append(f"{what}: {100 * change:.2f} % more instructions")
    if wrong:
        sys.exit("\n".join(wrong))


if __name__ == "__main__":
    main()
