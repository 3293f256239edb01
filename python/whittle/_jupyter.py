"""A picture that is shown while it grows, where the program at the other end is a notebook."""

from __future__ import annotations

import sys
import time
from contextlib import contextmanager
from typing import Any, Callable, Iterator, Optional

_PATIENCE = 0.4  # seconds: a picture that is done before is shown by its cell alone


def in_notebook() -> bool:
    """Whether a kernel runs this. IPython is asked only where the program has loaded it."""
    ipython = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython is not None else None
    return shell is not None and getattr(shell, "kernel", None) is not None


@contextmanager
def growing(wanted: Optional[bool]) -> Iterator[Optional[Callable[[Any], None]]]:
    """What is called with the pictures of a render that is under way; what they showed is gone at its end."""
    if wanted is False or (wanted is None and not in_notebook()):
        yield None
        return
    from IPython.display import display  # type: ignore[import]  # only where it is there

    from ._picture import Picture

    begun = time.monotonic()
    shown = None

    def look(made: Any) -> None:
        nonlocal shown
        if time.monotonic() - begun < _PATIENCE:
            return
        if shown is None:
            shown = display(Picture(made), display_id=True)
        else:
            shown.update(Picture(made))

    try:
        yield look
    finally:
        if shown is not None:
            shown.update(_Nothing())


class _Nothing:
    """In the place of a growing picture, once the cell shows the whole one."""

    def _repr_html_(self) -> str:
        return ""

    def __repr__(self) -> str:
        return ""
