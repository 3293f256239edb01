#!/usr/bin/python3
"""What `whittle plan` says of a job against what the job takes, in processor seconds: stills and animations.

usage: farm_plan.py [--program build/release/whittle] [NAME...]

A still is a scene of bench/scenes; an animation is the same with a camera that goes by, a ball that moves and, half way, a glass one that
comes. The table ends with how many are within 20 %.
"""
import argparse
import json
import pathlib
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
STILLS = {"cornell": "800x600", "glass_merge": "640x480", "lens_stack": "800x600", "gears": "1600x1200", "everyday/glass_balls": "1024x768",
          "everyday/lens_and_area_light": "640x480", "everyday/isosurface_ridges": "640x480"}
ANIMATIONS = {"cornell": "200x150", "gears": "640x480", "everyday/glass_balls": "320x240"}
FRAMES = 36


def wrapper(scene):
    return (f'#include "{scene}"\nsphere {{ <2*clock - 1, 1, 0>, 0.3 + 0.4*clock pigment {{ rgb <1, clock, 0> }} }}\n'
            "#if (clock > 0.5) sphere { <0, 1.5, -1>, 0.5 pigment { rgbt 0.9 } interior { ior 1.5 } finish { reflection 0.2 } } #end\n")


def run(program, words, folder):
    told = subprocess.run([program, "plan", *words, "--json", "--tasks=12"], cwd=folder, capture_output=True, text=True, check=True)
    plan = json.loads(told.stdout)
    subprocess.run([program, *words, "+WT1", "--quiet", "--json=took.json", "+Oa"], cwd=folder, check=True)
    took = json.loads((folder / "took.json").read_text())
    frames = [sum(v for k, v in f["phases"].items() if k.endswith("cpu_seconds")) for f in took["frames"]]
    said = sum(t["seconds"] for t in plan["tasks"]) + (plan["prepare"] or {"seconds": 0})["seconds"]
    if plan["kind"] == "still":  # every part reads the scene again, and what is needed once is found once
        reading = sum(v for k, v in took["frames"][0]["phases"].items() if k in ("parse_cpu_seconds", "plan_cpu_seconds"))
        return said, frames[0] + (len(plan["tasks"]) - 1 + bool(plan["prepare"])) * reading, plan
    return said, sum(frames), plan


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=str(ROOT / "build/release/whittle"))
    parser.add_argument("names", nargs="*")
    given = parser.parse_args()
    program = str(pathlib.Path(given.program).resolve())
    jobs = [(n, s, False) for n, s in STILLS.items()] + [(n, s, True) for n, s in ANIMATIONS.items()]
    print("| job | planned s | took s | off by | plan expects | planning s |\n|---|---:|---:|---:|---:|---:|")
    good = count = 0
    for name, size, moves in jobs:
        if given.names and name not in given.names:
            continue
        with tempfile.TemporaryDirectory() as place:
            folder = pathlib.Path(place)
            scene = ROOT / f"bench/scenes/{name}.pov"
            words = [str(scene)]
            if moves:
                (folder / "moves.pov").write_text(wrapper(scene))
                words = ["moves.pov", f"+KFF{FRAMES}", f"+L{scene.parent}"]
            width, height = size.split("x")
            said, took, plan = run(program, [*words, f"+W{width}", f"+H{height}", "+A0.3"], folder)
        off = said / took - 1
        count += 1
        good += abs(off) <= 0.2
        what = f"{FRAMES} frames" if moves else "still"
        expected = "not known" if plan["expected_error"] is None else f"{100 * plan['expected_error']:.0f} %"
        print(f"| {name}, {what}, {size} | {said:.2f} | {took:.2f} | {100 * off:+.0f} % | {expected} | "
              f"{plan['measuring_seconds']:.2f} |", flush=True)
    print(f"\n{good} of {count} within 20 %")


main()
