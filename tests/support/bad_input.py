"""What the tests with hostile messages share: the command line, values that may be anything, bytes that are spoilt, datagrams to
the mailbox of a program, what a process holds.

A test puts the folder on its path: sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support")).
"""
import argparse
import json
import os
import random
import socket

NUMBERS = (0, 1, 2, 5, 40, -1, 2**31, 2**63, -2**63, 1e300, 0.5, None, True, False, "1", [], {})
TEXTS = ("", "x", "\0", "../x", "/etc/passwd", "a" * 3000, "file:///a", "utf-8", "\u00e4\U0001F600", "\ud800")
DEEPEST = 4


def asked(what, requests, seed=1):
    """The command line of such a test, with the path of the program whole, and a source of chance.

    what      says who is asked, for --help
    requests  how many by default"""
    parser = argparse.ArgumentParser(description=what)
    parser.add_argument("whittle")
    parser.add_argument("--requests", type=int, default=requests)
    parser.add_argument("--seed", type=int, default=seed)
    given = parser.parse_args()
    given.whittle = os.path.abspath(given.whittle)
    return given, random.Random(given.seed)


def value(rng, names, texts=TEXTS, depth=0):
    """Anything that JSON can say; objects have members of those names."""
    kind = rng.randrange(9 if depth < DEEPEST else 6)
    if kind < 3:
        return rng.choice(NUMBERS)
    if kind < 6:
        return rng.choice(texts)
    if kind == 6:
        return [value(rng, names, texts, depth + 1) for _ in range(rng.randrange(4))]
    return {rng.choice(names): value(rng, names, texts, depth + 1) for _ in range(rng.randrange(5))}


def cut_short(rng, data):
    return data[:rng.randrange(len(data) + 1)]


def mangled(rng, data, most, by=range(256)):
    """Fewer than `most` bytes of it are others."""
    out = bytearray(data)
    for _ in range(rng.randrange(1, most) if out else 0):
        out[rng.randrange(len(out))] = rng.choice(by)
    return bytes(out)


def datagrams(rng, folder, count, files):
    """To every socket in a folder: what `whittle watch` and `whittle lsp` tell each other of those files, and what they do not."""
    names = ["cursor", "show", "edit", "shown", "written", "file", "offset", "mark", "line", "column", "changes", "length", "text"]
    anything = lambda: value(rng, names)
    part = lambda made: anything() if rng.random() < 0.1 else made
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as out:
        for _ in range(count):
            change = lambda: part({"offset": part(rng.randrange(60)), "length": part(rng.randrange(5)), "text": part("1")})
            about = {"file": part(rng.choice(files)), "offset": part(rng.randrange(200)), "mark": part(rng.randrange(2**64)),
                     "line": part(rng.randrange(5)), "column": part(rng.randrange(50)), "changes": part([change(), change()])}
            data = json.dumps(part({rng.choice(names[:5]): part(about)})).encode()
            how = rng.random()
            if how < 0.1:
                data = cut_short(rng, data)
            elif how < 0.2:
                data = mangled(rng, data, 8)
            elif how < 0.25:
                data = rng.choice([b"", b"[" * 60000, b'{"a":' * 10000, b"x" * 100000, rng.randbytes(300)])
            for name in os.listdir(folder):
                out.sendto(data, os.path.join(folder, name))  # waits while its queue is full


def held(process, name):
    """kB that a process holds, by a name of /proc/PID/status: "VmRSS" now, "VmHWM" at most."""
    with open(f"/proc/{process.pid}/status") as file:
        return int(next(line for line in file if line.startswith(name)).split()[1])
