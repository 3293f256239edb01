#!/usr/bin/python3
"""Measures golden cases and gives each the bound that it reaches.

usage: ratchet.py [NAME...] [--whittle PROGRAM] [--write] [--jobs N]

Renders the scenes of the golden_case lines in the CMakeLists.txt beside it as their tests do, compares each with POV-Ray's
picture and prints its line with the bound AGREE: the measured share of agreeing pixels less 0.0005, down to five places.
--write puts those lines into CMakeLists.txt. A bound is only ever added or raised: a measurement below one that stands
there is named, and the exit status is 1. Without names: all cases.
"""
import argparse
import concurrent.futures
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
CASE = re.compile(r'''^golden_case\((?P<name>\S+) SIZE (?P<width>\d+)x(?P<height>\d+)(?: AGREE (?P<agree>[\d.]+))?'''
                  r'''(?P<rest>(?: SWITCHES (?P<switches>(?:(?! SHOULDFAIL)[^)])*))?(?: SHOULDFAIL "[^"]*")?\).*)$''', re.M)
MARGIN = 50  # hundred-thousandths: what a bound leaves free below its measurement, 0.05 % of the pixels


def cases_in(text):
    """The golden_case lines of a CMakeLists.txt, by name."""
    cases = {found["name"]: found.groupdict() | {"line": found[0]} for found in CASE.finditer(text)}
    if len(cases) != len(re.findall(r"^golden_case\(", text, re.M)):
        sys.exit("a golden_case line of CMakeLists.txt is not understood, or a name stands there twice")
    return cases


def render(whittle, case, folder):
    """Renders one case as its test does and returns the picture's path; ValueError tells why there is none."""
    scene = ROOT / "scenes" / f"{case['name']}.pov"
    picture = folder / (case["name"].replace("/", "_") + ".png")
    command = [*shlex.split(whittle), f"+I{scene.name}", f"+O{picture}", f"+W{case['width']}", f"+H{case['height']}", "-A",
               *shlex.split(case["switches"] or ""), "-D", "-P", "+FN8"]
    done = subprocess.run(command, cwd=scene.parent, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        raise ValueError(f"{case['name']}: exit status {done.returncode}\n{done.stdout}")
    return picture


def measure(whittle, case, folder):
    """Agreement of one case with its reference in hundred-thousandths, rounded down; ValueError tells why there is none."""
    picture = render(whittle, case, folder)
    reference = ROOT / "reference_images" / f"{case['name']}.png"
    compared = subprocess.run([shlex.split(whittle)[0], "compare", reference, picture, "--tolerance", "3"], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True).stdout
    percent = re.search(r"agreeing +(\d+)\.(\d{3})", compared)
    if not percent:
        raise ValueError(f"{case['name']}: {compared}")
    return int(percent.group(1) + percent.group(2))


def line_of(case, bound):
    """The golden_case line with AGREE `bound` hundred-thousandths."""
    share = f"{bound / 100000:.5f}".rstrip("0")
    return f"golden_case({case['name']} SIZE {case['width']}x{case['height']} AGREE {share}{case['rest']}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*")
    parser.add_argument("--whittle", default=str(ROOT / "build/release/whittle"), help="may carry options, as in \"whittle --isa=v3\"")
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--jobs", type=int, default=2)
    options = parser.parse_args()
    list_file = HERE / "CMakeLists.txt"
    text = list_file.read_text()
    cases = cases_in(text)
    unknown = set(options.names) - set(cases)
    if unknown:
        sys.exit("no golden_case for " + ", ".join(sorted(unknown)))
    chosen = [case for name, case in cases.items() if not options.names or name in options.names]
    below = 0
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        measured = pool.map(lambda case: measure(options.whittle, case, pathlib.Path(folder)), chosen)
        for case, agreement in zip(chosen, measured):
            stands = round(float(case["agree"] or 0) * 100000)
            if agreement < stands:
                below += 1
                print(f"{case['name']}: {agreement / 1000:.3f} % agree, {stands / 1000:.3f} % are asked for", file=sys.stderr)
            line = line_of(case, max(stands, agreement - MARGIN))
            text = text.replace(case["line"], line)
            print(line)
    if options.write:
        list_file.write_text(text)
    return 1 if below else 0


if __name__ == "__main__":
    sys.exit(main())
