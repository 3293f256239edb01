#!/usr/bin/env python3
"""Asks POV-Ray again what it does with every scene of language.txt and rewrites its answers. Run by hand when one is added."""
import pathlib, re, subprocess, tempfile

PROLOGUE = "#version 3.7; global_settings{assumed_gamma 1} sphere{0,1}\n"

def answer(text, raw):
    with tempfile.TemporaryDirectory() as folder:
        pathlib.Path(folder, "t.pov").write_text(text if raw else PROLOGUE + text)
        run = subprocess.run(["povray", "+It.pov", "-D", "-P", "-F", "+W4", "+H4", "+WT1", "+GDdebug.txt"], cwd=folder,
                             capture_output=True, text=True, stdin=subprocess.DEVNULL)
        debug = pathlib.Path(folder, "debug.txt")
        said = debug.read_text().rstrip("\n") if debug.exists() else ""
    if run.returncode == 0:
        return "accept", said
    place = re.search(r"File '[^']*' line (\d+): Parse Error", run.stderr)
    line = int(place.group(1)) - (0 if raw else 1) if place else 0
    return ("reject" + (f" {line}" if line > 0 else "")), ""

path = pathlib.Path(__file__).with_name("language.txt")
head, *scenes = path.read_text().split("---\n")
out = head
for scene in scenes:
    verdict, *lines = scene.rstrip("\n").split("\n")
    raw = verdict.startswith("raw ")
    text = "\n".join(line for line in lines if not line.startswith("> "))
    verdict, said = answer(text, raw)
    out += "---\n" + ("raw " if raw else "") + verdict + "\n" + text + "\n"
    out += "".join(f"> {line}\n" for line in said.split("\n")) if said else ""
path.write_text(out)
