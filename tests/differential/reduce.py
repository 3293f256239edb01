"""Makes a scene on which the programs differ as short as it can: takes pieces of text away while they still differ."""
import concurrent.futures
import pathlib
import re
import tempfile

import programs
import scenes

TOKEN = re.compile(r'"[^"\n]*"|<[^<>{}]*>|#\w+|[A-Za-z_]\w*|\d+\.?\d*(?:e-?\d+)?|\.\d+|[{}()<>\[\],;]|[^\s\w]')
CLOSING = {"{": "}", "(": ")", "[": "]"}


def balanced(tokens):
    """Whether a run of tokens closes what it opens and no more."""
    open_ones = []
    for token in tokens:
        if token in CLOSING:
            open_ones.append(CLOSING[token])
        elif token in CLOSING.values() and (not open_ones or open_ones.pop() != token):
            return False
    return not open_ones


def whole(tokens, begin, end):
    """Whether a run is one item or several: it begins with a word, another word or a bracket follows, and it is balanced.
    So numbers and vectors keep their meaning, and what is left shows the fault that was looked for."""
    starts = lambda token: token[0].isalpha() or token[0] in "#_"
    return starts(tokens[begin]) and (end == len(tokens) or starts(tokens[end]) or tokens[end] in "}])") and balanced(tokens[begin:end])


def pieces(tokens):
    """Runs that may be taken away, (begin, end), the longest first: halves, quarters ... and each `word { ... }`."""
    found = set()
    depth, opened = 0, []
    for at, token in enumerate(tokens):
        if token == "{":
            opened.append(at)
        elif token == "}" and opened:
            begin = opened.pop()
            found.add((max(begin - 1, 0), at + 1))
    length = max(len(tokens) // 2, 1)
    while True:
        step = max(length // 2, 1)
        for begin in range(0, len(tokens) - length + 1, step):
            if whole(tokens, begin, begin + length):
                found.add((begin, begin + length))
        if length == 1:
            break
        length = length // 2 if length > 16 else length - 1
    return sorted(found, key=lambda piece: (piece[0] - piece[1], piece))


def differs(options, folder, number, tokens, wanted):
    """Whether the programs still disagree in the same way: `wanted` is the state, and both pictures where both had one."""
    name = f"try_{number}"
    (folder / f"{name}.pov").write_text(" ".join(tokens) + "\n")
    ours = programs.render(options.whittle, folder, name, (80, 60), "whittle")
    if bool(ours.error) != wanted[1]:
        return False
    theirs = programs.render(options.povray, folder, name, (80, 60), "povray")
    if bool(theirs.error) != wanted[2]:
        return False
    return programs.verdict(ours, theirs)[0] == wanted[0]


def reduce(options):
    tokens = TOKEN.findall(re.sub(r"//[^\n]*", "", options.scene.read_text()))
    with tempfile.TemporaryDirectory() as temporary, concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        folder = pathlib.Path(temporary)
        scenes.write_companions(folder)
        (folder / "whole.pov").write_text(" ".join(tokens) + "\n")
        ours = programs.render(options.whittle, folder, "whole", (80, 60), "whittle")
        theirs = programs.render(options.povray, folder, "whole", (80, 60), "povray")
        wanted = (programs.verdict(ours, theirs)[0], bool(ours.error), bool(theirs.error))
        if wanted[0] not in ("differ", "fault"):
            print("the programs agree on this scene")
            return 1
        number, shorter = 0, True
        while shorter:
            shorter, todo = False, pieces(tokens)
            while todo:
                batch, todo = todo[:options.jobs], todo[options.jobs:]
                tries = [tokens[:begin] + tokens[end:] for begin, end in batch]
                answers = list(pool.map(lambda k: differs(options, folder, number + k, tries[k], wanted), range(len(batch))))
                number += len(batch)
                for left in folder.glob("try_*"):
                    left.unlink()
                if any(answers):
                    taken = answers.index(True)
                    begin, end = batch[taken]
                    tokens, shorter = tries[taken], True
                    todo = [(b - (end - begin if b >= end else 0), e - (end - begin if b >= end else 0))
                            for b, e in batch[taken + 1:] + todo if e <= begin or b >= end]
        print(" ".join(tokens))
    return 0
