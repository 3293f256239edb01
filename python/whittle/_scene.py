"""Scenes: read once, rendered often."""

from __future__ import annotations

import inspect
from typing import Any, Callable, Concatenate, Dict, List, Optional, ParamSpec, Sequence, Union

from . import _jupyter, _whittle
from ._messages import Message
from ._picture import Picture
from ._solids import Measures, Mesh, Section, Spans
from ._words import Antialias, Text, declared, picture_words, source_of

Camera = Union[None, str, Dict[str, Any]]
Words = ParamSpec("Words")


def camera_text(camera: Camera) -> Optional[str]:
    """A `camera` block of the scene language: text as it stands, a dict by its words.

    >>> camera_text({"location": (0, 1, -5), "look_at": (0, 0, 0), "angle": 40})
    'camera { right x*image_width/image_height location <0.0, 1.0, -5.0> angle 40.0 look_at <0.0, 0.0, 0.0> }'
    """
    if camera is None or isinstance(camera, str):
        return camera
    words = dict(camera)
    look_at = words.pop("look_at", None)
    parts = [] if "right" in words else ["right x*image_width/image_height"]
    for name, value in [*words.items()] + ([("look_at", look_at)] if look_at is not None else []):
        if not name.isidentifier():
            raise ValueError(f"'{name}' is no word of a camera")
        if isinstance(value, (int, float)):
            parts.append(f"{name} {float(value)!r}")
        else:
            parts.append(f"{name} <{', '.join(repr(float(v)) for v in value)}>")
    return f"camera {{ {' '.join(parts)} }}"


class Scene:
    """A scene of the POV-Ray language, read once and asked often.

    `text_or_path` is the scene's text, or the path of its file (what has a brace, a '#', a ';' or a line end is text);
    `options` are words of the command line (docs/command_line.md), as in `["+Q9", "--povray=3.8"]`; further arguments
    declare constants, as `Declare=NAME=VALUE` does.

    >>> import whittle
    >>> scene = whittle.Scene("#ifndef (Red) #declare Red = 0; #end background { rgb <Red, 0, 0> }", Red=1)
    >>> scene.render(width=2, height=2).pixels[0, 0].tolist()
    [255, 0, 0]
    """

    def __init__(self, text_or_path: Text, *, options: Sequence[str] = (), **declare: Any):
        text, path = source_of(text_or_path)
        self._source = _whittle.Source(text)
        self._options: List[str] = [str(word) for word in options]
        self._exact: List[str] = ([] if path is None else [f"Input_File_Name={path}"]) + declared(declare)
        self._told = [Message(*one) for one in self._source.read(self._options, self._exact)]

    @property
    def messages(self) -> List[Message]:
        """What the scene told while it was read: warnings and #debug text."""
        return list(self._told)

    def render(
        self,
        /,
        *,
        width: Optional[int] = None,
        height: Optional[int] = None,
        antialias: Antialias = None,
        camera: Camera = None,
        clock: Optional[float] = None,
        quality: Optional[int] = None,
        threads: Optional[int] = None,
        layers: Union[str, Sequence[str]] = "",
        options: Sequence[str] = (),
        progressive: Optional[bool] = None,
        **declare: Any,
    ) -> Picture:
        """Renders a picture: the same bytes as the command line's with the same words.

        width, height: pixels; antialias: True, False, or the threshold from 0 to 3; camera: the text of a camera block, or
        a dict of its words; clock: the scene's `clock`; quality: 0 to 11; threads: usually one a core; layers: "all" or
        names such as "depth,normal", for `Picture.layers`; options: more words of the command line; declare: constants.
        The text is read again only where it may have looked at what has changed: constants, clock, size.

        In Jupyter a picture that takes longer is shown while it grows, coarse to fine; `progressive=False` leaves that out.
        KeyboardInterrupt ends the render within half a second. Other threads of Python go on meanwhile.
        """
        words = declared(declare)
        words += self._exact + picture_words(width, height, antialias, quality, clock, threads)
        named = layers if isinstance(layers, str) else ",".join(layers)
        with _jupyter.growing(progressive) as look:
            made = self._source.render(
                self._options + [str(word) for word in options], words, camera_text(camera), named, look
            )
        return Picture(made)

    def info(self, *, object: str = "", precision: float = 2e-4) -> List[Measures]:
        """Extent, volume, surface, centre and inertia of each object, or of the one with that name, as `whittle info` has
        them. precision: share of volume and surface that they may be off by.

        >>> import whittle
        >>> [ball] = whittle.Scene("#declare Ball = sphere { 0, 2 } object { Ball }").info()
        >>> ball.name, abs(ball.volume - 33.510321638) < ball.volume_error < 0.01
        ('Ball', True)
        """
        if not precision > 0:
            raise ValueError("a precision is above 0")
        return [
            Measures(**one) for one in _whittle.measure(self._source, self._options, self._exact, object, precision)
        ]

    def mesh(
        self, tolerance: float = 0.01, *, object: str = "", cells: int = 16, seconds: float = 60.0
    ) -> List[Mesh]:
        """Each object, or the one with that name, as closed triangles that are off by no more than `tolerance` scene units;
        what that takes beyond `seconds` of an object is left, and `Mesh.problem` says so. cells: of the first lattice along
        the longest side, 4 to 128: narrower parts may be overlooked.

        >>> import whittle
        >>> [ball] = whittle.Scene("sphere { 0, 1 }").mesh(0.05)
        >>> ball.vertices.dtype, ball.faces.dtype, bool(abs((ball.vertices**2).sum(axis=1) - 1).max() < 0.1)
        (dtype('float32'), dtype('uint32'), True)
        """
        if not tolerance > 0:
            raise ValueError("a tolerance is above 0")
        if not 4 <= cells <= 128:
            raise ValueError("a lattice has 4 to 128 cells")
        return [
            Mesh(**one)
            for one in _whittle.mesh(self._source, self._options, self._exact, object, tolerance, cells, seconds)
        ]

    def section(
        self, axis: str, value: float, *, tolerance: float = 0.01, object: str = "", seconds: float = 60.0
    ) -> List[Section]:
        """What the plane in which `axis` ("x", "y" or "z") has that value cuts of each object, as `whittle info --section`
        draws it.

        >>> import whittle
        >>> [disc] = whittle.Scene("sphere { 0, 1 }").section("y", 0.6)
        >>> len(disc.loops), round(disc.area, 2)
        (1, 2.01)
        """
        if axis not in ("x", "y", "z"):
            raise ValueError(f"an axis is x, y or z, not '{axis}'")
        if not tolerance > 0:
            raise ValueError("a tolerance is above 0")
        cut = _whittle.section(
            self._source, self._options, self._exact, object, "xyz".index(axis), float(value), tolerance, seconds
        )
        return [Section(**one) for one in cut]

    def spans(self, origins: Any, directions: Any, *, object: str = "") -> Spans:
        """Where rays are inside of each object, or of the one with that name. origins, directions: arrays of shape (n, 3),
        scene units; directions of any length but 0. 10^6 rays in one call go to all cores.

        >>> import whittle
        >>> tube = whittle.Scene("difference { cylinder { 0, y, 2 } cylinder { -y, 2*y, 1 } }")
        >>> found = tube.spans([[-5, 0.5, 0], [-5, 9, 0]], [[1, 0, 0], [1, 0, 0]])
        >>> found[0].round(6).tolist(), len(found[1])
        ([[3.0, 4.0], [6.0, 7.0]], 0)
        """
        return Spans(*_whittle.spans(self._source, self._options, self._exact, object, origins, directions))


def _of_text(method: Callable[Concatenate[Scene, Words], Picture]) -> Callable[Concatenate[Text, Words], Picture]:
    """The same call for a scene that is given with it, and is read but once: by the render itself."""

    def render(text_or_path: Text, /, *args: Words.args, **words: Words.kwargs) -> Picture:
        """Renders a scene, given as text or as a path: `Scene(text_or_path).render(...)` in one call.

        >>> import whittle
        >>> whittle.render("sphere { 0, 1 pigment { rgb 1 } }", width=16, height=12, antialias=True)
        <whittle.Picture 16x12>
        """
        text, path = source_of(text_or_path)
        scene = Scene.__new__(Scene)
        scene._source = _whittle.Source(text)
        scene._options = []
        scene._exact = [] if path is None else [f"Input_File_Name={path}"]
        scene._told = []
        return method(scene, *args, **words)

    own, whole = inspect.signature(render), inspect.signature(method)
    shown = [own.parameters["text_or_path"], *list(whole.parameters.values())[1:]]
    setattr(render, "__signature__", whole.replace(parameters=shown))  # what help() and completion show
    render.__module__ = "whittle"
    render.__qualname__ = "render"
    return render


render = _of_text(Scene.render)
