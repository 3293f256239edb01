"""Runs a scene through either program and compares what comes out."""
import pathlib
import re
import shlex
import subprocess

import png

TOLERANCE = 3       # of 255, in every channel
AGREE = 0.99        # of the pixels: what a scene has to reach
TIME_LIMIT = 240    # seconds for one picture of a few thousand pixels


class Result:
    """What one program made of a scene: a picture, or the reason why there is none; and what the scene printed."""

    def __init__(self, rows, error, printed):
        self.rows, self.error, self.printed = rows, error, printed


def render(program, folder, scene, size, tag, limit=TIME_LIMIT):
    """Renders folder/scene at `size` (width, height) within `limit` seconds; files carry `tag`. Paths are relative so that printed text has none."""
    picture, printed = pathlib.Path(f"{scene}.{tag}.png"), pathlib.Path(f"{scene}.{tag}.txt")
    for left in (folder / picture, folder / printed):
        left.unlink(missing_ok=True)
    command = [*shlex.split(program), f"+I{scene}.pov", f"+O{picture}", f"+W{size[0]}", f"+H{size[1]}", "-A", "-D", "-P", "+WT1", "+FN8",
               "-GR", "-GS", f"+GD{printed}"]
    try:
        done = subprocess.run(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              timeout=limit)
    except subprocess.TimeoutExpired:
        return Result(None, f"no picture after {limit} s", "")
    said = done.stdout.decode("latin1")
    text = (folder / printed).read_text("latin1") if (folder / printed).exists() else ""
    if done.returncode < 0:
        return Result(None, f"killed by signal {-done.returncode}", text)
    if done.returncode or not (folder / picture).exists():
        wrong = [line for line in said.splitlines() if re.search("error:|error in", line, re.I)]
        return Result(None, wrong[0] if wrong else f"exit status {done.returncode}: {said[-300:]}", text)
    return Result(png.read(folder / picture)[2], "", text)


def alike(ours, theirs, x):
    """Whether the pixel whose channels begin at x differs by at most TOLERANCE in each, in two rows."""
    return all(abs(ours[x + i] - theirs[x + i]) <= TOLERANCE for i in range(3))


def agreement(ours, theirs):
    """The share of pixels that are alike."""
    agreeing = pixels = 0
    for a, b in zip(ours, theirs):
        agreeing += len(a) // 3 if a == b else sum(alike(a, b, x) for x in range(0, len(a), 3))
        pixels += len(a) // 3
    return agreeing / pixels


def same_text(ours, theirs):
    """Whether both printed the same; POV-Ray breaks what it prints at 80 columns, so white space is not compared, and of a text of more
    than 200 characters it prints 156 and three dots (docs/povray/01, 10.5), for 40 characters or more of ours."""
    mine, other = ("".join(one.printed.split()) for one in (ours, theirs))
    cut = ".{40,}?".join(re.escape(part) for part in other.split("..."))
    return mine == other or ("..." in other and re.fullmatch(cut, mine, re.S) is not None)


def verdict(ours, theirs):
    """(state, detail): state is 'agree', 'differ', 'refused' (by both: the generator's fault, or a crash of POV-Ray's), or
    'fault' (one alone has none)."""
    if "signal" in theirs.error and not ours.error:
        return "refused", f"povray: {theirs.error}"
    if ours.error and theirs.error:
        crashed = "signal" in ours.error or "no picture after" in ours.error
        return ("fault" if crashed else "refused"), f"whittle: {ours.error} | povray: {theirs.error}"
    if ours.error or theirs.error:
        return "fault", f"whittle: {ours.error or 'renders it'} | povray: {theirs.error or 'renders it'}"
    if not same_text(ours, theirs):
        pairs = zip(ours.printed.splitlines() + [""], theirs.printed.splitlines() + [""])
        first = next((pair for pair in pairs if pair[0] != pair[1]), ("", ""))
        return "differ", f"prints '{first[0]}', povray '{first[1]}'"
    share = agreement(ours.rows, theirs.rows)
    return ("agree" if share >= AGREE else "differ"), f"{share:.4f}"
