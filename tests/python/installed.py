"""What `cmake --install` puts in place, moved elsewhere: the package finds its modules there."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

try:
    import numpy  # noqa: F401
except ImportError:
    sys.exit(77)
import whittle

source = pathlib.Path(os.environ["WHITTLE_SOURCE"])
built = pathlib.Path(whittle._whittle.__file__).resolve().parents[2]
if not (built / "whittle_tools").exists() or not shutil.which("cmake"):
    sys.exit(77)  # only some of it is built
clean = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    subprocess.run(
        ["cmake", "--install", built, "--prefix", folder / "first"], check=True, stdout=subprocess.DEVNULL, env=clean
    )
    (folder / "first").rename(folder / "second")
    scene = str(source / "scenes/csg/bite.pov")
    subprocess.run(
        [
            sys.executable,
            "-c",
            "import sys, whittle; whittle.render(sys.argv[1], width=80, height=60).save(sys.argv[2])",
            scene,
            str(folder / "python.png"),
        ],
        check=True,
        env={**clean, "PYTHONPATH": str(folder / "second/lib/python3/dist-packages")},
    )
    program = folder / "second/bin/whittle"
    subprocess.run(
        [program, scene, "+W80", "+H60", f"Output_File_Name={folder / 'program.png'}"], check=True, capture_output=True
    )
    assert (folder / "python.png").read_bytes() == (folder / "program.png").read_bytes()
