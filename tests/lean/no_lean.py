#!/usr/bin/env python3
"""Whether --no-lean gives the same picture to the byte: every golden scene, with its switches, at a small size.

usage: no_lean.py WHITTLE [SCENE...]

Scenes are the golden_case lines of tests/golden/CMakeLists.txt, or those named (csg/bite). The file with all of what the picture does not
show left out is compared with the file of --no-lean. Two processes at a time, one thread each.
"""
import pathlib
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
WIDTH, HEIGHT = 40, 30


def golden_scenes():
    """Name and switches of every golden_case."""
    lines = re.findall(r"^golden_case\((.*)\)$", (ROOT / "tests/golden/CMakeLists.txt").read_text(), re.M)
    out = {}
    for line in lines:
        words = re.sub(r'SHOULDFAIL ".*?"', "", line).split()
        out[words[0]] = words[words.index("SWITCHES") + 1:] if "SWITCHES" in words else []
    return out


def picture(whittle, scene, switches, folder, more):
    path = pathlib.Path(folder) / (scene.replace("/", "_") + ("".join(more)) + ".png")
    command = [whittle, f"+I{ROOT / 'scenes' / scene}.pov", f"+O{path}", f"+W{WIDTH}", f"+H{HEIGHT}", "-D", "+WT1", "--quiet", *switches, *more]
    run = subprocess.run(command, capture_output=True, text=True, timeout=120)
    return path.read_bytes() if run.returncode == 0 else run.stderr.encode()


def main():
    whittle, named = sys.argv[1], sys.argv[2:]
    scenes = {name: switches for name, switches in golden_scenes().items() if not named or name in named}
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(2) as pool:
        def differs(scene):
            lean, full = (picture(whittle, scene, scenes[scene], folder, more) for more in ([], ["--no-lean"]))
            return None if lean == full and lean.startswith(b"\x89PNG") else scene

        others = [scene for scene in pool.map(differs, scenes) if scene is not None]
    print(f"{len(scenes)} scenes, {len(others)} differ")
    if others or not scenes:
        sys.exit("\n".join(others) or "no scene")


if __name__ == "__main__":
    main()
