#!/usr/bin/env python3
"""portable.py BUILD [FOLDER]: packs what was built in BUILD (all of `whittle_tools`) into FOLDER/whittle-VERSION-linux-MACHINE.tar.gz, which runs
wherever it is unpacked, with its checksum and bill of materials beside it. Same build, same bytes. See docs/guide/building.md."""

import argparse
import gzip
import hashlib
import json
import os
import pathlib
import platform
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile

sys.dont_write_bytecode = True
import sbom  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parent.parent
# OpenImageIO brings 260 libraries: its module stays, and says what is missing where a file needs it.
LEFT_TO_THE_SYSTEM = "libwhittle_image_io.so"


def told(*command):
    return subprocess.run([str(word) for word in command], check=True, stdout=subprocess.PIPE, text=True).stdout


def debian_packages(names):
    """Name, version and source of each."""
    told_of = told("dpkg-query", "-W", "-f", "${Package}|${Version}|${source:Package} ${source:Version}\n", *names).splitlines()
    return {line.split("|")[0]: tuple(line.split("|")) for line in sorted(set(told_of))}


def owners(paths):
    """The package of each file. Debian 12 has libraries below /lib that are found below /usr/lib, and the other way round."""
    names = {name: path for path in paths for name in {str(path), str(path.resolve()), str(path.resolve()).removeprefix("/usr")}}
    found = subprocess.run(["dpkg-query", "-S", *names], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout
    holders = {names[line.split(": ")[1]]: re.split("[:,]", line)[0] for line in found.splitlines()}
    if lacking := [str(path) for path in paths if path not in holders]:
        raise SystemExit(f"of no package: {', '.join(lacking)}")
    packages = debian_packages(holders.values())
    return {path: packages[holder] for path, holder in holders.items()}


def libraries_of(binaries):
    """Name -> file of each library that they are linked with, and theirs; the loader is one."""
    found = {}
    for line in told("ldd", *binaries).splitlines():
        if "not found" in line:
            raise SystemExit(line.strip())
        if match := re.match(r"\s+(?:\S+ => )?(/\S+) \(0x", line):
            found[match[1].rsplit("/", 1)[1]] = pathlib.Path(match[1])
    return found


def place(path, target, mode=0o644):
    target.parent.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(path, target)
    target.chmod(mode)


def collect(build, top):
    """Fills `top`; file -> package of what is Debian's."""
    told("cmake", "--install", build, "--prefix", top, "--strip")
    inner = next(top.glob("lib*/**/whittle_tools")).parent
    folder, origins = top / "lib/whittle", {}
    if inner != folder:
        inner.rename(folder)
    modules = [path for path in sorted(folder.glob("*.so")) if path.name != LEFT_TO_THE_SYSTEM]
    programs = {"whittle": top / "bin/whittle", "whittle_tools": folder / "whittle_tools"}
    found = libraries_of([*programs.values(), *modules])
    loader = next(name for name in found if name.startswith("ld-"))
    holders = owners(found.values())
    for name, path in found.items():
        place(path, folder / "libraries" / name, 0o755 if name == loader else 0o644)
        origins[f"lib/whittle/libraries/{name}"] = holders[path]
    (folder / "programs").mkdir()
    launcher = (ROOT / "packaging/launcher.sh").read_text()
    for name, path in programs.items():
        path.rename(folder / "programs" / name)
        path.write_text(launcher.replace("LOADER", loader).replace("PROGRAM", name))
        path.chmod(0o755)
    includes = debian_packages(["povray-includes"])["povray-includes"]
    for path in map(pathlib.Path, told("dpkg", "-L", "povray-includes").split()):
        if path.is_relative_to("/usr/share/povray-3.7") and path.is_file():
            name = str(path.relative_to("/usr"))
            place(path, top / name)
            origins[name] = includes
    for name in {triple[0] for triple in origins.values()}:
        place(pathlib.Path("/usr/share/doc") / name / "copyright", top / "share/doc/whittle/copyrights" / name)
    return origins


def headers():
    """Packages whose headers are compiled in."""
    names = [line for line in (ROOT / "packages.txt").read_text().split("# To test")[0].splitlines() if line.endswith("-dev")]
    return set(debian_packages(names).values())


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
    version = re.search(r"project\(whittle VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text())[1]
    epoch = int(os.environ.get("SOURCE_DATE_EPOCH") or told("git", "-C", ROOT, "log", "-1", "--format=%ct"))
    name = f"whittle-{version}-linux-{platform.machine()}"
    with tempfile.TemporaryDirectory() as made:
        top = pathlib.Path(made) / name
        origins = collect(options.build, top)
        bill = json.dumps(sbom.bill(top, version, epoch, origins, headers()), indent=1) + "\n"
        (top / "share/doc/whittle/whittle.spdx.json").write_text(bill)
        (folder / f"{name}.spdx.json").write_text(bill)
        pack(top, folder / f"{name}.tar.gz", epoch, options.level)
    sums = [f"{hashlib.sha256((folder / f).read_bytes()).hexdigest()}  {f}\n" for f in (f"{name}.tar.gz", f"{name}.spdx.json")]
    (folder / f"{name}.sha256").write_text("".join(sums))
    print(folder / f"{name}.tar.gz")


if __name__ == "__main__":
    main()
