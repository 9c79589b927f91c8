"""Autonomous construction: what shall be built, and who decides which block goes where."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable, Iterator, Mapping, NamedTuple, Tuple

__all__ = ["AssemblyOutcome", "AssemblyPlanner", "AssemblyRequest", "BlockPlacement", "Structure", "Voxel"]


class Voxel(NamedTuple):
    """One cell of a structure; x counts columns, y rows and z levels from 1."""

    x: int
    y: int
    z: int


class BlockPlacement(NamedTuple):
    """Where a block lies: its first cell, and how far it reaches from there.

    Attributes:
        x, y, z: column, row and level of its left or lower cell, from 1.
        length: units of the block; above 0 it lies along x, below 0 along y. A block of one unit has length 1.
    """

    x: int
    y: int
    z: int
    length: int

    @property
    def units(self) -> int:
        """How many cells it covers."""
        return abs(self.length)

    def cells(self) -> Iterator[Voxel]:
        """List what it covers, from its first cell on."""
        for step in range(abs(self.length)):
            if self.length > 0:
                yield Voxel(self.x + step, self.y, self.z)
            else:
                yield Voxel(self.x, self.y + step, self.z)


@dataclass(frozen=True)
class Structure:
    """What shall be built, cell by cell; no cell floats, so that heights tell everything.

    Attributes:
        name: for people.
        heights: of each row y = 1, 2, ..., of each column x = 1, 2, ...: how many levels are filled, from the floor on.

    Raises:
        ValueError: there are no columns or rows, rows differ in length, a height is negative, or nothing is filled.
    """

    name: str
    heights: Tuple[Tuple[int, ...], ...]

    def __post_init__(self) -> None:
        if not self.heights or not self.heights[0]:
            raise ValueError(f"structure {self.name}: has no cells")
        if any(len(row) != len(self.heights[0]) for row in self.heights):
            raise ValueError(f"structure {self.name}: its rows differ in length")
        if any(height < 0 for row in self.heights for height in row):
            raise ValueError(f"structure {self.name}: a height is negative")
        if not any(height for row in self.heights for height in row):
            raise ValueError(f"structure {self.name}: nothing is filled")

    @property
    def columns(self) -> int:
        """How many cells it measures along x."""
        return len(self.heights[0])

    @property
    def rows(self) -> int:
        """How many cells it measures along y."""
        return len(self.heights)

    @property
    def levels(self) -> int:
        """How many levels have anything."""
        return max(height for row in self.heights for height in row)

    @property
    def size(self) -> int:
        """How many cells are filled."""
        return sum(height for row in self.heights for height in row)

    def is_filled(self, x: int, y: int, z: int) -> bool:
        """Tell whether a cell is filled; outside of the structure none is."""
        inside = 1 <= x <= self.columns and 1 <= y <= self.rows and z >= 1
        return inside and z <= self.heights[y - 1][x - 1]


@dataclass(frozen=True)
class AssemblyRequest:
    """What a planner is asked.

    Attributes:
        structure: what shall be built.
        lengths: units of the blocks that there are, growing, 1 among them.
        seed: of all chance.
        settings: the planner's own, complete: a value for each of its ``defaults``.
        on_progress: is told now and then which part of the work is done, from 0 to 1.
    """

    structure: Structure
    lengths: Tuple[int, ...]
    seed: int
    settings: Mapping[str, Any]
    on_progress: Callable[[float], None] = lambda _: None


@dataclass(frozen=True)
class AssemblyOutcome:
    """What a planner answers.

    Attributes:
        placements: cover each filled cell of the structure once, none across two concentric layers; in any order.
        proved: whether no other placements cost less.
        costs: of what was tried, in order; empty where nothing was tried.
        convergence: after each trial the mean over the automata that chose in it of their greatest probability; empty
            where there are none.
    """

    placements: Tuple[BlockPlacement, ...]
    proved: bool = False
    costs: Tuple[int, ...] = ()
    convergence: Tuple[float, ...] = ()


@dataclass(frozen=True)
class AssemblyPlanner:
    """A method of deciding which block goes where.

    Attributes:
        help: one line, as ``mrta plan-structure --help`` shows it.
        plan: does it; the same request has the same answer.
        defaults: its settings with their default values; a given value must be of the default's type.
        prepare: is asked before ``plan``, with the same request, for what is done once in a process, such as importing
            and compiling: the seconds that are told of planning are those of ``plan`` alone.
    """

    help: str
    plan: Callable[[AssemblyRequest], AssemblyOutcome]
    defaults: Mapping[str, Any]
    prepare: Callable[[AssemblyRequest], None] = lambda _: None
