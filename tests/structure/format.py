#!/usr/bin/python3
"""Whether every source is formatted as .clang-format says.

usage: format.py [ROOT] [--fix]

--fix formats what is not. Without clang-format 14 the test is skipped: other versions break lines elsewhere.
"""
import os
import pathlib
import shutil
import subprocess
import sys

FOLDERS = ("numbers", "csg", "function", "language", "parser", "render", "python", "tests", "bench")
NOT_RUN = 77
AT_ONCE = 40   # files a call


def formatter():
    """clang-format of version 14, or nothing."""
    for name in ("clang-format-14", "clang-format"):
        program = shutil.which(name)
        if program and " 14." in subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout:
            return program
    return None


def sources(root):
    for folder in FOLDERS:
        yield from sorted(path for path in (root / folder).rglob("*") if path.suffix in {".h", ".cpp"})


def main():
    words = [word for word in sys.argv[1:] if word != "--fix"]
    root = pathlib.Path(words[0] if words else pathlib.Path(__file__).parents[2]).resolve()
    program = formatter()
    if not program:
        print("clang-format 14 is not installed: nothing is checked")
        return NOT_RUN
    os.chdir(root)
    files = [str(path.relative_to(root)) for path in sources(root)]
    mode = ["-i"] if "--fix" in sys.argv else ["--dry-run", "-Werror"]
    bad = 0
    for first in range(0, len(files), AT_ONCE):
        said = subprocess.run([program, "--style=file", *mode, *files[first:first + AT_ONCE]], capture_output=True, text=True)
        wrong = [line for line in said.stderr.splitlines() if "clang-format-violations" in line]
        for line in wrong:
            print(line.replace(" [-Wclang-format-violations]", ""))
        bad += len(wrong)
        if said.returncode != 0 and not wrong:
            print(said.stderr)
            return 1
    print(f"{len(files)} sources, {bad} places are not as .clang-format says")
    return 1 if bad or len(files) < 200 else 0


if __name__ == "__main__":
    sys.exit(main())
