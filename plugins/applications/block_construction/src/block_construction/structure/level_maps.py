"""Structures as text: one map a level, as one would draw them on squared paper."""

from __future__ import annotations

from typing import List

import numpy as np

from block_construction.errors import ConstructionError
from block_construction.structure.voxels import check_size, filled_cells, structure_of
from rqt_mrta_py.hooks import Structure

__all__ = ["read_level_maps", "write_level_maps"]

_FILLED, _EMPTY, _COMMENT = "#", ".", ";"


def read_level_maps(name: str, text: str) -> Structure:
    """Read level maps: ``#`` filled, ``.`` empty, the top line of a map is its greatest y.

    Maps follow one another from level 1 upwards, with an empty line between them. A line that begins with ``;`` is a
    comment.

    Args:
        name: of the drawing, for people and errors.
        text: the maps.

    Raises:
        ConstructionError: a line has another character or another length, a map another number of lines, or the cells
            make no structure.
    """
    maps: List[List[str]] = [[]]
    for number, raw in enumerate(text.splitlines(), 1):
        line = raw.strip()
        if line.startswith(_COMMENT):
            continue
        if not line:
            if maps[-1]:
                maps.append([])
            continue
        wrong = next((character for character in line if character not in (_FILLED, _EMPTY)), None)
        if wrong is not None:
            raise ConstructionError(
                f"{name}:{number}: {wrong!r} in a map; accepted are {_FILLED!r} (filled) and {_EMPTY!r} (empty)"
            )
        width = len(maps[0][0]) if maps[0] else len(line)
        if len(line) != width:
            raise ConstructionError(f"{name}:{number}: {len(line)} cells in a line; the first line has {width}")
        maps[-1].append(line)
    if not maps[-1]:
        maps.pop()
    if not maps:
        raise ConstructionError(f"{name}: holds no map; a map has lines of {_FILLED!r} and {_EMPTY!r}")
    for level, lines in enumerate(maps, 1):
        if len(lines) != len(maps[0]):
            raise ConstructionError(
                f"{name}: the map of level {level} has {len(lines)} lines; level 1 has {len(maps[0])}"
            )
    check_size(name, len(maps[0][0]), len(maps[0]), len(maps))
    cells = np.array([[[cell == _FILLED for cell in line] for line in reversed(lines)] for lines in maps])
    return structure_of(name, cells)


def write_level_maps(structure: Structure) -> str:
    """Write level maps, ended by a newline."""
    maps = [
        "\n".join("".join(_FILLED if cell else _EMPTY for cell in row) for row in reversed(level))
        for level in filled_cells(structure).tolist()
    ]
    return "\n\n".join(maps) + "\n"
