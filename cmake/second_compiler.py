#!/usr/bin/python3
"""second_compiler.py [COMPILER]: every source is read by another compiler (g++ if none is named) under the project's
warnings, each of them an error. It makes no code, which is most of a compiler's time.

The build and its tests are one compiler's, so words that only it accepts would go unseen.
"""
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent


def main():
    compiler = sys.argv[1] if len(sys.argv) > 1 else "g++"
    folder = ROOT / "build" / pathlib.Path(compiler).name
    # One instruction set, for others differ in width alone; no launcher, for it would keep nothing.
    subprocess.run(["cmake", "--preset", "gcc", "-B", folder, f"-DCMAKE_CXX_COMPILER={compiler}", "-DCMAKE_CXX_COMPILER_LAUNCHER=",
                    "-DWHITTLE_ISA_LEVELS=v3"], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    commands = [entry for entry in json.loads((folder / "compile_commands.json").read_text())
                if "cmake_pch" not in pathlib.Path(entry["file"]).name]

    def read(entry):
        words = re.sub(r" -o \S+ -c ", " -fsyntax-only -Werror ", entry["command"])
        return subprocess.run(words, shell=True, cwd=entry["directory"], capture_output=True, text=True)

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        wrong = [run.stderr for run in pool.map(read, commands) if run.returncode != 0]
    print(f"{compiler}: {len(commands)} batches of sources, {len(wrong)} with errors or warnings")
    if wrong or not commands:
        sys.exit("\n".join(wrong))


if __name__ == "__main__":
    main()
