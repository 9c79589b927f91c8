"""Structures as NumPy arrays: level, row, column."""

from __future__ import annotations

import io
import reprlib
import tokenize
import warnings

import numpy as np

from block_construction.errors import ConstructionError
from block_construction.structure.voxels import MOST_CELLS, check_size, filled_cells, structure_of
from rqt_mrta_py.hooks import Structure

__all__ = ["read_npy", "write_npy"]

_DIMENSIONS = 3
_KINDS = "biuf"
"""Truth values, whole numbers and floats; what is not 0 is filled."""
_BITS, _LONGEST = 63, 120
_DAMAGED = (ValueError, EOFError, TypeError, SyntaxError, tokenize.TokenError, RecursionError, MemoryError)
"""What NumPy raises of headers that it cannot read: they are parsed as Python."""


def read_npy(name: str, content: bytes) -> Structure:
    """Read a ``.npy`` file; whatever is not 0 is filled.

    Args:
        name: of the drawing, for people and errors.
        content: of the file.

    Raises:
        ConstructionError: it is no array of numbers with three dimensions, too large, or makes no structure.
    """
    stream = io.BytesIO(content)
    try:
        with warnings.catch_warnings():
            # The header is an expression of Python; what its parser minds of it is no matter of the user's.
            warnings.simplefilter("ignore")
            version = np.lib.format.read_magic(stream)
            first = version == (1, 0)
            read_header = np.lib.format.read_array_header_1_0 if first else np.lib.format.read_array_header_2_0
            shape, by_columns, dtype = read_header(stream)
    except _DAMAGED as error:
        raise ConstructionError(f"{name}: no NumPy array ({_short(error)})") from error
    if not all(type(side) is int and side.bit_length() <= _BITS for side in shape):
        raise ConstructionError(f"{name}: a side of the array is no whole number; accepted are 1 to {MOST_CELLS} cells")
    if len(shape) != _DIMENSIONS or dtype.kind not in _KINDS:
        raise ConstructionError(
            f"{name}: an array of shape {reprlib.repr(shape)} and type {str(dtype)[:_LONGEST]}; accepted are numbers "
            "by level, row and column"
        )
    levels, rows, columns = shape
    check_size(name, columns, rows, levels)
    begin, expected = stream.tell(), levels * rows * columns * dtype.itemsize
    if len(content) - begin < expected:
        raise ConstructionError(f"{name}: cut off: {len(content) - begin} bytes of cells, and there must be {expected}")
    # A truth value is a byte, and a damaged one neither 0 nor 1.
    stored = np.frombuffer(content, np.uint8 if dtype.kind == "b" else dtype, levels * rows * columns, begin)
    stored = stored.reshape(shape, order="F" if by_columns else "C")
    if dtype.kind == "f" and not np.isfinite(stored).all():
        raise ConstructionError(f"{name}: a cell is not finite; 0 is empty, anything else filled")
    return structure_of(name, stored != 0)


def write_npy(structure: Structure) -> bytes:
    """Write a ``.npy`` file of truth values."""
    stream = io.BytesIO()
    np.save(stream, filled_cells(structure), allow_pickle=False)
    return stream.getvalue()


def _short(error: Exception) -> str:
    return " ".join(str(error).split())[:_LONGEST] or type(error).__name__
