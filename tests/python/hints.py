"""Type hints hold: the package by itself, and a program that uses it wrongly is told where."""

import os
import pathlib
import subprocess
import sys
import tempfile

try:
    import mypy.api  # noqa: F401
except ImportError:
    sys.exit(77)

PROGRAM = """import whittle
from typing import List
picture = whittle.render("sphere { 0, 1 }", width=8, height=6, Radius=2)
brightest: float = float(picture.linear.max())
meshes: List[whittle.Mesh] = whittle.Scene("sphere { 0, 1 }").mesh(0.1)
whittle.render("sphere { 0, 1 }", width="wide")  # arg-type
picture.pixel  # attr-defined
whittle.Scene("sphere { 0, 1 }").section(2, 0.5)  # arg-type
answer: str = whittle.compare("a.png", "b.png").flip  # assignment
"""
WRONG = {(number, line.split("# ")[1]) for number, line in enumerate(PROGRAM.split("\n"), 1) if "# " in line}

with tempfile.TemporaryDirectory() as folder:
    program = pathlib.Path(folder, "program.py")
    program.write_text(PROGRAM)

    def told(*words: str) -> "list[str]":
        strict = [sys.executable, "-m", "mypy", "--strict", "--no-warn-unused-ignores", "--show-error-codes"]
        run = subprocess.run([*strict, "--no-error-summary", "--cache-dir", folder, *words], capture_output=True, text=True,
                             cwd=os.environ["PYTHONPATH"])
        return run.stdout.splitlines()

    package = told("-p", "whittle")
    mistakes = [line for line in told(str(program)) if ": error:" in line]
found = {(int(line.split(":")[1]), line.rsplit("[", 1)[1].rstrip("]")) for line in mistakes}
print("\n".join(package + mistakes))
print("wanted:", sorted(WRONG))
sys.exit(package != [] or found != WRONG)
