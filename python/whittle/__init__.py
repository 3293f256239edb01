"""Whittle: scenes of the POV-Ray language rendered from Python.

    import whittle
    whittle.render("sphere { 0, 1 pigment { rgb <1, 0.5, 0> } } camera { location -4*z } light_source { <2, 3, -4>, 1 }")

In a notebook the last expression of a cell is shown. Pictures are numpy arrays without a copy (`Picture.linear`,
`Picture.pixels`). See docs/tools/python.md.
"""

from ._compare import Comparison, compare
from ._messages import Message, SceneError
from ._picture import Picture
from ._scene import Scene, render
from ._solids import Measures, Mesh, Section, Spans

__all__ = [
    "Comparison",
    "Measures",
    "Mesh",
    "Message",
    "Picture",
    "Scene",
    "SceneError",
    "Section",
    "Spans",
    "compare",
    "render",
]
