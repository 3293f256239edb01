#!/usr/bin/python3
"""Makes reference_images/ with the real POV-Ray, never with whittle.

usage: make_references.py [NAME...] [--povray CMD] [--povray38 CMD] [--jobs N]

Reads the golden_case lines of the CMakeLists.txt beside it (name, size, switches) and renders each scene from its own
folder to reference_images/NAME.png; NAME.txt beside it records the version and the command line. Without names: all
scenes; names such as csg/bite: those alone. Scenes of povray38/ are rendered by POV-Ray 3.8, all others by 3.7. Refuses
any version but the two that the project compares itself with.
"""
import argparse
import concurrent.futures
import pathlib
import re
import shlex
import subprocess
import sys

VERSION, VERSION_38 = "3.7.0.10", "3.8.0-beta.2"
HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
CASE = re.compile(r'''^golden_case\((\S+) SIZE (\d+)x(\d+)(?: AGREE [\d.]+)?(?: SWITCHES ((?:(?! SHOULDFAIL)[^)])*))?'''
                  r'''(?: SHOULDFAIL "[^"]*")?\)''', re.M)


def version_of(povray, wanted):
    """The line by which POV-Ray names itself."""
    done = subprocess.run([povray, "--version"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    found = re.search(r"POV-Ray v?(\S+)", done.stdout)
    if not found or not found.group(1).startswith(wanted):
        sys.exit(f"{povray} is {found.group(1) if found else 'not POV-Ray'}; the references are made by {wanted}")
    return found.group(0)


def render(povray, version, case):
    """Renders one case; returns its name and an error text, empty if all went well."""
    name, width, height, switches = case
    scene = ROOT / "scenes" / f"{name}.pov"
    picture = ROOT / "reference_images" / f"{name}.png"
    picture.parent.mkdir(parents=True, exist_ok=True)
    up = "../" * (name.count("/") + 1)
    command = [povray, f"+I{scene.name}", f"+O{up}reference_images/{name}.png", f"+W{width}", f"+H{height}", "-A",
               *(s for s in shlex.split(switches or "") if not s.startswith("--")), "-D", "-P", "+WT1", "+FN8"]
    done = subprocess.run(command, cwd=scene.parent, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, errors="replace")
    if done.returncode != 0:
        errors = [line for line in done.stdout.splitlines() if "rror" in line]
        return name, " ".join(errors) or f"exit status {done.returncode}"
    folder = scene.parent.relative_to(ROOT)
    picture.with_suffix(".txt").write_text(f"{version}\ncd {folder} && {shlex.join(['povray'] + command[1:])}\n")
    return name, ""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*")
    parser.add_argument("--povray", default="povray")
    parser.add_argument("--povray38", default="povray38", help="a command that runs POV-Ray 3.8")
    parser.add_argument("--jobs", type=int, default=2)
    options = parser.parse_args()
    text = (HERE / "CMakeLists.txt").read_text()
    cases = CASE.findall(text)
    if len(cases) != len(re.findall(r"^golden_case\(", text, re.M)):
        sys.exit("a golden_case line of CMakeLists.txt is not understood")
    unknown = set(options.names) - {case[0] for case in cases}
    if unknown:
        sys.exit("no golden_case for " + ", ".join(sorted(unknown)))
    if options.names:
        cases = [case for case in cases if case[0] in options.names]
    failed = 0
    for povray, wanted, later in ((options.povray, VERSION, False), (options.povray38, VERSION_38, True)):
        of_this = [case for case in cases if case[0].startswith("povray38/") == later]
        if not of_this:
            continue
        version, made = version_of(povray, wanted), 0
        with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
            for name, error in pool.map(lambda case: render(povray, version, case), of_this):
                made += not error
                if error:
                    print(f"{name}: {error}", file=sys.stderr)
        failed += len(of_this) - made
        print(f"{made} of {len(of_this)} reference pictures made by {version}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
