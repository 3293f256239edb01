"""The extension for Visual Studio Code by Node.js alone (extension.js).

usage: extension.py WHITTLE     exit status 77: there is no Node.js
"""
import os
import shutil
import subprocess
import sys
import tempfile

if not shutil.which("node"):
    print("no node: the extension is not tested")
    sys.exit(77)
with tempfile.TemporaryDirectory(prefix="whittle-extension-") as folder:
    script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "extension.js")
    sys.exit(subprocess.run(["node", script, os.path.abspath(sys.argv[1]), folder], env={**os.environ, "XDG_RUNTIME_DIR": folder}, timeout=100).returncode)
