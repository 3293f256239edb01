#!/usr/bin/python3
"""`whittle lsp` with a real client: Debian's neovim without a screen, configured as editors/nvim says.

usage: neovim.py WHITTLE
"""
import os
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
SCENE = """#version 3.7;
#include "parts.inc"
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 }
light_source { 5*y-5*z, rgb 1 }
#macro Ball(R)
  #local Size = R * 2;
sphere { 0, Size pigment { colr rgb 1 } }
#end
Ball(Wide)
"""


def main():
    if not shutil.which("nvim"):
        print("there is no nvim")
        return 77
    folder = tempfile.mkdtemp(prefix="whittle-nvim-")
    try:
        with open(os.path.join(folder, "scene.pov"), "w") as out:
            out.write(SCENE)
        with open(os.path.join(folder, "parts.inc"), "w") as out:
            out.write("#declare Wide = 3 / 2;\n")
        environment = dict(os.environ, WHITTLE=os.path.abspath(sys.argv[1]), HOME=folder, XDG_CONFIG_HOME=folder + "/config",
                           XDG_DATA_HOME=folder + "/data", XDG_CACHE_HOME=folder + "/cache", XDG_STATE_HOME=folder + "/state",
                           EDITORS=os.path.join(HERE, "..", "..", "editors"))
        done = subprocess.run(["nvim", "--headless", "-u", "NONE", "-n", "-c", "luafile " + os.path.join(HERE, "neovim.lua"), "scene.pov"],
                              cwd=folder, env=environment, timeout=240, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        print(done.stdout)
        return 0 if done.returncode == 0 and "all ok" in done.stdout else 1
    finally:
        shutil.rmtree(folder)


if __name__ == "__main__":
    sys.exit(main())
