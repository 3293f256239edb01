#!/usr/bin/env python3
"""Asks POV-Ray again how many warnings it gives for every scene of warnings.txt and rewrites its answers. Run by hand when one
is added."""
import pathlib, re, subprocess, tempfile

def warnings(text, options):
    with tempfile.TemporaryDirectory() as folder:
        pathlib.Path(folder, "t.pov").write_text(text)
        pathlib.Path(folder, "version.inc").write_text("#version 3.7;\n")
        pathlib.Path(folder, "sphere.inc").write_text("sphere{0,1}\n")
        run = subprocess.run(["povray", "+It.pov", "-D", "-P", "-F", "+W4", "+H4", "+WT1", *options], cwd=folder,
                             capture_output=True, text=True, stdin=subprocess.DEVNULL)
    if run.returncode != 0:
        raise SystemExit("POV-Ray refuses:\n" + text)
    return len(re.findall("Parse Warning: |Possible Parse Error: ", run.stderr))

path = pathlib.Path(__file__).with_name("warnings.txt")
head, *scenes = path.read_text().split("---\n")
out = head
for scene in scenes:
    first, text = scene.split("\n", 1)
    options = first.split()[1:]
    out += "---\n" + " ".join([str(warnings(text, options)), *options]) + "\n" + text
path.write_text(out)
