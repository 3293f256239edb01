#!/usr/bin/python3
"""Whether a picture is the same bytes on a processor without fused products: there the C library picks other functions, and the
kernel is that of v2. Scenes are rendered as this machine does and as such a one would.

usage: older_processor.py WHITTLE FOLDER|SCENE... [--every K] [--threads N]
"""
import argparse
import hashlib
import os
import pathlib
import subprocess
import sys
import tempfile

OLDER = {"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-FMA,-FMA4,-AVX2,-AVX2_Usable,-FMA_Usable"}
SECONDS = 120


def picture(whittle, scene, threads, out, older):
    """The file's digest; nothing if there is none."""
    switches = [f"+O{out}", "+W120", "+H90", "-D", f"+WT{threads}"] + (["--isa=v2"] if older else [])
    out.unlink(missing_ok=True)
    try:
        subprocess.run([whittle, f"+I{scene.name}", *switches], cwd=scene.parent, env={**os.environ, **(OLDER if older else {})},
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=SECONDS, check=True)
    except (subprocess.TimeoutExpired, subprocess.CalledProcessError):
        return None
    return hashlib.sha256(out.read_bytes()).hexdigest() if out.exists() else None


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("whittle", type=pathlib.Path)
    parser.add_argument("places", type=pathlib.Path, nargs="+")
    parser.add_argument("--every", type=int, default=1, help="of a folder's scenes, one in so many")
    parser.add_argument("--threads", type=int, default=1)
    options = parser.parse_args()
    scenes = []
    for place in options.places:
        scenes += sorted(place.rglob("*.pov"))[::options.every] if place.is_dir() else [place] if place.exists() else []
    whittle, compared, different = options.whittle.resolve(), 0, 0
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "picture.png"
        for scene in scenes:
            usual = picture(whittle, scene.resolve(), options.threads, out, older=False)
            if usual is None:
                print(f"{scene}: no picture here in {SECONDS} s")
                continue
            compared += 1
            if picture(whittle, scene.resolve(), options.threads, out, older=True) != usual:
                different += 1
                print(f"{scene}: another picture on an older processor")
    print(f"{compared} scenes, {different} differ")
    return 1 if different or not compared else 0


if __name__ == "__main__":
    sys.exit(main())
