"""A rendered picture: arrays over the renderer's own memory, and files."""

from __future__ import annotations

import os
import tempfile
from typing import Any, Dict, List, Optional, Union

import numpy

from . import _whittle
from ._arrays import Array, Float32
from ._messages import Message


class Picture:
    """A picture in memory. Arrays are views of the renderer's memory, read-only and never copied.

    >>> import whittle
    >>> p = whittle.render("global_settings { assumed_gamma 1 } background { rgb <1, 0.5, 0> }", width=8, height=4)
    >>> p.linear.shape, p.linear.dtype
    ((4, 8, 3), dtype('float32'))
    >>> [float(v) for v in p.linear[0, 0]]
    [1.0, 0.5, 0.0]
    >>> p.pixels[0, 0].tolist()
    [255, 188, 0]
    """

    def __init__(self, made: _whittle.Picture):
        self._made = made
        self._layers: Optional[Dict[str, Array]] = None

    @property
    def linear(self) -> Float32:
        """Linear light, float32 of shape (height, width, 3): red, green, blue, top row first, not clamped; 1 is the
        brightest that a file of 8 bits holds. Colours are weighted by their opacity (premultiplied)."""
        return self._made.light[:, :, :3]

    @property
    def transmit(self) -> Float32:
        """How clear each pixel is, float32 of shape (height, width): 0 opaque, 1 clear. Opaque everywhere unless
        `options=["+UA"]` asks for a clear background."""
        return self._made.light[:, :, 3]

    @property
    def pixels(self) -> Array:
        """What a file of this picture holds, of shape (height, width, channels): sRGB levels unless the scene or an
        option says otherwise, uint8, or uint16 where more than 8 bits a colour were asked for. Channels: 3; 4 with
        alpha, 1 for grey."""
        return self._made.levels

    @property
    def width(self) -> int:
        return int(self._made.light.shape[1])

    @property
    def height(self) -> int:
        return int(self._made.light.shape[0])

    @property
    def layers(self) -> Dict[str, Array]:
        """What `layers=` asked for, by name, float32: "depth" of shape (height, width) in scene units, "normal",
        "position", "albedo" of shape (height, width, 3), "uv" (height, width, 2), "object" and "material" numbers;
        Cryptomatte's by the name of each channel. See docs/tools/layers.md."""
        if self._layers is None:
            self._layers = grouped(self._made.layers)
        return self._layers

    @property
    def messages(self) -> List[Message]:
        """What the scene and the renderer told: warnings, #debug text, notes."""
        return [Message(*one) for one in self._made.messages]

    @property
    def seconds(self) -> float:
        """That tracing took, by the clock on the wall."""
        return self._made.seconds

    def save(self, path: "Union[str, os.PathLike[str]]") -> None:
        """Writes the picture as the command line does; the name says which type: .png .ppm .tga .jpg .bmp .exr .hdr."""
        self._made.save(os.fspath(path))

    def png(self) -> bytes:
        """The bytes of a PNG file of it."""
        with tempfile.TemporaryDirectory(prefix="whittle") as folder:
            path = os.path.join(folder, "picture.png")
            self._made.save(path)
            with open(path, "rb") as file:
                return file.read()

    def _repr_png_(self) -> bytes:
        return self.png()

    def __array__(self, dtype: Any = None, copy: Any = None) -> Array:
        return numpy.array(self.pixels, dtype=dtype) if dtype is not None or copy else self.pixels

    def __repr__(self) -> str:
        return f"<whittle.Picture {self.width}x{self.height}>"


#: Channels that belong together, in the order of the array's last axis.
_TOGETHER = {"normal": "XYZ", "position": "XYZ", "albedo": "RGB", "uv": "UV"}


def grouped(channels: Dict[str, Array]) -> Dict[str, Array]:
    """One array a layer: neighbours in the renderer's memory become one view of it."""
    out: Dict[str, Array] = {}
    for name, values in channels.items():
        layer, _, letter = name.partition(".")
        letters = _TOGETHER.get(layer)
        if letters is None:
            out[layer if letter in ("Z", "id", "ns") else name] = values
        elif letter == letters[0]:
            out[layer] = numpy.lib.stride_tricks.as_strided(
                values, values.shape + (len(letters),), values.strides + (values.itemsize,), writeable=False
            )
    return out
