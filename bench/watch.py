#!/usr/bin/env python3
"""From a save to the first and to the whole picture, by the clock of the browser that shows it, with POV-Ray's whole run beside it.

usage: watch.py WHITTLE [SCENE...]      prints the table of docs/watch.md; milliseconds, 320x240, +A0.3, medians of 3 saves
"""
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
sys.path.insert(0, os.path.join(ROOT, "tests", "watch"))
import browser  # noqa: E402

SCENES = ["first_light", "csg/bite", "csg/clipped_by", "mesh/instances", "texture/map_normals", "light/area_illumination", "glass/total_reflection",
          "finish/irid", "camera/focal_blur", "atmosphere/fog_ground"]


def measure(program, scene, runs):
    folder = tempfile.mkdtemp(prefix="whittle-bench-")
    try:
        copy = os.path.join(folder, os.path.basename(scene))
        with open(scene) as file:
            text = file.read()
        with open(copy, "w") as out:
            out.write(text)
        beside = "+L" + os.path.dirname(os.path.abspath(scene))
        run = subprocess.Popen([program, "watch", copy, "+W320", "+H240", beside], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        first, full = [], []
        try:
            address = run.stdout.readline().strip()
            with browser.Browser() as page:
                page.open(address)
                page.wait("state.doneGeneration > 0", 120)
                for k in range(runs):
                    before = page.ask("state.doneGeneration")
                    saved = 1e3 * time.time()
                    with open(copy, "w") as out:
                        out.write(text + f"\n// {k}\n")
                    page.wait(f"state.doneGeneration > {before}", 120)
                    first.append(page.ask("state.firstAt") - saved)
                    full.append(page.ask("state.doneAt") - saved)
        finally:
            run.terminate()
            run.wait()
        povray = []
        for _ in range(runs if shutil.which("povray") else 0):
            started = time.monotonic()
            subprocess.run(["povray", "+I" + copy, "+O" + os.path.join(folder, "p.png"), "+W320", "+H240", "+A0.3", "-D", "-P", beside],
                           cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False, timeout=300)
            povray.append(1e3 * (time.monotonic() - started))
        return statistics.median(first), statistics.median(full), statistics.median(povray) if povray else float("nan")
    finally:
        shutil.rmtree(folder)


def main():
    if not browser.find():
        print("no chromium: nothing is measured")
        return 77
    program = os.path.abspath(sys.argv[1])
    print("| scene | first picture | whole picture | POV-Ray's run |\n|---|---:|---:|---:|")
    for scene in sys.argv[2:] or [os.path.join(ROOT, "scenes", name + ".pov") for name in SCENES]:
        if not os.path.exists(scene):
            continue
        first, full, povray = measure(program, scene, 3)
        name = os.path.relpath(scene, os.path.join(ROOT, "scenes"))[:-4]
        print(f"| {name} | {first:.0f} | {full:.0f} | {povray:.0f} |", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
