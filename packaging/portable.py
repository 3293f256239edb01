#!/usr/bin/env python3
"""portable.py BUILD [FOLDER]: packs what was built in BUILD (all of `whittle_tools`) into FOLDER/whittle-VERSION-linux-MACHINE.tar.gz, which runs
wherever it is unpacked, with its checksum and bill of materials beside it. Same build, same bytes. See docs/guide/building.md."""

import argparse
import gzip
import hashlib
import json
import os
import pathlib
import re
import shutil
import sys
import tarfile
import tempfile

sys.dont_write_bytecode = True
import sbom  # noqa: E402
from libraries import System, told  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parent.parent
# OpenImageIO brings 260 libraries: its module stays, and says what is missing where a file needs it.
LEFT_TO_THE_SYSTEM = "libwhittle_image_io.so"


def place(path, target, mode=0o644):
    target.parent.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(path, target)
    target.chmod(mode)


def collect(build, top, system):
    """Fills `top`; file -> package of what is Debian's."""
    told("cmake", "--install", build, "--prefix", top, "--strip")
    inner = next(top.glob("lib*/**/whittle_tools")).parent
    folder, origins = top / "lib/whittle", {}
    if inner != folder:
        inner.rename(folder)
    modules = [path for path in sorted(folder.glob("*.so")) if path.name != LEFT_TO_THE_SYSTEM]
    programs = {"whittle": top / "bin/whittle", "whittle_tools": folder / "whittle_tools"}
    found = system.libraries_of([*programs.values(), *modules])
    loader = next(name for name in found if name.startswith("ld-"))
    holders = system.owners(found.values())
    for name, path in found.items():
        place(path, folder / "libraries" / name, 0o755 if name == loader else 0o644)
        origins[f"lib/whittle/libraries/{name}"] = holders[path]
    (folder / "programs").mkdir()
    launcher = (ROOT / "packaging/launcher.sh").read_text()
    for name, path in programs.items():
        path.rename(folder / "programs" / name)
        path.write_text(launcher.replace("LOADER", loader).replace("PROGRAM", name))
        path.chmod(0o755)
    includes = system.packages(["povray-includes"])["povray-includes"]
    for name in told(*system.query, "-L", "povray-includes").split():
        path = system.root / name.removeprefix("/")
        if name.startswith("/usr/share/povray-3.7/") and path.is_file():
            name = name.removeprefix("/usr/")
            place(path, top / name)
            origins[name] = includes
    for name in {triple[0] for triple in origins.values()}:
        place(system.root / "usr/share/doc" / name / "copyright", top / "share/doc/whittle/copyrights" / name)
    return origins


def headers(system):
    """Packages whose headers are compiled in."""
    names = [line for line in (ROOT / "packages.txt").read_text().split("# To test")[0].splitlines() if line.endswith("-dev")]
    return set(system.packages(names).values())


def pack(top, archive, epoch, level):
    def plain(entry):
        entry.uid = entry.gid = 0
        entry.uname = entry.gname = ""
        entry.mtime = epoch
        entry.mode = 0o755 if entry.isdir() or entry.mode & 0o100 else 0o644
        return entry

    with open(archive, "wb") as file, gzip.GzipFile("", "wb", level, file, mtime=0) as packed, \
            tarfile.open(fileobj=packed, mode="w", format=tarfile.GNU_FORMAT) as tar:
        tar.add(top, top.name, recursive=False, filter=plain)
        for path in sorted(top.rglob("*")):
            tar.add(path, f"{top.name}/{path.relative_to(top)}", recursive=False, filter=plain)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path, nargs="?")
    parser.add_argument("--level", type=int, default=9, help="of the compression, 1 to 9")
    options = parser.parse_args()
    folder = options.folder or options.build
    folder.mkdir(parents=True, exist_ok=True)
    system = System(options.build)
    version = re.search(r"project\(whittle VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text())[1]
    epoch = int(os.environ.get("SOURCE_DATE_EPOCH") or told("git", "-C", ROOT, "log", "-1", "--format=%ct"))
    name = f"whittle-{version}-linux-{system.machine}"
    with tempfile.TemporaryDirectory() as made:
        top = pathlib.Path(made) / name
        origins = collect(options.build, top, system)
        bill = json.dumps(sbom.bill(top, version, epoch, origins, headers(system)), indent=1) + "\n"
        (top / "share/doc/whittle/whittle.spdx.json").write_text(bill)
        (folder / f"{name}.spdx.json").write_text(bill)
        pack(top, folder / f"{name}.tar.gz", epoch, options.level)
    sums = [f"{hashlib.sha256((folder / f).read_bytes()).hexdigest()}  {f}\n" for f in (f"{name}.tar.gz", f"{name}.spdx.json")]
    (folder / f"{name}.sha256").write_text("".join(sums))
    print(folder / f"{name}.tar.gz")


if __name__ == "__main__":
    main()
