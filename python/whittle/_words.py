"""From arguments to words of whittle's command line: the one place where pictures' options are understood."""

from __future__ import annotations

import os
from typing import Any, List, Optional, Tuple, Union

Text = Union[str, "os.PathLike[str]"]
Antialias = Union[None, bool, float]


def source_of(text_or_path: Text) -> Tuple[Optional[str], Optional[str]]:
    """The text of a scene, or the path of its file: what has a brace, a '#' or a line end is text."""
    if isinstance(text_or_path, os.PathLike):
        return None, os.fspath(text_or_path)
    if any(mark in text_or_path for mark in "{}#\n;"):
        return text_or_path, None
    return None, text_or_path


def declared(declare: "dict[str, Any]") -> List[str]:
    """`Declare=NAME=VALUE` for each: numbers are read in single precision, as the command line reads them."""
    words = []
    for name, value in declare.items():
        if not name.isidentifier():
            raise ValueError(f"'{name}' is no name of a constant")
        if isinstance(value, str):
            if '"' in value:
                raise ValueError(f"the text of {name} has a quotation mark, which a constant cannot have")
            words.append(f'Declare={name}="{value}"')
        else:
            words.append(f"Declare={name}={float(value)!r}")
    return words


def picture_words(
    width: Optional[int],
    height: Optional[int],
    antialias: Antialias,
    quality: Optional[int],
    clock: Optional[float],
    threads: Optional[int],
) -> List[str]:
    words = []
    if width is not None:
        words.append(f"Width={int(width)}")
    if height is not None:
        words.append(f"Height={int(height)}")
    if antialias is not None:
        words.append(f"Antialias={'off' if antialias is False else 'on'}")
        if not isinstance(antialias, bool):
            if not 0 <= antialias <= 3:
                raise ValueError(f"antialias is True, False or a threshold from 0 to 3, not {antialias!r}")
            words.append(f"Antialias_Threshold={float(antialias)!r}")
    if quality is not None:
        words.append(f"Quality={int(quality)}")
    if clock is not None:
        words.append(f"Clock={float(clock)!r}")
    if threads is not None:
        words.append(f"Work_Threads={int(threads)}")
    return words

