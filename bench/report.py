#!/usr/bin/python3
"""The report of docs/report: error against run time of scenes that show each setting, of stiff and extreme ones, and of the solvers;
and on a page of its own radiosity, photons and paths against a truth of paths.

usage: bench/report.py [--out docs/report] [--binary build/release] [--rays 500] [--quick] [--only report|light] [-- options of whittle report]

Runs numerics_lab over all sweeps, then `whittle report` over the scenes below, beside the real POV-Ray where it is installed, then over
the scenes of light between surfaces. About ten minutes; --quick asks small pictures with a poor truth, to see that it works.
"""
import argparse
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
SCENES = ["scenes/first_light.pov"]
SCENES += [f"bench/scenes/phases/{name}.pov" for name in ("area_17_adaptive", "focal_blur", "glasses", "flange", "noisy_isosurface")]
SCENES += [f"bench/scenes/stiff/{name}.pov" for name in ("coincident_faces", "thin_shells", "grazing_glass", "nested_dielectrics",
                                                         "scale_small", "scale_large", "light_in_large_sphere", "many_operands")]
FULL = ["+W160", "+H120", "--truth-error=0.1", "--truth-seconds=5", "--longest=1", "--povray-longest=20"]
QUICK = ["+W64", "+H48", "--truth-error=1", "--truth-seconds=2", "--longest=0.3", "--povray-longest=5"]
LIGHT = ["bench/scenes/cornell.pov"]
LIGHT_FULL = ["--integrator=path", "--povray=off", "+W64", "+H64", "--truth-error=0.5", "--truth-seconds=90", "--longest=5", "--want=4"]
LIGHT_QUICK = ["--integrator=path", "--povray=off", "+W32", "+H32", "--truth-error=4", "--truth-seconds=5", "--longest=0.3", "--want=8"]


def named(path):
    return path.relative_to(ROOT) if path.is_relative_to(ROOT) else path


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "docs/report")
    parser.add_argument("--binary", type=pathlib.Path, default=ROOT / "build/release", help="folder of whittle and numerics_lab")
    parser.add_argument("--rays", type=int, default=500, help="of the laboratory, a row")
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--only", choices=["report", "light"], help="one of the two pages")
    parser.add_argument("rest", nargs="*", help="options of whittle report")
    args = parser.parse_args()
    args.out.mkdir(parents=True, exist_ok=True)
    out, binary = args.out.resolve(), args.binary.resolve()
    status = 0

    def report(name, scenes, options):
        nonlocal status
        # Named from the root of the project, so that the page shows a command that others can give.
        page = named(out / name)
        status = max(status, subprocess.run([binary / "whittle", "report", *scenes, "-o", page, *options, *args.rest],
                                            cwd=ROOT, check=False).returncode)

    if args.only != "light":
        solvers = out / "solvers.csv"
        subprocess.run([binary / "numerics_lab", "--rays", str(20 if args.quick else args.rays), "--csv", solvers],
                       stdout=subprocess.DEVNULL, check=True)
        report("report.html", SCENES, [f"--solvers={named(solvers)}", *(QUICK if args.quick else FULL)])
    if args.only != "report":
        report("light.html", LIGHT, LIGHT_QUICK if args.quick else LIGHT_FULL)
    return status


if __name__ == "__main__":
    sys.exit(main())
