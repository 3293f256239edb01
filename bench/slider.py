#!/usr/bin/env python3
"""From a slider's move to the picture with all pixels, by the clock of the browser that draws it, and what of that is tracing.

usage: slider.py WHITTLE [SCENE...]      prints the table of docs/watch.md; milliseconds, 160x120, medians of 15 moves of a number's slider,
                                         and whole pictures a second while it moves 60 times in one
"""
import os
import statistics
import sys

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
sys.path.insert(0, os.path.join(ROOT, "tests", "watch"))
import browser  # noqa: E402
from watched import NO_BROWSER, Seen, Watched  # noqa: E402

SCENES = ["csg/bite", "csg/clipped_by", "finish/irid", "glass/total_reflection", "atmosphere/fog_ground", "first_light"]
SIZE = (160, 120)


def measure(program, path):
    """Medians of the delay, of reading and planning and of tracing in it, and of all but tracing; whole pictures a second in motion.
    None: what the picture shows has no number."""
    with open(path) as file:
        text = file.read()
    options = [f"+W{SIZE[0]}", f"+H{SIZE[1]}", "--povray=off", "+L" + os.path.dirname(os.path.abspath(path))]
    with browser.Browser() as page, Watched(program, {os.path.basename(path): text}, options) as watched:
        seen = Seen(page, watched)
        for x, y in ((80, 60), (80, 90), (50, 60), (110, 60)):
            page.ask(f"post('show', {{ x: {x}, y: {y} }})")
            try:
                page.wait("state.focus && state.focus.numbers.length > 0", 3)
                break
            except TimeoutError:
                continue
        else:
            return None
        written = page.ask("state.focus.numbers[0].written")
        moves = [seen.slide(written + 0.01 * i) for i in range(16)][1:]
        sweep = seen.sweep(written, written + 0.3)
        return [statistics.median(column) for column in zip(*((*one, one[0] - one[2]) for one in moves))] + [sweep]


def main():
    if not browser.find():
        print("no chromium: nothing is measured")
        return NO_BROWSER
    print("| scene | to all pixels | reading, planning | tracing | above tracing | pictures a second |\n|---|---:|---:|---:|---:|---:|")
    for path in sys.argv[2:] or [os.path.join(ROOT, "scenes", name + ".pov") for name in SCENES]:
        found = measure(os.path.abspath(sys.argv[1]), path)
        if found is None:
            continue
        name = os.path.relpath(path, os.path.join(ROOT, "scenes"))[:-4]
        print(f"| {name} | " + " | ".join(f"{number:.0f}" for number in found) + " |", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
