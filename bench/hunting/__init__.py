"""Scenes that hunt.py looks for slowness in: the differential's makers of text with their sizes turned up."""
import pathlib
import sys

# The makers are those of tests/differential; it is a folder of programs and no package.
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tests" / "differential"))
