#!/usr/bin/python3
"""docs/guide/gallery.md: every scene of scenes/ with its picture, source and first comment.

usage: gallery.py [--check]

The pictures are those of reference_images, which POV-Ray made and Whittle's match (ctest -R golden). --check changes
nothing and says by its exit status whether the page is up to date.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
COLUMNS = 4


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


def main():
    path = ROOT / "docs/guide/gallery.md"
    text = page()
    if "--check" in sys.argv[1:]:
        sys.exit(0 if path.exists() and path.read_text() == text else f"{path} is out of date: bench/gallery.py")
    path.write_text(text)


if __name__ == "__main__":
    main()
