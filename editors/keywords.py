#!/usr/bin/python3
"""Writes the reserved words of the language into the editors' files that colour by themselves.

usage: keywords.py [--check]
"""
import json
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
GRAMMAR = ROOT / "editors/vscode/syntaxes/pov.tmLanguage.json"
MODE = ROOT / "editors/emacs/pov-scene-mode.el"
DIRECTIVES = ("break case debug declare default else elseif end error fclose fopen for if ifdef ifndef include local macro range read "
              "render statistics switch undef version warning while write").split()


def reserved():
    text = (ROOT / "parser/lexer/keywords.inc").read_text()
    words = re.findall(r'^WHITTLE_(?:NEW_)?(?:KEYWORD|SPELLING)\("(\w+)", \w+(?:, (\w+))?\)', text, re.M)
    return sorted(word for word, _ in words), sorted(word for word, kind in words if kind in ("Float", "String", "Vector", "Vector4"))


def grammar(words, functions):
    """TextMate's form: comments nest, a text goes over lines, directives begin with '#'."""
    plain = sorted(set(words) - set(functions))
    return {
        "name": "POV-Ray scene", "scopeName": "source.pov", "fileTypes": ["pov", "inc"],
        "patterns": [{"include": "#" + name} for name in ("comment", "line_comment", "text", "directive", "number", "function", "word", "call",
                                                          "name", "operator")],
        "repository": {
            "comment": {"name": "comment.block.pov", "begin": r"/\*", "end": r"\*/", "patterns": [{"include": "#comment"}]},
            "line_comment": {"name": "comment.line.double-slash.pov", "match": "//.*$"},
            "text": {"name": "string.quoted.double.pov", "begin": "\"", "end": "\"",
                     "patterns": [{"name": "constant.character.escape.pov", "match": r"\\."}]},
            "directive": {"name": "keyword.control.directive.pov", "match": rf"#\s*(?:{'|'.join(DIRECTIVES)})\b"},
            "number": {"name": "constant.numeric.pov", "match": r"(?<![A-Za-z0-9_])(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?"},
            "function": {"name": "support.function.pov", "match": rf"\b(?:{'|'.join(functions)})\b"},
            "word": {"name": "keyword.other.pov", "match": rf"\b(?:{'|'.join(plain)})\b"},
            "call": {"name": "entity.name.function.pov", "match": r"\b[A-Za-z_][A-Za-z0-9_]*(?=\s*\()"},
            "name": {"name": "variable.other.pov", "match": r"\b[A-Za-z_][A-Za-z0-9_]*\b"},
            "operator": {"name": "keyword.operator.pov", "match": r"[-+*/=<>!&|?:]"},
        },
    }


def lisp_list(name, words):
    lines, line = [], "   "
    for word in words:
        if len(line) + len(word) + 3 > 100:
            lines.append(line)
            line = "   "
        line += f' "{word}"'
    return f"(defconst {name}\n  '(\n" + "\n".join(lines + [line]) + "))\n"


def mode(text, words, functions):
    plain = sorted(set(words) - set(functions))
    made = (lisp_list("pov-scene-directives", DIRECTIVES) + "\n" + lisp_list("pov-scene-functions", functions) + "\n" +
            lisp_list("pov-scene-words", plain))
    begin, end = ";; begin of words (keywords.py)\n", ";; end of words\n"
    return text[:text.index(begin) + len(begin)] + made + text[text.index(end):]


def main():
    words, functions = reserved()
    if len(words) < 400 or len(functions) < 50:
        sys.exit("keywords.py: too few words in keywords.inc")
    made = {GRAMMAR: json.dumps(grammar(words, functions), indent=1) + "\n", MODE: mode(MODE.read_text(), words, functions)}
    other = [path for path, text in made.items() if not path.exists() or path.read_text() != text]
    if "--check" in sys.argv[1:]:
        for path in other:
            print(f"{path.relative_to(ROOT)} is not what editors/keywords.py makes")
        return 1 if other else 0
    for path in other:
        path.write_text(made[path])
    return 0


if __name__ == "__main__":
    sys.exit(main())
