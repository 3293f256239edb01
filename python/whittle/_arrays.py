"""Arrays by the type of their elements, for hints; their shapes stand in docstrings."""

from typing import Any

import numpy
from numpy.typing import NDArray

Float32 = NDArray[numpy.float32]
Float64 = NDArray[numpy.float64]
Int32 = NDArray[numpy.int32]
Int64 = NDArray[numpy.int64]
Uint32 = NDArray[numpy.uint32]
Array = NDArray[Any]
