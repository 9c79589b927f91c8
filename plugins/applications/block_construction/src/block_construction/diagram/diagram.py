"""The assembly diagram: which block lies where."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Dict, Iterable, NamedTuple, Set, Tuple

from block_construction.diagram.block_set import PITCH, block_lengths
from block_construction.diagram.cost import connection_faults, diagram_cost
from block_construction.errors import ConstructionError
from block_construction.structure.layers import cells_in_order, layer_of
from rqt_mrta_py.hooks import BlockPlacement, Structure, Voxel

__all__ = ["AssemblyDiagram", "PlacedBlock", "assembly_diagram"]


class PlacedBlock(NamedTuple):
    """One row of an assembly diagram.

    Attributes:
        number: 1, 2, ... in the order of the diagram.
        placement: the cells.
        layer: concentric layer.
        x, y: middle of its slot, from the corner of column 1 and row 1 [m].
        z: middle of its slot above the floor, with levels one pitch high [m].
        yaw: 0 along x, a quarter turn along y [rad].
    """

    number: int
    placement: BlockPlacement
    layer: int
    x: float
    y: float
    z: float
    yaw: float

    @property
    def units(self) -> int:
        """How many cells it covers."""
        return self.placement.units


@dataclass(frozen=True)
class AssemblyDiagram:
    """Blocks that cover a structure (Dantas 2017, section 5.1: D_A).

    Attributes:
        structure: what they cover.
        lengths: units of the blocks that there were, growing.
        blocks: by level, from the outermost layer in, by row and column of their first cell.
    """

    structure: Structure
    lengths: Tuple[int, ...]
    blocks: Tuple[PlacedBlock, ...]

    @property
    def placements(self) -> Tuple[BlockPlacement, ...]:
        """The blocks' cells, in the order of the diagram."""
        return tuple(block.placement for block in self.blocks)

    @property
    def faults(self) -> Tuple[Voxel, ...]:
        """Cells that make a connection fault with the one above."""
        return connection_faults(self.placements)

    @property
    def cost(self) -> int:
        """Faults and blocks, F_rb."""
        return diagram_cost(self.placements)

    @property
    def counts(self) -> Dict[int, int]:
        """How many blocks of each length there are, by length, growing; 0 where none is used."""
        return {length: sum(block.units == length for block in self.blocks) for length in self.lengths}


def assembly_diagram(
    structure: Structure, lengths: Iterable[int], placements: Iterable[BlockPlacement]
) -> AssemblyDiagram:
    """Check placements and put them into the order of the diagram.

    Args:
        structure: what they shall cover.
        lengths: units of the blocks that there are.
        placements: in any order.

    Raises:
        ConstructionError: a block has a length that there is not, covers what is not filled, what another block
            covers, or cells of two layers, or a filled cell is left uncovered; names block and cell.
    """
    allowed = block_lengths(lengths)
    columns, rows = structure.columns, structure.rows
    taken: Set[Voxel] = set()
    listed = [each._replace(length=1) if each.length == -1 else each for each in placements]
    for each in listed:
        label = f"block of {each.units} at x {each.x}, y {each.y}, level {each.z}"
        if each.units not in allowed:
            raise ConstructionError(f"{label}: there are blocks of {', '.join(map(str, allowed))} units only")
        for cell in each.cells():
            where = f"{label}: cell x {cell.x}, y {cell.y}, level {cell.z}"
            if not structure.is_filled(*cell):
                raise ConstructionError(f"{where} is not part of {structure.name}")
            if cell in taken:
                raise ConstructionError(f"{where} is covered by another block already")
            if layer_of(cell.x, cell.y, columns, rows) != layer_of(each.x, each.y, columns, rows):
                raise ConstructionError(f"{where} is of another concentric layer than the block's first cell")
            taken.add(cell)
    order = cells_in_order(structure)
    left = next((cell for cell in order if cell not in taken), None)
    if left is not None:
        raise ConstructionError(f"{structure.name}: no block covers cell x {left.x}, y {left.y}, level {left.z}")
    rank = {cell: number for number, cell in enumerate(order)}
    listed.sort(key=lambda each: rank[Voxel(each.x, each.y, each.z)])
    blocks = tuple(_row(number, each, columns, rows) for number, each in enumerate(listed, 1))
    return AssemblyDiagram(structure, allowed, blocks)


def _row(number: int, placement: BlockPlacement, columns: int, rows: int) -> PlacedBlock:
    along_x = placement.length > 0
    half = placement.units / 2.0
    x = (placement.x - 1 + (half if along_x else 0.5)) * PITCH
    y = (placement.y - 1 + (0.5 if along_x else half)) * PITCH
    layer = layer_of(placement.x, placement.y, columns, rows)
    return PlacedBlock(number, placement, layer, x, y, (placement.z - 0.5) * PITCH, 0.0 if along_x else math.pi / 2.0)
