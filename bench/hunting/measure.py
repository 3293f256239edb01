"""Runs both programs over a scene of the hunt: processor seconds of whole runs, peak memory, and what a profile names."""
import re
import subprocess

import scenes
import speed

from hunting import compose

SMALL, LARGE = (160, 120), (320, 240)
QUICK = 0.1  # POV-Ray's seconds that a scene has to take


class Program:
    """One of the two: how it is called, and what it took."""

    def __init__(self, name, command):
        self.name, self.command = name, command

    def line(self, file, size, options):
        return [self.command, f"+I{file}", f"+O{file}.{self.name}.png", f"+W{size[0]}", f"+H{size[1]}", "-A", "-D", "-P", "+FN8", "+WT1", *options]

    def run(self, folder, file, size, options, limit):
        """At most `limit` processor seconds, and ten times as long by the wall."""
        return speed.execute(["prlimit", f"--cpu={limit:.0f}", "--", *self.line(file, size, options)], folder, 10 * limit)


def programs(options):
    return Program("povray", options.povray), Program("whittle", options.whittle)


def prepare(folder):
    """The picture files that scenes name."""
    folder.mkdir(parents=True, exist_ok=True)
    scenes.write_companions(folder)


def overlong(failure):
    """Whether a program was ended for its time: by SIGXCPU, or SIGKILL."""
    return any(end in str(failure) for end in ("exit status -24", "exit status -9", "ended after"))


def failed(failure):
    """The end of what was said, in a line."""
    if overlong(failure):
        return "does not end in time"
    said = [line.strip() for line in str(failure).splitlines() if line.strip()]
    wrong = [line for line in said if re.search("error", line, re.I)] or said[-1:]
    return wrong[0][-300:]


def measured(options, folder, kind, seed):
    """What the log keeps of a scene. A small picture tells first whether it is worth a large one."""
    povray, whittle = programs(options)
    file = f"{kind.replace(':', '_').replace('+', '_')}_{seed}.pov"
    row = {"class": kind, "seed": seed}
    try:
        text, more = compose.text(kind, seed)
    except compose.TooLarge:
        return row | {"state": "endless"}
    (folder / file).write_text(text)
    try:
        return row | both(options, folder, file, more.split(), povray, whittle)
    finally:
        if not options.keep:
            for left in folder.glob(f"{file}*"):
                left.unlink()


def both(options, folder, file, more, povray, whittle):
    if options.haste:
        try:
            if whittle.run(folder, file, LARGE, more, options.limit).cpu < QUICK / options.haste:
                return {"state": "fast"}
        except speed.Failure:
            pass  # POV-Ray tells whether it is a scene at all
    try:
        small = povray.run(folder, file, SMALL, more, options.limit / 3)
    except speed.Failure as failure:
        return {"state": "long"} if overlong(failure) else {"state": "refused", "why": failed(failure)}
    try:
        ours = whittle.run(folder, file, SMALL, more, options.limit)
    except speed.Failure as failure:
        return {"state": "fault", "why": failed(failure), "povray_s": round(small.cpu, 3)}
    pictures = [str(folder / f"{file}.{program.name}.png") for program in (povray, whittle)]
    try:
        agree = speed.agreement(whittle.command, *pictures)[0]
    except speed.Failure:
        agree = None
    if small.cpu < QUICK / 2 and ours.cpu < QUICK / 2:
        return {"state": "quick"}
    if not options.full and small.cpu > QUICK and small.cpu / ours.cpu >= options.enough and ours.memory <= small.memory + 2**25:
        return numbers("small", small, ours, agree)
    try:
        theirs = povray.run(folder, file, LARGE, more, options.limit)
    except speed.Failure:
        return {"state": "long"}
    if theirs.cpu < QUICK:
        return {"state": "quick"}
    try:
        return numbers("large", theirs, whittle.run(folder, file, LARGE, more, options.limit), agree)
    except speed.Failure as failure:
        return {"state": "fault", "why": failed(failure), "povray_s": round(theirs.cpu, 3)}


def numbers(size, theirs, ours, agree):
    megabytes = lambda run: round(run.memory / 2**20, 1)
    return dict(state="counts", size=size, povray_s=round(theirs.cpu, 3), whittle_s=round(ours.cpu, 3), ratio=round(theirs.cpu / max(ours.cpu, 1e-3), 2),
                povray_mb=megabytes(theirs), whittle_mb=megabytes(ours), agree=agree and round(agree, 4))


def readable(name):
    """A function's name without its arguments; of what a variant calls, the type at its place."""
    if "__gen_vtable_impl" in name:
        visitor, types, place = re.search(r"\(\*\)\(([\w:]+)", name), re.search(r"std::variant<(.*?)>", name), re.search(r"(\d+)ul>", name)
        if visitor and types and place:
            return f"{visitor[1]} of {types[1].split(', ')[int(place[1])] if int(place[1]) < types[1].count(',') + 1 else place[1]}"
    name = name.replace("(anonymous namespace)::", "")
    while (shorter := re.sub(r"<[^<>]*>|\([^()]*\)", "", name)) != name:
        name = shorter
    return name[:100]


def profile(options, folder, kind, seed):
    """The three functions in which Whittle is longest, each with its share."""
    text, more = compose.text(kind, seed)
    (folder / "profiled.pov").write_text(text)
    _, whittle = programs(options)
    data = folder / "profiled.data"
    try:
        speed.execute(["perf", "record", "-q", "-o", str(data), *whittle.line("profiled.pov", LARGE, more.split())], folder, 2 * options.limit)
    except speed.Failure as failure:
        return [failed(failure)]
    said = subprocess.run(["perf", "report", "-i", str(data), "--no-children", "--sort", "symbol", "--stdio", "--percent-limit", "1"], stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL, text=True, check=False).stdout
    found = re.findall(r"^\s+([0-9.]+)%\s+\[.\]\s+(.*?)\s{2,}", said + "\n", re.M)
    return [f"{share}% {readable(name)}" for share, name in found[:3]]
