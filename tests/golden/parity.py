#!/usr/bin/python3
"""Turns a score over many scenes into the lists of docs/parity/scenes.md.

usage: parity.py SCORE

SCORE: {id: {rc, agree, self, error, ...}}, the report of a score run.
A scene matches when at least 99 % of its pixels are within 3/255 in every channel, or when that share is within 1 % of
POV-Ray's own at another block size (self). The others are listed with the share of agreeing pixels or the first error.
"""
import argparse
import json
import pathlib
import sys

MATCH = 0.99
NOISE = 0.01


def matches(row):
    agree = row.get("agree", -1)
    return agree >= MATCH or agree >= row.get("self", 1) - NOISE


def said(row):
    """The agreement, and where that is low POV-Ray's with itself."""
    own = "" if row["agree"] >= MATCH else f"; POV-Ray with itself {row['self']:.4f}"
    return f"{row['agree']:.4f}{own}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("score", type=pathlib.Path)
    options = parser.parse_args()
    score = json.loads(options.score.read_text())

    matched = sorted(name for name, row in score.items() if matches(row))
    faults = [(name, row) for name, row in sorted(score.items()) if name not in matched]

    print(f"{len(matched)} of {len(score)} scenes match.\n\n## Matching\n")
    print("\n".join(f"- {name} ({said(score[name])})" for name in matched) or "none")
    print("\n## Not matching\n")
    for name, row in sorted(faults, key=lambda item: -item[1].get("agree", -1)):
        state = f"{row['agree']:.4f} agree, POV-Ray with itself {row.get('self', 1):.4f}" if "agree" in row else f"exit status {row['rc']}: {row.get('error', '')}"
        print(f"- {name}: {state}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
