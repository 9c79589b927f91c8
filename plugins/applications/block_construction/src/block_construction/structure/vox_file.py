"""Structures as MagicaVoxel drawings (``.vox``).

Little endian: the magic ``VOX ``, a version, then chunks of id, bytes of content, bytes of children, content, children.
``MAIN`` holds ``SIZE`` and ``XYZI`` of each model; other chunks (colours, materials, scenes) say nothing here.
"""

from __future__ import annotations

import struct
from typing import Iterator, List, NamedTuple, Optional, Tuple

import numpy as np

from block_construction.errors import ConstructionError
from block_construction.structure.voxels import check_size, filled_cells, structure_of
from rqt_mrta_py.hooks import Structure

__all__ = ["LONGEST_SIDE", "read_vox", "write_vox"]

LONGEST_SIDE = 256
"""Cells of one side of a model, at the most."""

_MAGIC, _VERSION = b"VOX ", 150
_OLDEST, _NEWEST = 150, 299
_HEAD, _CHUNK, _SIZE, _COUNT = struct.Struct("<4si"), struct.Struct("<4sii"), struct.Struct("<iii"), struct.Struct("<i")
_VOXEL_BYTES = 4
_COLOUR = 1


class _Chunk(NamedTuple):
    id: bytes
    begin: int
    end: int
    content: memoryview


def read_vox(name: str, content: bytes) -> Structure:
    """Read a drawing with one model; any colour is filled.

    Args:
        name: of the drawing, for people and errors.
        content: of the file.

    Raises:
        ConstructionError: it is no such file, is cut off or contradicts itself, has several models or none, is too
            large, or its cells make no structure.
    """
    if len(content) < _HEAD.size:
        raise ConstructionError(f"{name}: {len(content)} bytes; a .vox file begins with {_MAGIC!r} and a version")
    magic, version = _HEAD.unpack_from(content)
    if magic != _MAGIC:
        raise ConstructionError(f"{name}: begins with {magic!r}; a .vox file begins with {_MAGIC!r}")
    if not _OLDEST <= version <= _NEWEST:
        raise ConstructionError(f"{name}: version {version}; accepted are {_OLDEST} to {_NEWEST}")
    view = memoryview(content)
    main = next(_chunks(name, view, _HEAD.size, len(content)), None)
    if main is None or main.id != b"MAIN":
        raise ConstructionError(f"{name}: the first chunk must be MAIN (found {'none' if main is None else main.id!r})")
    size: Optional[Tuple[int, int, int]] = None
    models: List[Tuple[Tuple[int, int, int], memoryview]] = []
    for chunk in _chunks(name, view, main.begin, main.end):
        if chunk.id == b"SIZE":
            if len(chunk.content) < _SIZE.size:
                raise ConstructionError(f"{name}: SIZE has {len(chunk.content)} bytes; it must have {_SIZE.size}")
            size = _SIZE.unpack_from(chunk.content)
        elif chunk.id == b"XYZI":
            if size is None:
                raise ConstructionError(f"{name}: XYZI without a SIZE before it")
            models.append((size, chunk.content))
            size = None
    if len(models) != 1:
        raise ConstructionError(f"{name}: holds {len(models)} models; accepted is one")
    return _structure(name, *models[0])


def write_vox(structure: Structure) -> bytes:
    """Write a drawing of 60 + 4 n bytes for n filled cells, lowest level first."""
    cells = np.argwhere(filled_cells(structure))
    if max(structure.columns, structure.rows, structure.levels) > LONGEST_SIDE:
        raise ConstructionError(
            f"{structure.name}: a .vox model measures at most {LONGEST_SIDE} cells a side; write .npy instead"
        )
    voxels = np.empty((len(cells), _VOXEL_BYTES), dtype=np.uint8)
    voxels[:, :3] = cells[:, ::-1]
    voxels[:, 3] = _COLOUR
    size = _chunk(b"SIZE", _SIZE.pack(structure.columns, structure.rows, structure.levels))
    filled = _chunk(b"XYZI", _COUNT.pack(len(cells)) + voxels.tobytes())
    return _HEAD.pack(_MAGIC, _VERSION) + _chunk(b"MAIN", b"", size + filled)


def _chunk(chunk_id: bytes, content: bytes, children: bytes = b"") -> bytes:
    return _CHUNK.pack(chunk_id, len(content), len(children)) + content + children


def _chunks(name: str, view: memoryview, begin: int, end: int) -> Iterator[_Chunk]:
    """Give the chunks of a stretch; ``begin`` and ``end`` of each are those of its children."""
    while begin < end:
        if end - begin < _CHUNK.size:
            raise ConstructionError(f"{name}: byte {begin}: {end - begin} bytes left, too few for a chunk")
        chunk_id, own, below = _CHUNK.unpack_from(view, begin)
        start = begin + _CHUNK.size
        if own < 0 or below < 0 or start + own + below > end:
            raise ConstructionError(
                f"{name}: byte {begin}: chunk {chunk_id!r} says {own} and {below} bytes; {end - start} are left"
            )
        yield _Chunk(chunk_id, start + own, start + own + below, view[start : start + own])
        begin = start + own + below


def _structure(name: str, size: Tuple[int, int, int], content: memoryview) -> Structure:
    columns, rows, levels = size
    check_size(name, columns, rows, levels)
    if len(content) < _COUNT.size:
        raise ConstructionError(f"{name}: XYZI has {len(content)} bytes; it must have at least {_COUNT.size}")
    (count,) = _COUNT.unpack_from(content)
    if count < 0 or _COUNT.size + count * _VOXEL_BYTES != len(content):
        room = len(content) - _COUNT.size
        raise ConstructionError(f"{name}: XYZI tells of {count} voxels but has {room} bytes; each takes {_VOXEL_BYTES}")
    voxels = np.frombuffer(content, dtype=np.uint8, offset=_COUNT.size).reshape(-1, _VOXEL_BYTES)
    outside = np.flatnonzero((voxels[:, :3] >= np.array(size)).any(axis=1))
    if len(outside):
        x, y, z = (voxels[outside[0], :3].astype(int) + 1).tolist()
        raise ConstructionError(
            f"{name}: the voxel at x {x}, y {y}, level {z} lies outside of its {columns} x {rows} x {levels} cells"
        )
    filled = np.zeros((levels, rows, columns), dtype=np.bool_)
    filled[voxels[:, 2], voxels[:, 1], voxels[:, 0]] = True
    return structure_of(name, filled)
