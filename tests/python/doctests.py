"""Runs the examples in the package's docstrings."""

import doctest
import importlib
import os
import pathlib
import pkgutil
import re
import sys
import tempfile

try:
    import numpy  # noqa: F401
except ImportError:
    sys.exit(77)
import whittle

failed = tried = 0
for module in [whittle] + [
    importlib.import_module(f"whittle.{found.name}") for found in pkgutil.iter_modules(whittle.__path__)
]:
    result = doctest.testmod(module)
    failed += result.failed
    tried += result.attempted
# And the first of the page, which saves a picture where it stands.
page = (pathlib.Path(os.environ["WHITTLE_SOURCE"]) / "docs/tools/python.md").read_text()
with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    exec(re.search(r"```python\n(.*?)```", page, re.S).group(1), {})
    failed += not os.path.getsize("ball.png") > 1000
    os.chdir("/")
print(f"{tried} examples, {failed} failed")
sys.exit(failed > 0 or tried < 10)
