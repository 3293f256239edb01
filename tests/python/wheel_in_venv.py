"""A wheel made from the tree, installed into a venv of its own, renders there what the command line renders here."""

import os
import pathlib
import subprocess
import sys
import tempfile

try:
    import numpy  # noqa: F401
    import setuptools  # noqa: F401
    import venv
    import wheel  # noqa: F401
    import pip  # noqa: F401
    import ensurepip  # noqa: F401
except ImportError:
    sys.exit(77)
import whittle

source = pathlib.Path(os.environ["WHITTLE_SOURCE"])
built = pathlib.Path(whittle._whittle.__file__).resolve().parents[2]
clean = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
scene = str(source / "scenes/csg/bite.pov")
with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    quiet = ["--quiet", "--disable-pip-version-check", "--no-deps", "--no-index"]
    subprocess.run(
        [sys.executable, "-m", "pip", "wheel", *quiet, "--no-build-isolation", "-w", str(folder), str(source)],
        check=True,
        env={**clean, "WHITTLE_BUILD": str(built)},
    )
    [made] = folder.glob("whittle-*.whl")
    print(made.name, made.stat().st_size >> 20, "MB")
    assert "none-any" not in made.name, made.name
    venv.create(folder / "venv", system_site_packages=True, with_pip=False)
    python = str(folder / "venv/bin/python3")
    subprocess.run([python, "-m", "pip", "install", *quiet, str(made)], check=True, env=clean)
    said = subprocess.run(
        [
            python,
            "-c",
            "import sys, whittle\n"
            "print(whittle.__file__)\n"
            "whittle.render(sys.argv[1], width=80, height=60).save(sys.argv[2])\n"
            "print(len(whittle.Scene('sphere { 0, 1 }').mesh(0.1)[0].faces))",
            scene,
            str(folder / "venv.png"),
        ],
        check=True,
        env=clean,
        cwd=folder,
        capture_output=True,
        text=True,
    ).stdout
    print(said)
    assert said.startswith(str(folder)), said
    subprocess.run(
        [sys.argv[1], scene, "+W80", "+H60", f"Output_File_Name={folder / 'here.png'}"], check=True, capture_output=True
    )
    assert (folder / "venv.png").read_bytes() == (folder / "here.png").read_bytes()
