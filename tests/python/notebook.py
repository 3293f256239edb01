"""Runs docs/guide/python.ipynb as `jupyter nbconvert` does and looks at what its cells show; its pictures are left in the
folder of the test."""

import base64
import json
import os
import pathlib
import shutil
import struct
import subprocess
import sys

if not shutil.which("jupyter-nbconvert"):
    sys.exit(77)
try:
    import ipykernel  # noqa: F401
    import numpy  # noqa: F401
except ImportError:
    sys.exit(77)

folder = pathlib.Path.cwd() / "notebook"
folder.mkdir(exist_ok=True)
notebook = pathlib.Path(os.environ["WHITTLE_SOURCE"]) / "docs/guide/python.ipynb"
told = json.loads(notebook.read_text())
assert not any(cell.get("outputs") for cell in told["cells"]), "the notebook is kept without outputs"
command = ["jupyter-nbconvert", "--execute", "--to", "notebook", "--output-dir", folder, "--output", "run", notebook]
subprocess.run([str(word) for word in command], check=True, timeout=110, env={**os.environ, "IPYTHONDIR": str(folder)})
cells = [c for c in json.loads((folder / "run.ipynb").read_text())["cells"] if c["cell_type"] == "code"]

sizes, texts, gone = [], [], 0
for cell in cells:
    for output in cell["outputs"]:
        assert output["output_type"] != "error", output
        data = output.get("data", {})
        texts.append("".join(output.get("text", "")))
        gone += "text/html" in data and "".join(data["text/html"]) == ""
        if "image/png" not in data:
            continue
        png = base64.b64decode(data["image/png"])
        sizes.append(struct.unpack(">II", png[16:24]))
        (folder / f"{len(sizes)}.png").write_bytes(png)
print(sizes, gone, texts)
assert sizes == [(400, 300), (240, 180), (240, 180), (240, 180), (320, 240), (240, 220), (480, 360)], sizes
text = "".join(texts)
assert "(240, 320, 3) float32" in text and "volume" in text, text
assert "line 2, column 1: " in text and "did you mean 'sphere'" in text, text
