#!/usr/bin/python3
"""extending.py ROOT: the diffs that docs/extending.md shows still apply to the sources.

Of each hunk the lines that stay or go have to stand in the file in one run; a file that is made must not be there.
"""
import pathlib
import re
import sys


def hunks(page):
    """(file, made, lines that stand there before) for each hunk of the page."""
    path, made, lines = None, False, None
    for line in page.splitlines() + ["    @@"]:
        text = line[4:] if line.startswith("    ") else "" if not line.strip() else None
        if text is None or text.startswith(("@@", "--- ")):
            if lines is not None:
                yield path, made, lines
            lines = [] if text is not None and text.startswith("@@") else None
            if text is not None and text.startswith("--- "):
                made = text == "--- /dev/null"
        elif text.startswith("+++ b/") and lines is None:
            path = text[len("+++ b/"):]
        elif lines is not None and text[:1] in (" ", "-", ""):
            lines.append(text[1:])


def main():
    root = pathlib.Path(sys.argv[1])
    count, wrong = 0, []
    for path, made, lines in hunks((root / "docs/extending.md").read_text()):
        count += 1
        if made:
            if (root / path).exists():
                wrong.append(f"{path} is there already")
            continue
        while lines and not lines[-1].strip():
            lines.pop()
        text = "\n".join(line.rstrip() for line in (root / path).read_text().splitlines())
        if "\n".join(lines) not in text:
            wrong.append(f"{path} has nowhere:\n" + "\n".join(lines))
    if count < 12:
        wrong.append(f"only {count} hunks were found")
    print(f"{count} hunks")
    if wrong:
        sys.exit("\n".join(wrong))


if __name__ == "__main__":
    main()
