#!/usr/bin/env python3
"""Prints the SHA-256 of every golden scene's picture file, rendered as its test does: what another compiler or system is to give too.

usage: sums.py WHITTLE [--like FILE]

--like compares with what it once printed and names what differs; the exit status is 1 then. Scenes that one of the two lacks differ too.
"""
import hashlib
import pathlib
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

from ratchet import HERE, cases_in, render


def main():
    if len(sys.argv) not in (2, 4) or sys.argv[2:3] not in ([], ["--like"]):
        sys.exit(__doc__)
    whittle = str(pathlib.Path(sys.argv[1]).resolve())  # scenes are rendered from their own folders
    cases = cases_in((HERE / "CMakeLists.txt").read_text())
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(2) as pool:
        pictures = pool.map(lambda case: render(whittle, case, pathlib.Path(folder)), cases.values())
        sums = {name: hashlib.sha256(picture.read_bytes()).hexdigest() for name, picture in zip(cases, pictures)}
    for name, digest in sums.items():
        print(f"{digest}  {name}")
    if len(sys.argv) == 4:
        other = {name: digest for digest, name in (line.split() for line in pathlib.Path(sys.argv[3]).read_text().splitlines())}
        differ = sorted(name for name in sums.keys() | other.keys() if sums.get(name) != other.get(name))
        print(f"{len(sums)} pictures, {len(differ)} differ from {sys.argv[3]}", *differ, sep="\n", file=sys.stderr)
        return 1 if differ else 0
    return 0


if __name__ == "__main__":
    sys.exit(main())
