#!/usr/bin/python3
"""Whether a picture is the same bytes on another processor. Scenes are rendered as this machine does, and as one without fused
products would (there the C library picks other functions, and the kernel is that of v2), or by the program of another kind
of processor (tests/package/arm64.sh).

usage: other_processor.py WHITTLE FOLDER|SCENE... [--other COMMAND] [--every K] [--threads N] [--at-once N]
"""
import argparse
import hashlib
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

OLDER = {"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-FMA,-FMA4,-AVX2,-AVX2_Usable,-FMA_Usable"}
SECONDS = 120


def picture(command, scene, threads, out, environment, seconds):
    """The file's digest; nothing if there is none."""
    switches = [f"+I{scene.name}", f"+O{out}", "+W120", "+H90", "-D", f"+WT{threads}"]
    out.unlink(missing_ok=True)
    try:
        subprocess.run([*command, *switches], cwd=scene.parent, env={**os.environ, **environment}, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL, timeout=seconds, check=True)
    except (subprocess.TimeoutExpired, subprocess.CalledProcessError):
        return None
    return hashlib.sha256(out.read_bytes()).hexdigest() if out.exists() else None


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("whittle", type=pathlib.Path)
    parser.add_argument("places", type=pathlib.Path, nargs="+")
    parser.add_argument("--other", help="the command of another processor's program, instead of this one on an older processor")
    parser.add_argument("--every", type=int, default=1, help="of a folder's scenes, one in so many")
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--at-once", type=int, default=1, help="scenes")
    options = parser.parse_args()
    scenes = []
    for place in options.places:
        scenes += sorted(place.rglob("*.pov"))[::options.every] if place.is_dir() else [place] if place.exists() else []
    usual = [str(options.whittle.resolve())]
    # An emulated processor takes some thirty times as long.
    other = (shlex.split(options.other), {}, 30 * SECONDS) if options.other else ([*usual, "--isa=v2"], OLDER, SECONDS)

    def same(scene):
        """Nothing if this machine makes no picture."""
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / "picture.png"
            here = picture(usual, scene.resolve(), options.threads, out, {}, SECONDS)
            command, environment, seconds = other
            return here and picture(command, scene.resolve(), options.threads, out, environment, seconds) == here

    compared, different = 0, 0
    with ThreadPoolExecutor(options.at_once) as pool:
        for scene, is_same in zip(scenes, pool.map(same, scenes)):
            if is_same is None:
                print(f"{scene}: no picture here in {SECONDS} s", flush=True)
                continue
            compared += 1
            if not is_same:
                different += 1
                print(f"{scene}: another picture on the other processor", flush=True)
    print(f"{compared} scenes, {different} differ")
    return 1 if different or not compared else 0


if __name__ == "__main__":
    sys.exit(main())
