#!/usr/bin/python3
"""Speed against POV-Ray on scenes dominated by textures.

usage: bench/textures.py [SCENE...] [--bar 4] [--runs 5] [--threads 1] [--csv FILE] [--whittle CMD] [--povray CMD]

A wall, a floor and a ball of one texture under two lamps with shadows. Measured and judged as by bench/run.py.
"""
import pathlib
import sys

import speed

# Sizes that keep POV-Ray busy for one to three seconds.
SIZES = dict.fromkeys(["granite", "wrinkles", "crackle", "agate", "marble", "layered_wood", "layered_stone", "rough_plaster"],
                      (1280, 960))

if __name__ == "__main__":
    sys.exit(speed.run(__doc__, pathlib.Path(__file__).resolve().parent / "scenes" / "textures", SIZES, [1]))
