"""Structures as NumPy arrays: level, row, column."""

from __future__ import annotations

import io

import numpy as np

from block_construction.errors import ConstructionError
from block_construction.structure.voxels import MOST_CELLS, filled_cells, structure_of
from rqt_mrta_py.hooks import Structure

__all__ = ["read_npy", "write_npy"]

_DIMENSIONS = 3
_KINDS = "biuf"
"""Truth values, whole numbers and floats; what is not 0 is filled."""
_HEAD = 4096


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
        version = np.lib.format.read_magic(stream)
        read_header = np.lib.format.read_array_header_1_0 if version == (1, 0) else np.lib.format.read_array_header_2_0
        shape, _, dtype = read_header(stream)
    except (ValueError, EOFError) as error:
        raise ConstructionError(f"{name}: no NumPy array ({_short(error)})") from error
    if len(shape) != _DIMENSIONS or dtype.kind not in _KINDS:
        raise ConstructionError(
            f"{name}: an array of shape {shape} and type {dtype}; accepted are numbers by level, row and column"
        )
    cells = 1
    for side in shape:
        cells *= side
    if cells > MOST_CELLS:
        raise ConstructionError(f"{name}: {cells} cells; at most {MOST_CELLS} are accepted")
    try:
        stored = np.load(io.BytesIO(content), allow_pickle=False)
    except (ValueError, EOFError) as error:
        raise ConstructionError(f"{name}: the array is cut off or damaged ({_short(error)})") from error
    if dtype.kind == "f" and not np.isfinite(stored).all():
        raise ConstructionError(f"{name}: a cell is not finite; 0 is empty, anything else filled")
    return structure_of(name, stored != 0)


def write_npy(structure: Structure) -> bytes:
    """Write a ``.npy`` file of truth values."""
    stream = io.BytesIO()
    np.save(stream, filled_cells(structure), allow_pickle=False)
    return stream.getvalue()


def _short(error: Exception) -> str:
    return str(error).split("\n", maxsplit=1)[0][:120] or type(error).__name__
