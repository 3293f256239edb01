#!/usr/bin/python3
"""Whether types and functions have the field's names: none of those that were once ours alone is declared or called.

usage: names.py [ROOT]
"""
import pathlib
import re
import sys

TYPES = ("Wave WaitingRay Onward FlatForm FlatTerm FlatCut FlatHits LoneLayer LayersAhead Shine Gate RayRecord Outer Heeding "
         "Narrator Board PlaceTile TextureLooks").split()
FUNCTIONS = "own_start touches meet crossed_light take_clarity undrawn certain trace_ray shade_hit".split()
DECLARED = re.compile(rf"\b(?:struct|class|using|enum)\s+({'|'.join(TYPES)})\b|\b({'|'.join(FUNCTIONS)})\(")


def found_in(text):
    """(line, name) of each in C++ text; comments may say what they like."""
    for number, line in enumerate(text.splitlines(), 1):
        for match in DECLARED.finditer(line.split("//")[0]):
            yield number, match[1] or match[2]


def main():
    if list(found_in("struct Gate {\nx.meet(a);  // touches(b)\nmet(a);")) != [(1, "Gate"), (2, "meet")]:
        sys.exit("names.py finds wrongly")
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[2]).resolve()
    read, wrong = 0, 0
    for folder in ("numbers", "csg", "function", "language", "parser", "render"):
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in {".h", ".cpp"}:
                continue
            read += 1
            for line, name in found_in(path.read_text()):
                print(f"{path.relative_to(root)}:{line}: {name}")
                wrong += 1
    print(f"{read} files, {wrong} names")
    return 1 if wrong or read < 500 else 0


if __name__ == "__main__":
    sys.exit(main())
