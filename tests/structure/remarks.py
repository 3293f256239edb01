#!/usr/bin/python3
"""No remark stands where code should: that two places have to be changed together, or over and over what one README says.
And each \\param begins a line: clang-format joins those that wrap into the sentence before.

usage: remarks.py [ROOT]
"""
import pathlib
import re
import sys

# A rule that stands twice is one that can drift: make one template of it.
TWINS = re.compile(r"\b((change|keep|edit) (them|both|these) (together|in step|alike)|same operations in the same order)\b", re.I)
JOINED = re.compile(r"^\s*///.*\S\s*\\param\b", re.M)
KERNELS = re.compile(r"\bcompiled once (per|for each) instruction set\b", re.I)
SAID_IN = "render/kernel/README.md"
# Twins that say so and are left; the list only shrinks.
LEFT = {"csg/freeform/field/julia_lanes.cpp", "csg/freeform/field/julia_orbits.h",
        "csg/freeform/revolution/lathe_lanes.cpp"}
# Where the words tell of POV-Ray's rounding.
MEANT = {"csg/tree/face_held.h"}


def remarks(text):
    """The text of comments and pages in one line: remarks are broken anywhere."""
    return re.sub(r"\s*\n\s*(///?|\*|#)?\s*", " ", text)


def main():
    joined = [bool(JOINED.search(text)) for text in ("    /// A cut. \\param by what", "    /// A cut.\n    /// \\param by what")]
    if not TWINS.search(remarks("/// so change\n    /// them together.")) or TWINS.search("change them") or joined != [True, False]:
        sys.exit("remarks.py finds wrongly")
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[2]).resolve()
    read, wrong, said = 0, 0, []
    for folder in ("numbers", "csg", "function", "language", "parser", "render"):
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in {".h", ".cpp", ".md"}:
                continue
            read += 1
            written = path.read_text()
            text = remarks(written)
            for match in JOINED.finditer(written):
                print(f"{path.relative_to(root)}: {match[0].strip()}: \\param in the middle of a line")
                wrong += 1
            twins = [match[0] for match in TWINS.finditer(text)]
            if str(path.relative_to(root)) in MEANT:
                twins = []
            if bool(twins) != (str(path.relative_to(root)) in LEFT):
                print(f"{path.relative_to(root)}: {twins or 'is none of the twins that are left'}")
                wrong += 1
            if KERNELS.search(text):
                said.append(str(path.relative_to(root)))
    if said != [SAID_IN]:
        print("what the kernel is compiled for stands in", *said)
        wrong += 1
    print(f"{read} files, {wrong} remarks")
    return 1 if wrong or read < 500 else 0


if __name__ == "__main__":
    sys.exit(main())
