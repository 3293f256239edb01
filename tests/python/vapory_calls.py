"""vapory's calls, by the lines that docs/tools/python.md shows."""

import os
import pathlib
import re
import sys
import tempfile
import types

try:
    import numpy
except ImportError:
    sys.exit(77)
import whittle

page = (pathlib.Path(os.environ["WHITTLE_SOURCE"]) / "docs/tools/python.md").read_text()
shown = next(text for text in re.findall(r"```python\n(.*?)```", page, re.S) if "class Block" in text)
lines = [line for line in shown.splitlines() if line.strip()]
assert len(lines) <= 24, len(lines)
vapory = types.ModuleType("vapory")
exec(shown, vapory.__dict__)
sys.modules["vapory"] = vapory

from vapory import Background, Box, Camera, Difference, Finish, LightSource, Pigment, Scene, Sphere, Texture  # noqa: E402

camera = Camera("location", [0, 2, -3], "look_at", [0, 0.5, 2])
light = LightSource([2, 4, -3], "color", [1, 1, 1])
red = Texture(Pigment("color", [1, 0, 0.2]), Finish("phong", 0.7))
bite = Difference(Sphere([0, 1, 2], 1.5, red), Box([-0.5, -3, -9], [0.5, 3, 9], Pigment("color", [1, 1, 0])))
scene = Scene(camera, objects=[Background("color", [0, 0, 0.2]), light, bite])
array = scene.render(width=80, height=60, antialiasing=0.1)
assert array.shape == (60, 80, 3) and array.dtype == numpy.uint8, (array.shape, array.dtype)
same = whittle.render(
    """camera { location <0, 2, -3> look_at <0, 0.5, 2> } background { color <0, 0, 0.2> }
light_source { <2, 4, -3>, color <1, 1, 1> }
difference { sphere { <0, 1, 2>, 1.5 texture { pigment { color <1, 0, 0.2> } finish { phong 0.7 } } }
             box { <-0.5, -3, -9>, <0.5, 3, 9> pigment { color <1, 1, 0> } } }""",
    width=80,
    height=60,
    antialias=0.1,
)
assert numpy.array_equal(array, same.pixels)
with tempfile.TemporaryDirectory() as folder:
    path = os.path.join(folder, "bite.png")
    scene.render(path, width=40, height=30)
    assert whittle.compare(path, whittle.render(scene.text, width=40, height=30)).largest == 0
assert hasattr(scene.render("ipython", width=8, height=6), "_repr_png_")
