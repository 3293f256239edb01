"""How far two pictures are apart: the numbers of `whittle compare`."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any, Optional, Tuple

import numpy

from . import _whittle
from ._picture import Picture


@dataclass(frozen=True)
class Comparison:
    """Values are on the scale of 0 to 255, whatever the depth of the pictures."""

    agreeing: float  #: share of pixels within the tolerance in every channel
    rmse: float  #: over all channels
    psnr: float  #: decibels; infinite if the pictures are equal
    ssim: float  #: structural similarity of the luminance, 1 if equal
    largest: float  #: difference of any channel
    worst: Tuple[int, int]  #: the pixel that has it: x, y from the top left
    flip: Optional[float] = None  #: how different they look (Andersson et al. 2020), 0 to 1, where it was asked for


def compare(a: Any, b: Any, *, tolerance: float = 3.0, flip: bool = False) -> Comparison:
    """Compares two pictures of one size: each a Picture, a path, or an array of shape (height, width, channels) with uint8
    or uint16 levels, or with numbers from 0 to 1 as a file would store them.

    tolerance: largest difference of a channel that agrees, of 255; a is the reference of `flip`.

    >>> import numpy, whittle
    >>> black = numpy.zeros((16, 16, 3), dtype=numpy.uint8)
    >>> found = whittle.compare(black, black + 4)
    >>> found.agreeing, found.rmse, found.largest
    (0.0, 4.0, 4.0)
    """
    return Comparison(**_whittle.compare(_given(a), _given(b), tolerance, flip))


def _given(picture: Any) -> Any:
    if isinstance(picture, Picture):
        return numpy.ascontiguousarray(picture.pixels)
    if isinstance(picture, os.PathLike):
        return os.fspath(picture)
    return picture if isinstance(picture, str) else numpy.asarray(picture)
