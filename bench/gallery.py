#!/usr/bin/python3
"""docs/guide/gallery.md: every scene of scenes/ with its picture, source and first comment; the pictures of docs/guide/tour.md.

usage: gallery.py [--check]
       gallery.py --tour [NAME...] [--whittle PROGRAM]

The pictures of the gallery are those of reference_images, which POV-Ray made and Whittle's match (ctest -R golden). --check changes
nothing and says by its exit status whether the page is up to date, and whether the tour has what it names: pictures, small ones,
of short scenes. --tour runs the commands that stand in the tour, all or those whose picture has one of the names.
"""
import argparse
import pathlib
import re
import shlex
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
COLUMNS = 4
TOUR = ROOT / "docs/guide/tour.md"
LARGEST, ALL_PICTURES, SCENE_LINES, SECONDS = 60_000, 900_000, 60, 60


def subject(scene):
    """The first comment, cut at its first sentence; where there is none the scene's name."""
    lines = []
    for line in scene.read_text(encoding="utf-8", errors="replace").splitlines():
        if line.startswith("#version") and not lines:
            continue
        if not line.startswith("//"):
            break
        lines.append(line.lstrip("/ ").strip())
    said = re.split(r"(?<=[.:;]) ", " ".join(lines))[0].rstrip(".:;") or scene.stem.replace("_", " ")
    return said.replace("|", "\\|").replace("<", "&lt;")


def page():
    out = ["# Gallery", "",
           "Every scene of `scenes/`, with its source. Made by `bench/gallery.py`; the pictures are POV-Ray's, which ours match (`ctest -R golden`).", ""]
    folders = {}
    for scene in sorted((ROOT / "scenes").rglob("*.pov")):
        picture = ROOT / "reference_images" / scene.relative_to(ROOT / "scenes").with_suffix(".png")
        if picture.exists():
            folders.setdefault(scene.parent.relative_to(ROOT / "scenes"), []).append((scene, picture))
    for folder, scenes in sorted(folders.items(), key=lambda item: str(item[0])):
        out += [f"## {'scenes' if str(folder) == '.' else str(folder).replace('_', ' ')}", "", "| " * COLUMNS + "|", "|---" * COLUMNS + "|"]
        for i in range(0, len(scenes), COLUMNS):
            cells = [f"![]({'../../' + str(picture.relative_to(ROOT))})<br>[{scene.stem}]({'../../' + str(scene.relative_to(ROOT))}): "
                     f"{subject(scene)}" for scene, picture in scenes[i:i + COLUMNS]]
            out.append("| " + " | ".join(cells + [""] * (COLUMNS - len(cells))) + " |")
        out.append("")
    return "\n".join(out)


def stops():
    """What the tour shows, in its order: the picture's path and the words of the command that makes it."""
    text = TOUR.read_text()
    pictures = re.findall(r"^(?:!\[\]\(|<img src=\")(tour/[^)\"]+)", text, re.M)
    commands = [shlex.split(line) for line in re.findall(r"^    (whittle .*)$", text, re.M)]
    if len(pictures) != len(commands):
        sys.exit(f"{TOUR} has {len(pictures)} pictures and {len(commands)} commands")
    return [(TOUR.parent / picture, words) for picture, words in zip(pictures, commands)]


def tour_faults():
    """What is wrong with the tour's pictures and scenes, in words."""
    found, size = [], 0
    for picture, words in stops():
        if not picture.exists():
            found.append(f"{picture} is missing: bench/gallery.py --tour {picture.stem}")
            continue
        size += picture.stat().st_size
        if picture.stat().st_size > LARGEST:
            found.append(f"{picture} has more than {LARGEST} bytes")
        for scene in (ROOT / word for word in words if word.endswith(".pov")):
            if not scene.exists() or len(scene.read_text().splitlines()) >= SCENE_LINES:
                found.append(f"{scene} is missing or has {SCENE_LINES} lines or more")
    return found + [f"the tour's pictures have more than {ALL_PICTURES} bytes together"] * (size > ALL_PICTURES)


def make_tour(names, program):
    """Runs the commands of the tour from the project's folder, and says how long each took."""
    known = {picture.stem for picture, _ in stops()}
    if set(names) - known:
        sys.exit("the tour has no " + ", ".join(sorted(set(names) - known)))
    for picture, words in stops():
        if names and picture.stem not in names:
            continue
        start = time.monotonic()
        subprocess.run([program, *words[1:], "+WT2"] if words[1] not in ("info", "compare") else [program, *words[1:]],
                       cwd=ROOT, check=True, timeout=SECONDS, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        print(f"{picture.name:24} {picture.stat().st_size:6} bytes {time.monotonic() - start:5.1f} s", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--tour", nargs="*", metavar="NAME")
    parser.add_argument("--whittle", default=ROOT / "build/release/whittle")
    options = parser.parse_args()
    if options.tour is not None:
        make_tour(options.tour, options.whittle)
        sys.exit("\n".join(tour_faults()) or 0)
    path = ROOT / "docs/guide/gallery.md"
    text = page()
    if options.check:
        if not path.exists() or path.read_text() != text:
            sys.exit(f"{path} is out of date: bench/gallery.py")
        sys.exit("\n".join(tour_faults()) or 0)
    path.write_text(text)


if __name__ == "__main__":
    main()
