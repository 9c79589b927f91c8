"""The structures that come with the package, as heights of their columns.

Of the source's structures only the wall is known from listed positions; the shapes of the others were found from their
numbers of cells, layers, levels and blocks. The space station is a stand-in with as many cells, layers and levels.
"""

from __future__ import annotations

from typing import Callable, Dict, Tuple

from block_construction.errors import ConstructionError
from block_construction.structure.layers import layer_of
from rqt_mrta_py.hooks import Structure

__all__ = ["library_structure", "structure_names"]

_Heights = Tuple[Tuple[int, ...], ...]

_DRAWN: Dict[str, Tuple[str, ...]] = {
    "wall": ("122", "002", "002", "122"),
    "tower": ("334433", "300003", "300003", "400004", "400004", "300003", "300003", "334433"),
    "dam": ("1000001", "2000002", "3000003", "4000004", "4444444"),
    "station": (
        "00011000",
        "00022000",
        "00111100",
        "12144121",
        "12144121",
        "00111100",
        "00022000",
        "00011000",
    ),
    "station_b": (
        "00022000",
        "00011000",
        "02111100",
        "21122112",
        "21144112",
        "10111101",
        "00011000",
        "00022000",
    ),
}
"""A digit tells how many levels of a column are filled; the top line is the greatest y."""


def _ring(side: int, levels: int) -> _Heights:
    edge = (0, side - 1)
    return tuple(tuple(levels if x in edge or y in edge else 0 for x in range(side)) for y in range(side))


def _pyramid(side: int) -> _Heights:
    return tuple(tuple(layer_of(x, y, side, side) for x in range(1, side + 1)) for y in range(1, side + 1))


_MADE: Dict[str, Callable[[], _Heights]] = {
    "cistern": lambda: _ring(7, 4),
    "pyramid": lambda: _pyramid(8),
    "vertical_extension": lambda: _ring(7, 14),
    "horizontal_extension": lambda: _ring(31, 4),
}


def structure_names() -> Tuple[str, ...]:
    """List the names of the structures that come with the package, sorted."""
    return tuple(sorted((*_DRAWN, *_MADE)))


def library_structure(name: str) -> Structure:
    """Give a structure that comes with the package.

    Args:
        name: one of ``structure_names``.

    Raises:
        ConstructionError: there is none of that name.
    """
    if name in _MADE:
        return Structure(name, _MADE[name]())
    if name in _DRAWN:
        return Structure(name, tuple(tuple(map(int, line)) for line in reversed(_DRAWN[name])))
    raise ConstructionError(
        f"structure {name!r}: none comes under this name; there are: {', '.join(structure_names())}"
    )
