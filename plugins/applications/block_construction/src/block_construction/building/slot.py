"""What a task of kind ``place_block`` says of its block: where it belongs, and where such blocks are fetched."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Mapping, NamedTuple, Tuple

from block_construction.diagram.block_set import BODY_HEIGHT
from rqt_mrta_py.model import Pose, Task

__all__ = ["KIND", "BlockTask", "Cell", "Fetch", "block_task"]

KIND = "place_block"
"""Of tasks that place a block."""

Cell = Tuple[int, int]
"""Column and row."""

_NUMBERS = ("x", "y", "yaw", "heading", "arena")


class Fetch(NamedTuple):
    """Where a block waits to be fetched.

    Attributes:
        group: number of the place's group, which one robot at a time uses.
        x, y: middle of the block [m].
        heading: of the robot that fetches it [rad].
    """

    group: int
    x: float
    y: float
    heading: float

    @property
    def facing(self) -> Pose:
        """The block, as a robot that fetches it faces it [m, rad]."""
        return Pose(self.x, self.y, self.heading)


@dataclass(frozen=True)
class BlockTask:
    """A block that is to be placed.

    Attributes:
        block: its number in the diagram.
        units: how long it is.
        level: 1, 2, ...
        x, y: middle of its slot [m].
        yaw: of its long axis [rad].
        heading: of the robot that places it [rad].
        cells: that it covers.
        supply: where such blocks are fetched.
        site: left, bottom, right and top of the structure [m].
        arena: side of the square around it [m].
    """

    block: int
    units: int
    level: int
    x: float
    y: float
    yaw: float
    heading: float
    cells: Tuple[Cell, ...]
    supply: Tuple[Fetch, ...]
    site: Tuple[float, float, float, float]
    arena: float

    @property
    def kind(self) -> str:
        """Of the bodies that belong into it, as detectors tell it: block1, block2, ..."""
        return f"block{self.units}"

    @property
    def z(self) -> float:
        """Height of the block's middle once it lies in its slot [m]."""
        return BODY_HEIGHT * (self.level - 0.5)

    @property
    def facing(self) -> Pose:
        """The slot, as a robot that places there faces it [m, rad]."""
        return Pose(self.x, self.y, self.heading)


def block_task(task: Task) -> BlockTask:
    """Read what a task says.

    Args:
        task: of kind ``place_block``.

    Raises:
        ValueError: its data lack something, or hold what makes no sense; names the key, what was found and what is
            accepted.
    """
    data = task.data
    x, y, yaw, heading, arena = (_number(data, name) for name in _NUMBERS)
    if not arena > 0.0:
        raise ValueError(f"data: arena: must be above 0 m (found {arena:g})")
    return BlockTask(
        block=_whole(data, "block"),
        units=_whole(data, "units"),
        level=_whole(data, "level"),
        x=x,
        y=y,
        yaw=yaw,
        heading=heading,
        cells=tuple([(int(column), int(row)) for column, row in _rows(data, "cells", 2)]),
        supply=tuple([Fetch(int(group), *place) for group, *place in _rows(data, "supply", 4)]),
        site=_site(data),
        arena=arena,
    )


def _value(data: Mapping[str, Any], name: str) -> Any:
    if name not in data:
        raise ValueError(f"data: {name}: missing; tasks of kind place_block need it")
    return data[name]


def _number(data: Mapping[str, Any], name: str) -> float:
    return _finite(name, _value(data, name))


def _finite(name: str, value: Any) -> float:
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value):
        raise ValueError(f"data: {name}: must be a finite number (found {value!r})")
    return float(value)


def _whole(data: Mapping[str, Any], name: str) -> int:
    value: object = _value(data, name)
    if isinstance(value, bool) or not isinstance(value, int) or not 1 <= value <= 65535:
        raise ValueError(f"data: {name}: must be a whole number from 1 to 65535 (found {value!r})")
    return value


def _rows(data: Mapping[str, Any], name: str, length: int) -> Tuple[Tuple[float, ...], ...]:
    rows = _value(data, name)
    fits = isinstance(rows, (list, tuple)) and rows
    if not fits or not all(isinstance(row, (list, tuple)) and len(row) == length for row in rows):
        raise ValueError(f"data: {name}: must be a list of lists of {length} numbers (found {rows!r})")
    return tuple([tuple([_finite(name, value) for value in row]) for row in rows])


def _site(data: Mapping[str, Any]) -> Tuple[float, float, float, float]:
    left, bottom, right, top = _rows({"site": [_value(data, "site")]}, "site", 4)[0]
    if not (left < right and bottom < top):
        raise ValueError(f"data: site: must be left, bottom, right and top (found {data['site']!r})")
    return left, bottom, right, top
