#!/usr/bin/python3
"""Writes kernels.proftext beside this file: the profile (counts of branches and calls) that the kernels are optimised with.

usage: cmake/profile/train.py

Builds with the preset `train`, renders every scene of scenes/ and bench/scenes/ with the kernels v3 and v4, and merges the counts. Where the
processor has no v4, functions that v3 does not have keep the counts that they had.
Needs what packages.txt names and libclang-rt-14-dev, whose library the counting kernels are linked with. Six minutes on two cores.
"""
import os
import pathlib
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
BUILD = ROOT / "build/train"
LEVELS = ["v3", "v4"] if "avx512bw" in pathlib.Path("/proc/cpuinfo").read_text() else ["v3"]
SIZE = ["+W160", "+H120"]
LEFT_OUT = {"stiff"}  # folders whose scenes are extreme on purpose


def scenes():
    found = [*(ROOT / "scenes").rglob("*.pov"), *(ROOT / "bench/scenes").rglob("*.pov")]
    return sorted(scene for scene in found if scene.parent.name not in LEFT_OUT)


def render(level, folder):
    """Renders all scenes with one kernel, one after the other, because two at once would write to the same file of counts.

    Returns the scenes that failed.
    """
    failed = []
    environment = dict(os.environ, LLVM_PROFILE_FILE=f"{folder}/{level}_%m.profraw")
    for scene in scenes():
        command = [BUILD / "whittle", f"+I{scene.name}", f"+O{folder}/{level}.png", *SIZE, "-D", "-P", "+WT1", f"--isa={level}", "--quiet"]
        done = subprocess.run(command, cwd=scene.parent, env=environment, capture_output=True)
        if done.returncode != 0:
            failed.append(scene.relative_to(ROOT))
    return failed


def records(text):
    """Name -> record of each function of a profile as text; what stands before the first has no name."""
    parts = text.split("\n\n")
    return {part.lstrip("\n").split("\n# Func Hash", 1)[0].split("\n")[-1]: part for part in parts if "# Func Hash" in part}


def main():
    subprocess.run(["cmake", "--preset", "train", "-DWHITTLE_ISA_LEVELS=" + ";".join(LEVELS)], cwd=ROOT, check=True)
    subprocess.run(["ninja", "-C", BUILD, "whittle"], check=True)
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(len(LEVELS)) as pool:
        failed = set().union(*pool.map(lambda level: render(level, folder), LEVELS))
        for scene in sorted(failed):
            print(f"{scene}: failed, counted as far as it went", file=sys.stderr)
        counts = sorted(pathlib.Path(folder).glob("*.profraw"))
        if len(counts) < len(LEVELS):
            sys.exit("a kernel has counted nothing")
        # -sparse leaves out functions that never ran; they are compiled as if there were no profile.
        profile = HERE / "kernels.proftext"
        had = profile.read_text() if len(LEVELS) == 1 else ""
        subprocess.run(["llvm-profdata-14", "merge", "-sparse", "-text", "-o", profile, *counts], check=True)
        made = profile.read_text()
        kept = {name: record for name, record in records(had).items() if name not in records(made)}
        profile.write_text("\n\n".join([made.rstrip("\n"), *kept.values()]) + "\n")


if __name__ == "__main__":
    main()
