"""What a scene has to tell: messages with their place, and the error that ends a reading."""

from __future__ import annotations

from typing import Any, Iterable, NamedTuple, Optional, Tuple


class Message(NamedTuple):
    """A message of the scene, as the console would show it.

    `line` and `column` count from 1; 0 means the file as a whole. `whole` has the source line and a caret.
    """

    severity: str  #: "debug", "note", "warning" or "error"
    text: str
    file: str
    line: int
    column: int
    whole: str

    def __str__(self) -> str:
        return self.whole


class SceneError(Exception):
    """A scene that cannot be read or rendered.

    `file`, `line`, `column` and `message` are those of the first mistake, `messages` has all of them.

    >>> import whittle
    >>> try:
    ...     whittle.render("sphere { 0, 1 pigment { rgbx } }")
    ... except whittle.SceneError as error:
    ...     print(error.file, error.line, error.column)
    text 1 25
    """

    def __init__(self, told: Iterable[Tuple[Any, ...]]):
        self.messages = [Message(*one) for one in told]
        first: Optional[Message] = next((m for m in self.messages if m.severity == "error"), None)
        self.file = first.file if first else ""
        self.line = first.line if first else 0
        self.column = first.column if first else 0
        self.message = first.text if first else ""
        super().__init__("\n".join(m.whole for m in self.messages))
