#!/usr/bin/python3
"""Speed of reading scenes against POV-Ray.

usage: bench/parse.py [SCENE...] [--bar 10] [--runs 5] [--whittle CMD] [--povray CMD] [--examples FOLDER]

Both programs read each scene in turn, `--runs` times. POV-Ray's time is the processor time of its parsing alone, as it
prints it; Whittle's is that of a whole `--parse-only` run, start and end included. The minimum of the runs counts, as
other work of the machine only adds. What the scenes print must be equal. Peak memory is that of the whole process.
Exit status 1 if a ratio is below the bar, memory is above POV-Ray's or the text differs.
"""
import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
PARSE = re.compile(r"Parse Time:.*?\(([0-9.]+) seconds\)\s*using 1 thread\(s\) with ([0-9.]+) CPU-seconds", re.S)
OURS = ["macro_calls", "array_operations"]
EXAMPLES = {"tracevines": "language/tracevines.pov", "mesh_camera": "camera/mesh_camera/meshcam_persp_demo.pov"}


def run(command, folder):
    """Text, processor seconds and peak kilobytes of a program."""
    with tempfile.TemporaryFile("w+", errors="replace") as said:
        process = subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=said, stderr=subprocess.STDOUT)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        said.seek(0)
        text = said.read()
    if process.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: exit status {process.returncode}\n{text[-600:]}")
    return text, usage.ru_utime + usage.ru_stime, usage.ru_maxrss


def printed(text):
    """The lines that #debug of our own scenes prints."""
    return re.findall(r"^(?:total|sum) .*", text, re.M)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("scenes", nargs="*", default=OURS + list(EXAMPLES))
    parser.add_argument("--bar", type=float, default=10)
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--whittle", default=str(HERE.parent / "build/release/whittle"))
    parser.add_argument("--povray", default="povray")
    parser.add_argument("--examples", default="/usr/share/doc/povray/examples")
    args = parser.parse_args()
    failed = False
    print(f"{'scene':18} {'POV-Ray s':>10} {'Whittle s':>10} {'ratio':>7} {'POV-Ray MB':>11} {'Whittle MB':>11}")
    with tempfile.TemporaryDirectory() as scratch:
        for name in args.scenes:
            source = HERE / f"parse/{name}.pov" if name in OURS else pathlib.Path(args.examples, EXAMPLES[name])
            folder = pathlib.Path(scratch, name)  # these scenes write files: beside a copy of themselves
            shutil.copytree(source.parent, folder)
            theirs, ours, their_memory, our_memory = [], [], [], []
            for _ in range(args.runs):
                size = [f"+I{source.name}", "+W320", "+H240"]
                text, _, memory = run([args.povray, *size, "-D", "-P", "-F", "+WT1", "+SR1", "+ER1"], folder)
                theirs.append(float(PARSE.search(text).group(2)))
                their_memory.append(memory)
                said, seconds, memory = run([args.whittle, "--parse-only", *size, "+L/usr/share/povray-3.7/include"], folder)
                ours.append(seconds)
                our_memory.append(memory)
                if printed(text) != printed(said):
                    print(f"{name}: the scene prints {printed(said)}, with POV-Ray {printed(text)}")
                    failed = True
            ratio = min(theirs) / max(min(ours), 1e-6)
            failed = failed or ratio < args.bar or min(our_memory) > min(their_memory)
            print(f"{name:18} {min(theirs):10.3f} {min(ours):10.3f} {ratio:7.1f} {min(their_memory) / 1024:11.1f} {min(our_memory) / 1024:11.1f}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
