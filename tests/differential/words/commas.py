"""Commas that the manual calls optional: where they stand in a text, and the text without some of them."""
import re

# Arguments of these are told apart by commas alone.
STRICT = {"min", "max", "bitwise_and", "bitwise_or", "bitwise_xor", "select"}
TOKEN = re.compile(r'"(?:\\.|[^"\\])*"|//[^\n]*|/\*.*?\*/|[A-Za-z_]\w*|[(){}\[\],]', re.S)


def places(text):
    """Where commas stand that may be left out, and where none may: before a sign, in a formula, in a list of STRICT."""
    free, bound, opened, word = [], [], [], ""
    for found in TOKEN.finditer(text):
        token = found.group()
        if token[0] in "({[":
            within = opened[-1] if opened else False
            opened.append(within or word in STRICT or (token == "{" and word == "function"))
        elif token[0] in ")}]" and opened:
            opened.pop()
            # `function (a, b) { ... }`
            word = "function" if token == ")" and re.match(r"\s*\{", text[found.end():]) else ""
            continue
        elif token == ",":
            signed = re.match(r"\s*[-+#]", text[found.end():])
            (bound if signed or (opened and opened[-1]) else free).append(found.start())
        word = token if token[0].isalpha() or token[0] == "_" else ""
    return free, bound


def without(r, text, most=8):
    """The text without 1 to `most` of its commas; seldom one of them is of those that count."""
    free, bound = places(text)
    gone = r.few(min(1, len(free)), most, free)
    if bound and r.chance(.12):
        gone.append(r.pick(*bound))
    for at in sorted(gone, reverse=True):
        text = text[:at] + " " + text[at + 1:]
    return text
