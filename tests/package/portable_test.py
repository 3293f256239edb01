#!/usr/bin/env python3
"""portable_test.py BUILD: the portable archive of a build. Packed twice it has the same bytes; unpacked and moved, called by a link, it renders what
the build does, with its own libraries and include files; its bill of materials names each file. Exit status 77: not on this system."""

import hashlib
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
SCENE = """#version 3.7;
global_settings { assumed_gamma 1 }
#include "colors.inc"
camera { location -3*z look_at 0 } light_source { <2, 4, -6>, rgb 1 }
sphere { 0, 1 pigment { Orange } }
"""


def pack(build, folder):
    subprocess.run([ROOT / "packaging/portable.py", build, folder, "--level", "1"], check=True, stdout=subprocess.DEVNULL,
                   env={**os.environ, "SOURCE_DATE_EPOCH": "1700000000"})
    return {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in folder.iterdir()}


def run(folder, *words, **more):
    environment = {"PATH": os.environ["PATH"], "HOME": str(folder), "POVINI": str(folder / "none.ini")}
    return subprocess.run([str(word) for word in words], cwd=folder, check=True, capture_output=True, env=environment, **more)


def check_bill(top, bill):
    held = {file["fileName"]: file["checksums"][1]["checksumValue"] for file in bill["files"]}
    there = {"./" + str(p.relative_to(top)) for p in top.rglob("*") if p.is_file() and not p.is_symlink()}
    assert there - set(held) == {"./share/doc/whittle/whittle.spdx.json"} and set(held) <= there
    for name, checksum in held.items():
        assert hashlib.sha256((top / name).read_bytes()).hexdigest() == checksum, name
    names = {package["SPDXID"] for package in bill["packages"]} | {file["SPDXID"] for file in bill["files"]} | {bill["SPDXID"]}
    assert len(names) == len(bill["packages"]) + len(bill["files"]) + 1  # no two have the same
    for relation in bill["relationships"]:
        assert {relation["spdxElementId"], relation["relatedSpdxElement"]} <= names
    assert {"libc6", "libstdc++6", "zlib1g"} <= {package["name"] for package in bill["packages"]}


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    if not shutil.which("dpkg-query") or not pathlib.Path("/usr/share/povray-3.7/include").exists():
        return 77
    with tempfile.TemporaryDirectory() as made:
        folder = pathlib.Path(made)
        sums = pack(build, folder / "one")
        assert sums == pack(build, folder / "two"), "two archives of one build differ"
        archive = next(name for name in sums if name.endswith(".tar.gz"))
        run(folder / "one", "sha256sum", "--check", *(name for name in sums if name.endswith(".sha256")))
        run(folder, "tar", "-xf", folder / "one" / archive)
        top = folder / "a place" / archive.removesuffix(".tar.gz")
        top.parent.mkdir()
        (folder / top.name).rename(top)
        check_bill(top, json.loads((folder / "one" / archive.replace(".tar.gz", ".spdx.json")).read_text()))

        (folder / "scene.pov").write_text(SCENE)
        (folder / "none.ini").write_text("")  # this system's would name its include files
        (folder / "whittle").symlink_to(top / "bin/whittle")
        (folder / "povray").symlink_to("whittle")
        run(folder, build / "whittle", "scene.pov", "+W64", "+H48", "+Obuilt.png")
        run(folder, folder / "whittle", "scene.pov", "+W64", "+H48", "+Ounpacked.png")
        assert (folder / "built.png").read_bytes() == (folder / "unpacked.png").read_bytes()
        for kind, end in {"J": "jpg", "T": "tga", "C": "tga", "B": "bmp", "H": "hdr"}.items():
            for program, name in ((build / "whittle", "built"), (folder / "whittle", "unpacked")):
                run(folder, program, "scene.pov", "+W64", "+H48", f"+F{kind}", f"+O{name}.{end}")
            assert (folder / f"built.{end}").read_bytes() == (folder / f"unpacked.{end}").read_bytes(), end
        called = run(folder, "./povray", "+Iscene.pov", "+W64", "+H48", "+Ocalled.png")
        assert b"Persistence of Vision" in called.stderr or b"Render" in called.stderr, called.stderr  # as POV-Ray speaks
        run(folder, folder / "whittle", "pixel", "scene.pov", "32,24", "+W64", "+H48")
        # Its own include files, whatever the system has.
        colors = top / "share/povray-3.7/include/colors.inc"
        colors.write_text(colors.read_text().replace("#declare Orange", "#declare Orange_", 1) + "\n#declare Orange = rgb <0, 0, 1>;\n")
        run(folder, folder / "whittle", "scene.pov", "+W64", "+H48", "+Oblue.png")
        assert (folder / "built.png").read_bytes() != (folder / "blue.png").read_bytes()
    return 0


if __name__ == "__main__":
    sys.exit(main())
