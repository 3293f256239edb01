#!/usr/bin/python3
"""Writes kernels.proftext beside this file: the profile (counts of branches and calls) that the kernels are optimised with.

usage: cmake/profile/train.py

Builds with the preset `train`, renders every scene of scenes/ and bench/scenes/ with the kernels v3 and v4, and merges the counts.
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
LEVELS = ["v3", "v4"]
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
        subprocess.run(["llvm-profdata-14", "merge", "-sparse", "-text", "-o", HERE / "kernels.proftext", *counts], check=True)


if __name__ == "__main__":
    main()
