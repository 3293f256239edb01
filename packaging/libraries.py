#!/usr/bin/env python3
"""libraries.py BUILD FILE...: the packages of Debian that programs and modules of a build are linked with, as a Debian package names what it depends on."""

import pathlib
import platform
import re
import subprocess
import sys


def told(*command):
    return subprocess.run([str(word) for word in command], check=True, stdout=subprocess.PIPE, text=True).stdout


class System:
    """Where a build's libraries are: this machine, or the root that it was built for (cmake/arm64.sh), with what dpkg knows of it."""

    def __init__(self, build):
        cache = dict(re.findall(r"^(\w+):\w+=(.*)$", (build / "CMakeCache.txt").read_text(), re.M))
        self.root = pathlib.Path(cache.get("WHITTLE_SYSROOT") or "/")
        self.machine = platform.machine()
        self.query, self.told_libraries = ["dpkg-query"], ["ldd"]
        if cache.get("WHITTLE_SYSROOT"):
            self.machine = "aarch64"
            self.query = ["dpkg-query", "--admindir", self.root / "var/lib/dpkg"]
            self.told_libraries = [cache["WHITTLE_QEMU"], "-L", self.root, next(self.root.glob("lib/ld-linux-*.so.?")), "--list"]

    def packages(self, names):
        """Name, version and source of each."""
        told_of = told(*self.query, "-W", "-f", "${Package}|${Version}|${source:Package} ${source:Version}\n", *names).splitlines()
        return {line.split("|")[0]: tuple(line.split("|")) for line in sorted(set(told_of))}

    def owners(self, paths):
        """The package of each file. Debian 12 has libraries below /lib that are found below /usr/lib, and the other way round."""
        inside = {path: "/" + str(path.relative_to(self.root)) for path in paths}
        real = {path: "/" + str(path.resolve().relative_to(self.root.resolve())) for path in paths}
        names = {name: path for path in paths for name in {inside[path], real[path], real[path].removeprefix("/usr")}}
        command = [str(word) for word in [*self.query, "-S", *names]]
        found = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout
        holders = {names[line.split(": ")[1]]: re.split("[:,]", line)[0] for line in found.splitlines()}
        if lacking := [str(path) for path in paths if path not in holders]:
            raise SystemExit(f"of no package: {', '.join(lacking)}")
        packages = self.packages(holders.values())
        return {path: packages[holder] for path, holder in holders.items()}

    def libraries_of(self, binaries):
        """Name -> file of each library that they are linked with, and theirs; the loader is one."""
        found = {}
        for binary in binaries:
            for line in told(*self.told_libraries, binary).splitlines():
                if "not found" in line:
                    raise SystemExit(line.strip())
                if match := re.match(r"\s+(?:\S+ => )?(/\S+) \(0x", line):
                    path = pathlib.Path(match[1])
                    if not path.is_relative_to(self.root):
                        path = self.root / match[1].removeprefix("/")
                    found[path.name] = path
        return found

    def depends_on(self, binaries):
        """What `binaries` name themselves, not what their libraries do; of the release that they were built with, or later."""
        named = {name for binary in binaries for name in re.findall(r"\(NEEDED\).*\[(.*)\]", told("readelf", "-d", binary))}
        places = [*self.root.glob("usr/lib/*-linux-gnu"), *self.root.glob("lib/*-linux-gnu"), self.root / "lib"]
        found = [next(place / name for place in places if (place / name).exists()) for name in sorted(named)]
        packages = sorted(set(self.owners(found).values()))
        return ", ".join(f"{name} (>= {version.rsplit('-', 1)[0]})" for name, version, _ in packages)


if __name__ == "__main__":
    print(System(pathlib.Path(sys.argv[1])).depends_on(sys.argv[2:]))
