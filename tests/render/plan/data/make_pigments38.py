#!/usr/bin/env python3
"""Writes pigments38.txt: what POV-Ray 3.8 answers for pigments that 3.7 does not have.

usage: make_pigments38.py COMMAND...    POV-Ray 3.8 with its options, run in this folder
"""
import pathlib
import random
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
VALUES = "color_map { [-3 rgb -3] [3 rgb 3] }"
BLOB = ("blob { threshold 0.6 sphere { 0, 1.5, 2 } sphere { <1.5, 0.2, 0>, 0.9, -1 scale <1, 1.5, 1> } "
        "cylinder { <-1, -1, 0.3>, <1, 1.2, 0.7>, 0.8, 0.7 } }")
SURFACE = "isosurface { function { x*2 + y*y - z } threshold 0.25 contained_by { sphere { 0, 0.1 } } }"


def with_modifier(solid, modifier):
    return solid[:-1] + modifier + " }"


MANY = "blob { threshold 0.5 " + " ".join(f"sphere {{ <{i % 5 - 2}, {i % 3 - 1}, {i % 4 - 1.5}>, 1.3, {1 - i % 7 * 0.3:.1f} }}"
                                         for i in range(17)) + " }"
POTENTIALS = [f"potential {{ {solid} }} {rest}" for solid, rest in (
    (BLOB, ""), (BLOB, "threshold on"), (BLOB, "threshold off"), (BLOB, "frequency 3 phase 0.4"), (BLOB, "ramp_wave"),
    (BLOB, "sine_wave frequency 2"), (BLOB, "triangle_wave"), (BLOB, "poly_wave 2"), (BLOB, "scale 2 rotate z*30"),
    (BLOB, "turbulence 0.3"), (MANY, ""), (with_modifier(BLOB, "inverse"), "threshold on"),
    (with_modifier(BLOB, "scale <0.5, 1, 2> translate x"), ""), (SURFACE, ""), (SURFACE, "threshold on"),
    (with_modifier(SURFACE, "inverse"), "threshold on"), (with_modifier(SURFACE, "polarity 1"), "threshold on"), (with_modifier(SURFACE, "inverse rotate y*40"), ""))]
CRACKLES = [f"crackle {rest}" for rest in (
    "repeat <2, 3, 2>", "repeat <2.7, 3, 0.9>", "repeat 1", "repeat <0, 4, 0> form <1, 0, 0>", "repeat 2 solid",
    "repeat <3, 2, 1> metric 3", "repeat 2 metric 1 offset 0.1", "solid", "",
    "repeat 3 solid warp { planar }")]
PICTURES = [f'image_map {{ png "{picture}.png" gamma 1 {rest} }}'
            for picture in ("vrgb", "vrgba", "vpal")
            for rest in ("map_type 7", "map_type 7 interpolate 2 once", "transmit all 0.3", "filter all 0.4 transmit all 0.3",
                         "transmit all 0.3 transmit all 0.5 interpolate 2", "filter all 0.4 interpolate 3", "transmit all -0.5")]
CURVES = [f'image_map {{ png "vrgb.png" gamma {curve} }}' for curve in ("srgb", "bt709", "bt2020", "1.8")]
FADED = ['image_map { png "vrgba.png" gamma 1 premultiplied on transmit all 0.3 filter all 0.4 }']
MAPS = ["gradient x color_map { " + " ".join(f"[{i / 299:.6f} rgb <{i * 37 % 100 / 100}, {i / 299:.4f}, 0>]" for i in range(300)) + " }"]

LISTS = [f"{word} rgb x, rgb y{more} {rest}" for word, more in (("checker", ""), ("brick", ""), ("hexagon", ", rgb z"), ("square", ", rgb z, rgb 1"),
                                                                ("triangular", ", rgb z, rgb 1, rgb 0, rgb 0.5"), ("cubic", ", rgb z, rgb 1, rgb 0, rgb 0.5"))
         for rest in ("frequency 1 phase 0.3", "sine_wave")] + ["object { sphere { 0, 1.5 } rgb x, rgb y } frequency 1 phase 0.4"]


def asked(statements, points):
    """Five numbers for each statement at each point."""
    text = '#version 3.8;\nglobal_settings { assumed_gamma 1 }\nsphere { 0, 1 pigment { rgb 1 } }\n'
    for i, statement in enumerate(statements):
        text += f"#declare F{i} = function {{ pigment {{ {statement} }} }}\n"
        for x, y, z in points:
            text += f"#declare C = F{i}({x}, {y}, {z});\n"
            for part in ("red", "green", "blue", "filter", "transmit"):
                text += f'#debug concat("|", str(C.{part}, 0, 7), "\\n")\n'
    with tempfile.TemporaryDirectory() as folder:
        scene = pathlib.Path(folder) / "ask.pov"
        scene.write_text(text)
        done = subprocess.run([*sys.argv[1:], f"+I{scene}", f"+O{folder}/ask.png", "-D", "+W2", "+H2"], cwd=HERE,
                              capture_output=True, text=True, check=True)
    numbers = re.findall(r"^\|(\S+)$", done.stdout + done.stderr, re.M)
    assert len(numbers) == 5 * len(statements) * len(points), len(numbers)
    return numbers


def main():
    statements = [f"{p} {VALUES}" for p in POTENTIALS] + CRACKLES + PICTURES + CURVES + FADED + MAPS + LISTS
    chance = random.Random(1)
    points = [[round(chance.uniform(-2.5, 2.5), 3) for _ in range(3)] for _ in range(12)]
    # POV-Ray's cells of crackle outlive a pattern, whatever the next one's repeat: each is asked by itself.
    alone = set(CRACKLES)
    others = [s for s in statements if s not in alone]
    numbers = iter(asked(others, points))
    answers = {s: [next(numbers) for _ in range(5 * len(points))] for s in others}
    for statement in CRACKLES:
        answers[statement] = asked([statement], points)
    out = ["# Pigments of POV-Ray 3.8.0-beta.2, asked by make_pigments38.py: x y z, then red green blue filter transmit.",
           "# The scene: #version 3.8, assumed_gamma 1."]
    for statement in statements:
        out.append(f"= {statement}")
        for i, point in enumerate(points):
            out.append(" ".join([*map(str, point), *answers[statement][5 * i:5 * i + 5]]))
    (HERE / "pigments38.txt").write_text("\n".join(out) + "\n")


main()
