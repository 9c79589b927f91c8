"""Values of equal length at any bytes of a buffer, all of them at once."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

__all__ = ["put"]


def put(buffer: NDArray[np.uint8], places: NDArray[np.int64], values: NDArray[Any]) -> None:
    """Put values into a buffer.

    Args:
        buffer: bytes, without gaps.
        places: where each value begins, shape (values,) [bytes].
        values: shape (values,), of a void type, which is copied as it stands.
    """
    # One window begins at each byte, and is as long as a value.
    count = len(buffer) - values.itemsize + 1
    windows: NDArray[Any] = np.ndarray((count,), values.dtype, buffer, strides=(1,))
    windows[places] = values
