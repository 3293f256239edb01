"""What objects of a scene are as solids: measures, meshes, sections, spans of rays. A scene unit is a millimetre in parts."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import List, Tuple

import numpy

from ._arrays import Float32, Float64, Int32, Int64, Uint32

Vector = Tuple[float, float, float]


@dataclass(frozen=True)
class Measures:
    """Of one object, in scene units; each number comes with what it may be off by.

    `problem` is empty, or says why the object is no body with an end; the numbers are then 0.
    """

    name: str  #: declared name, or keyword, file and line
    problem: str
    lower: Vector
    upper: Vector
    extent_error: float
    volume: float
    volume_error: float
    surface: float
    surface_error: float
    centre: Vector  #: of mass
    centre_error: Vector
    inertia: Tuple[Vector, Vector, Vector]  #: of density 1, about the centre
    inertia_error: float


@dataclass(frozen=True)
class Mesh:
    """An object as triangles that close, in the scene's left-handed space.

    `problem` is empty, or says why there is no mesh or how far it is off.
    """

    name: str
    problem: str
    vertices: Float32 = field(repr=False)  #: float32, (n, 3): scene units
    #: uint32, (m, 3): indices of vertices; the cross product of the sides from the first to the second and third points out
    #: of the body. In the right-handed space of STL, OBJ and 3MF the same is `vertices[:, [0, 2, 1]]`, `faces[:, ::-1]`
    faces: Uint32 = field(repr=False)
    #: float32, (n, 3): the surface's, out of the body, length 1; where sides meet, the mean of theirs
    normals: Float32 = field(repr=False)
    color: Tuple[float, float, float]  #: of the pigment, sRGB, 0 to 1
    deviation: float  #: greatest distance between mesh and object that was found, scene units

    @property
    def colors(self) -> Float32:
        """The colour of each vertex, float32, (n, 3): sRGB, 0 to 1."""
        return numpy.tile(numpy.array(self.color, dtype=numpy.float32), (len(self.vertices), 1))


@dataclass(frozen=True)
class Section:
    """What a plane cuts of an object: closed loops of points (k, 2), float64, scene units, what they bound on their left;
    empty where the plane misses it. The axes are those of the drawing: (z, y) of a cut across x, (x, z) across y, (x, y)
    across z."""

    name: str
    problem: str
    loops: List[Float64] = field(repr=False)
    area: float
    area_error: float  #: of the area by rays, which the loops are held against
    deviation: float


@dataclass(frozen=True)
class Spans:
    """Where rays are inside of solids: those of ray i are the rows `first[i]` to `first[i + 1]` of the others, by object and
    then by distance.

    `ends[k]` is where the ray goes in and out, in lengths of its direction: the points are `origin + t * direction`. A ray
    that starts inside has gone in at a negative t; infinite where the object has no end there. Rays look forward: what lies
    behind them is left out.
    """

    first: Int64 = field(repr=False)  #: int64, (rays + 1,)
    ends: Float64 = field(repr=False)  #: float64, (spans, 2)
    object: Int32 = field(repr=False)  #: int32, (spans,): index into names
    names: List[str] = field(default_factory=list)

    def __len__(self) -> int:
        """Of rays."""
        return len(self.first) - 1

    def __getitem__(self, ray: int) -> Float64:
        """Ends of one ray's spans, (k, 2)."""
        if not 0 <= ray < len(self):
            raise IndexError(f"ray {ray} of {len(self)}")
        return self.ends[self.first[ray] : self.first[ray + 1]]

    @property
    def ray(self) -> Int64:
        """The ray of each span, int64, (spans,)."""
        return numpy.repeat(numpy.arange(len(self)), numpy.diff(self.first))
