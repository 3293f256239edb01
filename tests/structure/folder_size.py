#!/usr/bin/python3
"""Whether no folder holds more than 25 files of sources, headers, READMEs and CMake lists.

usage: folder_size.py [ROOT]

A folder with more has become several things. Scenes and recorded data are not counted.
"""
import collections
import pathlib
import sys

MOST = 25
COUNTED = {".h", ".cpp", ".inc", ".py", ".md", ".cmake"}
SKIPPED = {".git", "build", "__pycache__", "data", "references", "dumps"}
FREE = ("scenes", "reference_images", "bench/scenes")   # one file a scene


def crowded(paths):
    """{folder: number of files} of the folders with too many of them; `paths` are relative to the root."""
    counts = collections.Counter()
    for path in paths:
        if path.suffix not in COUNTED and path.name != "CMakeLists.txt" or SKIPPED & set(path.parts):
            continue
        if not any(path.is_relative_to(folder) for folder in FREE):
            counts[str(path.parent)] += 1
    return {folder: count for folder, count in counts.items() if count > MOST}, sum(counts.values())


def check_itself():
    """25 files pass, 26 do not; what is not counted does not count."""
    files = [pathlib.PurePath("csg", f"{i}.h") for i in range(25)]
    more = [pathlib.PurePath("csg/CMakeLists.txt")]
    if crowded(files)[0] or crowded(files + more)[0] != {"csg": 26} or crowded(files + [pathlib.PurePath("csg/data/x.md")])[0]:
        sys.exit("folder_size.py counts wrongly")


def main():
    check_itself()
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[2]).resolve()
    too_many, total = crowded(path.relative_to(root) for path in root.rglob("*") if path.is_file())
    for folder, count in sorted(too_many.items()):
        print(f"{folder}: {count} files; at most {MOST}")
    print(f"{total} files, {len(too_many)} folders with too many")
    return 1 if too_many or total < 200 else 0


if __name__ == "__main__":
    sys.exit(main())
