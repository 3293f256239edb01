"""The module in C++ (python/binding), which the package wraps."""

from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple

from ._arrays import Array, Float32, Float64, Int32, Int64

_Told = Tuple[str, str, str, int, int, str]

class Picture:
    @property
    def light(self) -> Float32: ...
    @property
    def levels(self) -> Array: ...
    @property
    def layers(self) -> Dict[str, Float32]: ...
    @property
    def messages(self) -> List[_Told]: ...
    @property
    def seconds(self) -> float: ...
    @property
    def isa(self) -> str: ...
    def save(self, path: str) -> None: ...

class Source:
    def __init__(self, text: Optional[str]) -> None: ...
    def read(self, options: Sequence[str], exact: Sequence[str]) -> List[_Told]: ...
    def render(
        self,
        options: Sequence[str],
        exact: Sequence[str],
        camera: Optional[str],
        layers: str,
        preview: Optional[Callable[[Picture], Any]],
    ) -> Picture: ...

def measure(
    source: Source, options: Sequence[str], exact: Sequence[str], object: str, precision: float
) -> List[Dict[str, Any]]: ...
def mesh(
    source: Source,
    options: Sequence[str],
    exact: Sequence[str],
    object: str,
    tolerance: float,
    cells: int,
    seconds: float,
) -> List[Dict[str, Any]]: ...
def section(
    source: Source,
    options: Sequence[str],
    exact: Sequence[str],
    object: str,
    axis: int,
    value: float,
    tolerance: float,
    seconds: float,
) -> List[Dict[str, Any]]: ...
def spans(
    source: Source, options: Sequence[str], exact: Sequence[str], object: str, origins: Any, directions: Any
) -> Tuple[Int64, Float64, Int32, List[str]]: ...
def compare(a: Any, b: Any, tolerance: float, flip: bool) -> Dict[str, Any]: ...
