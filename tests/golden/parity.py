#!/usr/bin/python3
"""Turns a score over many scenes into the table of docs/parity.md.

usage: parity.py SCORE REFERENCE

SCORE: {id: {rc, agree, error, ...}}, the report of a score run. REFERENCE: {id: {path, rc, ...}}, what POV-Ray rendered.
A scene matches when at least 99 % of its pixels are within 3/255 in every channel. For the others the scene's text, with
the files of its own folder that it includes, is searched for what Whittle does not render yet; a scene with none of it
must be a fault of ours, and is listed as such with the share of agreeing pixels or the first error.
"""
import argparse
import collections
import json
import pathlib
import re
import sys

# What the text of a scene says when it needs something not rendered yet. A line goes when its feature arrives.
LACKING = {
    "dispersion": r"\bdispersion\b",
    "focal blur": r"\baperture\b",
    "image files (image_map, bump_map, material_map)": r"\bimage_map\b|\bbump_map\b|\bmaterial_map\b|\bimage_pattern\b",
    "light groups": r"\blight_group\b",
    "media": r"\bmedia\b|\bhalo\b",
    "photons": r"\bphotons\b",
    "radiosity": r"\bradiosity\b",
    "rainbow": r"\brainbow\b",
    "subsurface": r"\bsubsurface\b",
}
MATCH = 0.99


def scene_text(path, seen):
    """The scene without comments and strings, followed by the files of its folder that it includes."""
    if path in seen or not path.is_file():
        return ""
    seen.add(path)
    raw = path.read_text(encoding="latin1")
    includes = re.findall(r'#\s*include\s+"([^"]+)"', raw)
    raw = re.sub(r'/\*.*?\*/|//[^\n]*|"(?:\\.|[^"\\\n])*"', " ", raw, flags=re.S)
    return raw + "".join(scene_text(path.parent / name, seen) for name in includes)


def lacks(path):
    text = scene_text(pathlib.Path(path), set())
    return [name for name, pattern in LACKING.items() if re.search(pattern, text)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("score", type=pathlib.Path)
    parser.add_argument("reference", type=pathlib.Path)
    options = parser.parse_args()
    score = json.loads(options.score.read_text())
    reference = json.loads(options.reference.read_text())

    matched = sorted(name for name, row in score.items() if row.get("agree", -1) >= MATCH)
    wanting, faults = collections.defaultdict(list), []
    for name, row in sorted(score.items()):
        if name in matched:
            continue
        missing = lacks(reference[name]["path"])
        if not missing:
            faults.append((name, row))
        for feature in missing:
            wanting[feature].append((name, len(missing) == 1))

    print(f"{len(matched)} of {len(score)} scenes match.\n\n## Matching\n")
    print("\n".join(f"- {name} ({score[name]['agree']:.4f})" for name in matched) or "none")
    print("\n## What the others lack\n\n| feature | scenes with it | lacking it alone |\n|---|---:|---|")
    for feature, scenes in sorted(wanting.items(), key=lambda item: -len(item[1])):
        alone = [name for name, only in scenes if only]
        print(f"| {feature} | {len(scenes)} | {len(alone)}{': ' if alone else ''}{', '.join(alone)} |")
    print("\n## Not matching though nothing in the text is known to be lacking\n")
    for name, row in sorted(faults, key=lambda item: -item[1].get("agree", -1)):
        state = f"{row['agree']:.4f} agree" if "agree" in row else f"exit status {row['rc']}: {row.get('error', '')}"
        print(f"- {name}: {state}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
