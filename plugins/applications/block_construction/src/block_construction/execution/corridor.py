"""The corridor that a block is brought along, between where the robot stands and the slot."""

from __future__ import annotations

from typing import Dict, Iterable, Iterator, NamedTuple, Optional, Tuple

from block_construction.diagram.block_set import PITCH
from block_construction.diagram.diagram import PlacedBlock
from block_construction.execution.approach import Side
from block_construction.execution.arena import Arena

__all__ = ["Top", "Tops", "corridor_cells", "neighbour", "obstacle", "put"]

Tops = Dict[Tuple[int, int], "Top"]
"""What is placed, by column and row."""


class Top(NamedTuple):
    """How high a column is built, and by which block."""

    level: int
    block: int


def put(tops: Tops, block: PlacedBlock) -> None:
    """Note that a block was placed."""
    for cell in block.placement.cells():
        tops[(cell.x, cell.y)] = Top(cell.z, block.number)


def obstacle(block: PlacedBlock, side: Side, tops: Tops, arena: Arena) -> Optional[int]:
    """Find what the carried block, or the gripper that holds it, would touch on its way into the slot.

    The block comes straight from where the robot stands, a little above its slot: whatever is built as high as the slot
    or higher is in its way, what is lower is not.

    Args:
        block: that is to be placed.
        side: it comes from.
        tops: what is placed.
        arena: says from how far.

    Returns:
        Number of the nearest such block; None if there is none.
    """
    return _first(block, side, tops, _distances(arena))


def corridor_cells(block: PlacedBlock, side: Side, arena: Arena) -> Iterator[Tuple[int, int]]:
    """List columns and rows that a block is brought along, from the slot out; some lie outside of the structure."""
    for distance in _distances(arena):
        for cell in block.placement.cells():
            yield cell.x + side.x * distance, cell.y + side.y * distance


def neighbour(block: PlacedBlock, side: Side, tops: Tops) -> Optional[int]:
    """Find a block as high as the slot of another, right beside it on one side; None if there is none."""
    return _first(block, side, tops, (1,))


def _distances(arena: Arena) -> Iterable[int]:
    return range(1, int(arena.stand_off / PITCH) + 1)


def _first(block: PlacedBlock, side: Side, tops: Tops, distances: Iterable[int]) -> Optional[int]:
    for distance in distances:
        for cell in block.placement.cells():
            top = tops.get((cell.x + side.x * distance, cell.y + side.y * distance))
            if top is not None and top.level >= cell.z and top.block != block.number:
                return top.block
    return None
