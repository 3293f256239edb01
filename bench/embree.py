#!/usr/bin/python3
"""Nanoseconds a ray of csg::World and of Embree 3 over the same scenes and rays.

usage: bench/embree.py [--balls 100000] [--triangles 1000000] [--runs 5] [--isa v3] [--csv FILE] [--build FOLDER]

Camera rays of a picture of 640x480 and the shadow rays of what they hit, from one lamp. Ours goes in tiles of 64 rays,
as a picture is rendered, and ray by ray; Embree in packets of 16 and 8 and ray by ray. Processor time of one thread, the
least of the runs; the line below each group is Embree's best over ours. Ours is in double precision, Embree in single.
Building is per primitive.
Exit status 1 if both do not hit alike (0.1 % of the rays).

Needs Embree 3 (libembree-dev) when the build is configured, then: ninja -C build/release embree_rays_v3
"""
import argparse
import csv
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
SAME = 0.001  # of the rays may hit in one program alone: edges, in single precision


def groups(rows):
    """[(scene, kind of rays), rows] in the order of the program."""
    found = {}
    for row in rows:
        found.setdefault((row["scene"], row["rays"]), []).append(row)
    return found.items()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--balls", type=int, default=100_000)
    parser.add_argument("--triangles", type=int, default=1_000_000)
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--isa", default="v3", help="level of x86-64 of ours; Embree chooses for itself")
    parser.add_argument("--csv")
    parser.add_argument("--build", type=pathlib.Path, default=HERE.parent / "build/release")
    options = parser.parse_args()
    program = options.build / f"embree_rays_{options.isa}"
    if not program.exists():
        parser.error(f"{program} is not built: install libembree-dev, configure again, build {program.name}")

    numbers = [str(options.runs), str(options.balls), str(options.triangles)]
    done = subprocess.run([program, *numbers], stdout=subprocess.PIPE, text=True, check=False)
    if done.returncode:
        return 1
    if options.csv:
        pathlib.Path(options.csv).write_text(done.stdout)
    rows = list(csv.DictReader(done.stdout.splitlines()))

    good = True
    print(f"{'scene':<18} {'rays':<7} {'program':<8} {'how':<14} {'ns a ray':>9} {'hits':>8}")
    for (_, kind), group in groups(rows):
        best = {who: min(float(row["ns_a_ray"]) for row in group if row["program"] == who)
                for who in ("Whittle", "Embree")}
        for row in group:
            print(f"{row['scene']:<18} {row['rays']:<7} {row['program']:<8} {row['method']:<14} {row['ns_a_ray']:>9} "
                  f"{row['hits']:>8}")
        print(f"{'':<18} {'':<7} {'best of Embree / best of Whittle':<32}{best['Embree'] / best['Whittle']:>9.2f}")
        if kind != "build":
            hits = [int(row["hits"]) for row in group]
            good &= max(hits) - min(hits) <= SAME * int(group[0]["count"])
    if not good:
        print("the programs do not hit alike", file=sys.stderr)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
