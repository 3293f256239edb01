#!/usr/bin/python3
"""Whether every citation of docs/povray names a chapter and a section that exist.

usage: citations.py [ROOT]

docs/povray/README.md says how a citation is written. Looked at are all texts of the repository; a citation may go on in the
comment's next line. Within the chapters, "section 7.4" is of the same chapter, "chapter 3, 7.4" of another. Links between
headings and the names of data files are looked up as well.
"""
import pathlib
import re
import sys

CHAPTERS = "docs/povray"
TEXTS = {".h", ".cpp", ".inc", ".pov", ".ini", ".py", ".cmake", ".md", ".txt", ".csv"}
SKIPPED = {".git", "build", "__pycache__"}

NUMBER = r"\d+(?:\.\d+)*"
SECTIONS = rf"(?:sections? )?{NUMBER}(?:(?:, | and | to ){NUMBER}\b)*"
CHAPTER = r"\d[a-d]?"
BEGIN = re.compile(r"\b[Ss]pec (?=\d|chapter|section|of the)")
CITATION = re.compile(rf"({CHAPTER})(?:, ({SECTIONS}))?(?=[^\w.]|\.\W|\.?$)(?!,? \d)")
MORE = re.compile(rf"; (\d\w?), ({SECTIONS})")  # (spec 4, 12.6; 5b, 10.1)
ELSEWHERE = re.compile(rf"\b[Cc]hapter 0?({CHAPTER}),? (?:section )?({NUMBER})")
SAME = re.compile(rf"(?<!anual )\b[Ss]ections? ({NUMBER}(?:(?:, | and | to ){NUMBER})*)(?! of)")
DATA = re.compile(r"`(data/[\w./-]+\.\w+|0\d[a-d]?-[\w-]+\.(?:csv|txt)|tests/[\w./-]+\.\w+)`")
MARGIN = re.compile(r"\n[ \t]*(?:///?<?|#|\*|//)?[ \t]*")  # the end of a line and what a comment begins the next one with


def headings(text):
    """The numbers of a chapter's headings, "7.4" of "### 7.4 The light loop"."""
    return set(re.findall(rf"^#{{2,5}} ({NUMBER})\b", text, re.M))


def anchors(text):
    """The anchors that a heading is linked by."""
    titles = re.findall(r"^#{1,5} (.+)$", text, re.M)
    return {re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in titles}


def read_chapters(folder):
    """{"5a": text} of the files 05a-solids-and-csg.md."""
    named = ((re.match(r"0(\d[a-d]?)-", path.name), path) for path in sorted(folder.glob("*.md")))
    return {found.group(1): path.read_text() for found, path in named if found}


def joined(text):
    """The text with the lines of comments put together, and the line that each character of it comes from."""
    out, lines, line, last = [], [], 1, 0
    for end in MARGIN.finditer(text):
        piece = text[last:end.start()] + " "
        out.append(piece)
        lines += [line] * len(piece)
        line, last = line + 1, end.end()
    out.append(text[last:])
    lines += [line] * (len(text) - last + 1)
    return "".join(out), lines


def missing(sections, chapter, numbers):
    """What a list of sections names that is not among the chapter's headings."""
    if chapter not in numbers:
        return [f"there is no chapter {chapter}"]
    return [f"chapter {chapter} has no section {number}"
            for number in re.findall(NUMBER, sections or "") if number not in numbers[chapter]]


def complaints(text, numbers):
    """(line, what is wrong) of every citation of a text; and how many citations it has."""
    flat, lines = joined(text)
    found, count = [], 0
    for begin in BEGIN.finditer(flat):
        line = lines[begin.start()]
        citation = CITATION.match(flat, begin.end())
        count += 1
        if not citation:
            found.append((line, f"not the form of a citation: {flat[begin.start():begin.end() + 30]}"))
            continue
        wrong = missing(citation.group(2), citation.group(1), numbers)
        at = citation.end()
        while more := MORE.match(flat, at):
            wrong += missing(more.group(2), more.group(1), numbers)
            at = more.end()
        found += [(line, text) for text in wrong]
    return found, count


def chapter_complaints(name, text, numbers, root):
    """What a chapter says of itself and of the others that does not exist."""
    own = anchors(text)
    for number, line in enumerate(text.split("\n"), 1):
        wrong = []
        for link in re.findall(r"\]\(#([^)]+)\)", line):
            if link not in own:
                wrong.append(f"no heading for the link #{link}")
        for other in ELSEWHERE.finditer(line):
            wrong += missing(other.group(2), other.group(1), numbers)
        for same in SAME.finditer(ELSEWHERE.sub("", line)):
            wrong += missing(same.group(1), name, numbers)
        for file in DATA.findall(line):
            if not any((folder / file).is_file() for folder in (root, root / CHAPTERS, root / CHAPTERS / "data")):
                wrong.append(f"there is no file {file}")
        yield from ((number, each) for each in wrong)


def texts(root):
    for path in sorted(root.rglob("*")):
        inside = path.relative_to(root)
        if SKIPPED & set(inside.parts) or inside.parts[:2] == ("docs", "povray") and path.suffix == ".csv":
            continue
        if path.is_file() and (path.suffix in TEXTS or not path.suffix):
            try:
                yield inside, path.read_text()
            except UnicodeDecodeError:
                continue  # a program, or a scene in another encoding


def check_forms():
    """The forms of README.md, right and wrong, against two small chapters."""
    numbers = {"1": {"7", "7.4", "9", "9.5"}, "5b": {"1", "1.1", "3"}}
    right = ["(spec 1, 7.4)", "spec 1, 7.4 and 9.5.", "(spec 1, 7 to 9)", "// spec 1, sections 7 and 9", "(spec 1, 7.4; 5b, 1.1)",
             "(spec 1,\n    /// 7.4)", "# Spec 5b, 3: so", "(spec 1)", "(spec 1, 7, its third step)", "spec 1, 9, and so on",
             "(spec 1, 9.5; spec 5b, 3)", "spec 1, 7.4"]
    wrong = ["(spec 2, 7)", "(spec 1, 7.5)", "(spec 1, 7.4 and 7.5)", "(spec 1, 7.4; 5b, 2)", "(spec 1,\n  // 8)", "(spec 1, 7 to 8)",
             "(spec 1 7.4)", "spec of the language 7", "(spec 1, 7, 8)", "spec chapter 1", "(spec 1, 7.4; 5c, 2)", "(spec 12, 7)",
             "(spec 1, 7.4.)\n (spec 1, 11)"]
    for text in right + wrong:
        found, count = complaints(text, numbers)
        if bool(found) != (text in wrong) or not count:
            sys.exit(f"citations.py: {text!r} gives {found}")


def main():
    check_forms()
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[2]).resolve()
    chapters = read_chapters(root / CHAPTERS)
    numbers = {name: headings(text) for name, text in chapters.items()}
    bad = total = 0
    for inside, text in texts(root):
        if inside.name == pathlib.Path(__file__).name:
            continue  # its own wrong forms
        found, count = complaints(text, numbers)
        total += count
        if inside.parent == pathlib.Path(CHAPTERS) and (name := re.match(r"0(\d[a-d]?)-", inside.name)):
            found = found + list(chapter_complaints(name.group(1), text, numbers, root))
        for line, why in found:
            print(f"{inside}:{line}: {why}")
        bad += len(found)
    print(f"{total} citations of {len(chapters)} chapters with {sum(map(len, numbers.values()))} sections, {bad} wrong")
    return 1 if bad or total < 200 or len(chapters) < 7 else 0


if __name__ == "__main__":
    sys.exit(main())
