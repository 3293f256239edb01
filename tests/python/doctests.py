"""Runs the examples in the package's docstrings."""

import doctest
import importlib
import pkgutil
import sys

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
print(f"{tried} examples, {failed} failed")
sys.exit(failed > 0 or tried < 10)
