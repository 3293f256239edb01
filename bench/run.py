#!/usr/bin/python3
"""Speed against POV-Ray on scenes heavy with CSG.

usage: bench/run.py [SCENE...] [--bar 4] [--runs 5] [--threads 1 2] [--csv FILE] [--whittle CMD] [--povray CMD]

Each scene is rendered by both programs in turn, `--runs` times each, for each number of threads. What counts is the
time of tracing alone: POV-Ray's "Trace Time" and the trace stage that whittle prints; the median of the runs. A picture
that does not agree with POV-Ray's (99 % of the pixels within 3/255) has no speed and counts as a failure.
Exit status 1 if a ratio is below the bar or a picture is wrong. Run it on a machine that does nothing else.
"""
import pathlib
import sys

import speed

# Sizes that keep POV-Ray busy for one to four seconds on one thread.
SIZES = {
    "drilled_wall": (1280, 960),
    "gears": (800, 600),
    "glass_merge": (640, 480),
    "lens_stack": (640, 480),
    "nested_eight": (640, 480),
    "pitted_block": (640, 480),
    "polyhedra_field": (1280, 960),
    "turned_pieces": (1280, 960),
}

if __name__ == "__main__":
    sys.exit(speed.run(__doc__, pathlib.Path(__file__).resolve().parent / "scenes", SIZES, [1, 2]))
