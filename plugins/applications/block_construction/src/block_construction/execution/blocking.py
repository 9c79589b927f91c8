"""Which blocks, once placed, would keep others from being placed (Dantas 2017, figures 35 and 36)."""

from __future__ import annotations

from typing import AbstractSet, Dict, Iterator, List, Mapping, NamedTuple, Sequence, Set, Tuple

from block_construction.diagram.diagram import PlacedBlock
from block_construction.execution.approach import Approach
from block_construction.execution.arena import Arena
from block_construction.execution.corridor import corridor_cells
from block_construction.execution.ways import Ground

__all__ = ["Before", "Blocking", "in_corridors", "on_stands", "ordered"]

Before = Dict[int, Set[int]]
"""What must be placed before each block, by its number."""


class Blocking(NamedTuple):
    """One block that another would keep from being placed.

    Attributes:
        first: number of the block that must be placed first.
        then: number of the one in whose way it would be.
    """

    first: int
    then: int


def in_corridors(blocks: Sequence[PlacedBlock], approaches: Sequence[Approach], arena: Arena) -> Iterator[Blocking]:
    """Find what would lie in the way of a carried block; what is higher there lies on that anyway.

    Args:
        blocks: of which each may be in the way of each other.
        approaches: from where they are placed.
        arena: says from how far.
    """
    owners = {(cell.x, cell.y, cell.z): block.number for block in blocks for cell in block.placement.cells()}
    for block, approach in zip(blocks, approaches):
        for x, y in corridor_cells(block, approach.side, arena):
            other = owners.get((x, y, block.placement.z))
            if other is not None and other != block.number:
                yield Blocking(block.number, other)


def on_stands(
    blocks: Sequence[PlacedBlock], approaches: Sequence[Approach], covers: Sequence[int], ground: Ground
) -> Iterator[Blocking]:
    """Find what would lie where the robot stands to place a block.

    Args:
        blocks: of which each may be in the way of each other.
        approaches: from where they are placed.
        covers: columns and rows that each lies on, as for ``Ground.free``.
        ground: the floor.
    """
    stands = [ground.cell_of(approach.point) for approach in approaches]
    free = {covered: ground.free(covered) for covered in set(covers)}
    for block, stand in zip(blocks, stands):
        for other, covered in zip(blocks, covers):
            if other.number != block.number and not free[covered][stand]:
                yield Blocking(block.number, other.number)


def ordered(before: Mapping[int, AbstractSet[int]]) -> Tuple[int, ...]:
    """Order blocks so that each comes after all that must be placed before it.

    Args:
        before: what must, by number, for all blocks.

    Returns:
        Numbers; those of a circle, and what comes after one, are left out.
    """
    left = {number: set(earlier) for number, earlier in before.items()}
    order: List[int] = []
    while True:
        ready = next((number for number, earlier in left.items() if not earlier), None)
        if ready is None:
            return tuple(order)
        del left[ready]
        for earlier in left.values():
            earlier.discard(ready)
        order.append(ready)
