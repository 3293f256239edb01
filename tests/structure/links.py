#!/usr/bin/python3
"""Links of pages lead somewhere, and the sources that pages name exist.

usage: links.py [ROOT]

A name of a source in backquotes may be a path from the root or from the page's folder, or the end of a path. History stands as it was
written, and pages about POV-Ray name files of POV-Ray's.
"""
import os
import pathlib
import re
import sys

LINK = re.compile(r"\]\(([^)#\s]*)(#[^)\s]*)?\)")
NAMED = re.compile(r"`([\w./-]+\.(?:h|cpp|py|inc|cmake|md))`")
LEFT_OUT = ("docs/history/", "docs/povray/", "CHANGELOG.md")
OF_POVRAY = {"colors.inc", "functions.inc", "math.inc", "rand.inc", "shapes.inc", "stones.inc", "textures.inc", "transforms.inc"}


def anchors(text):
    """The names by which headings are linked."""
    return {re.sub(r"[^a-z0-9 _-]", "", line.lower()).strip().replace(" ", "-") for line in re.findall(r"^#+ (.*)$", text, re.M)}


def faults(page, text, texts, files):
    """What is wrong with a page; texts: of all pages by path, files: paths of all sources."""
    folder = os.path.dirname(page)
    for link, anchor in LINK.findall(text):
        if link.startswith(("http:", "https:", "mailto:")):
            continue
        target = os.path.normpath(os.path.join(folder, link)) if link else page
        if target not in files and not any(name.startswith(target + "/") for name in files):
            yield f"{page}: the link to {link} leads nowhere"
        elif anchor and target in texts and anchor[1:] not in anchors(texts[target]):
            yield f"{page}: {target} has no heading {anchor}"
    for name in NAMED.findall(text):
        at_end = "/" + name.lstrip("./")
        if name not in files and name not in OF_POVRAY and not any(("/" + path).endswith(at_end) for path in files):
            yield f"{page}: there is no {name}"


def main():
    probe = "[a](b.md) [c](d.md#e-f) `g.h` `h/g.h` [x](y.md) [z](d.md#no) `no.h` `x/g.h`"
    texts = {"p.md": probe, "b.md": "", "d.md": "# E f\n"}
    if len(list(faults("p.md", probe, texts, {*texts, "h/g.h"}))) != 4:
        sys.exit("links.py finds wrongly")
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[2]).resolve()
    paths = [path.relative_to(root) for folder in root.iterdir() if folder.name not in {".git", "build"} for path in (folder, *folder.rglob("*"))]
    files = {str(path) for path in paths if (root / path).is_file()}
    texts = {name: (root / name).read_text() for name in sorted(files) if name.endswith(".md")}
    wrong = [fault for page, text in texts.items() if not page.startswith(LEFT_OUT) for fault in faults(page, text, texts, files)]
    print(*wrong, f"{len(texts)} pages, {len(wrong)} faults", sep="\n")
    return 1 if wrong or len(texts) < 100 else 0


if __name__ == "__main__":
    sys.exit(main())
