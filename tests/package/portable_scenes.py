#!/usr/bin/env python3
"""portable_scenes.py PROGRAM FOLDER: scenes that need a library each (FOLDER/*.pov), with pictures by PROGRAM (expected_*.png) to compare with."""

import pathlib
import struct
import subprocess
import sys

PLAIN = """#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0.5, 0.5, -2> look_at <0.5, 0.5, 0> right x*1.33 up y }
light_source { <2, 4, -6>, rgb 1 }
"""
SHOWN = PLAIN + 'plane { z, 0 pigment { image_map { KIND "NAME" } } finish { ambient 1 diffuse 0 } }\n'
INCLUDES = PLAIN + """#include "colors.inc"
#include "stones.inc"
sphere { <0.5, 0.5, 0>, 0.4 texture { T_Stone10 scale 0.3 } }
plane { -z, -1 pigment { checker color Red color Blue scale 0.2 } }
"""
TEXT = PLAIN + 'text { ttf "timrom.ttf" "Wh" 0.2, 0 scale 0.6 translate <0.1, 0.3, 0> pigment { rgb <1, 0.7, 0.2> } }\n'


def colour(x, y):
    return bytes([x * 30 % 256, y * 30 % 256, (x + y) * 16 % 256])


def write_pictures(folder):
    rows = [[colour(x, y) for x in range(8)] for y in range(8)]
    (folder / "a.ppm").write_bytes(b"P6 8 8 255\n" + b"".join(b"".join(row) for row in rows))
    turned = b"".join(pixel[::-1] for row in reversed(rows) for pixel in row)
    (folder / "a.tga").write_bytes(struct.pack("<3B5x4H2B", 0, 0, 2, 0, 0, 8, 8, 24, 0) + turned)
    header = struct.pack("<2sI4xI", b"BM", 54 + len(turned), 54) + struct.pack("<IiiHHIIiiII", 40, 8, 8, 1, 24, 0, len(turned), 0, 0, 0, 0)
    (folder / "a.bmp").write_bytes(header + turned)


def main():
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True)
    write_pictures(folder)
    scenes = {"includes": INCLUDES, "text": TEXT}
    for kind, name in [("ppm", "a.ppm"), ("tga", "a.tga"), ("bmp", "a.bmp")]:
        scenes[kind] = SHOWN.replace("KIND", kind).replace("NAME", name)
    scenes["png"] = SHOWN.replace("KIND", "png").replace("NAME", "expected_includes.png")
    for name, text in scenes.items():
        (folder / f"{name}.pov").write_text(text)
        subprocess.run([program, f"{name}.pov", "+W64", "+H48", f"+Oexpected_{name}.png"], cwd=folder, check=True, stderr=subprocess.DEVNULL)


if __name__ == "__main__":
    main()
