"""What may be placed at a cell: the actions of its automaton."""

from __future__ import annotations

from typing import Dict, Sequence, Tuple

from block_construction.structure.layers import cells_in_order, layer_of
from rqt_mrta_py.hooks import BlockPlacement, Structure, Voxel

__all__ = ["action_lengths", "actions_by_cell"]


def action_lengths(lengths: Sequence[int]) -> Tuple[int, ...]:
    """List the actions that blocks allow: 1, 2, 3, -2, -3 for blocks of one, two and three units.

    Along x is above 0, along y below; for one unit both are the same.
    """
    return (*lengths, *(-length for length in lengths if length > 1))


def actions_by_cell(structure: Structure, lengths: Sequence[int]) -> Dict[Voxel, Tuple[int, ...]]:
    """List for each filled cell, in the order of automata, the signed lengths of blocks that may begin there.

    A block may begin at a cell if all that it covers is filled and of one concentric layer. Whether another block lies
    there already is not asked.

    Args:
        structure: what shall be built.
        lengths: units of the blocks that there are, growing.

    Dantas (2017), section 5.2.
    """
    columns, rows = structure.columns, structure.rows
    found: Dict[Voxel, Tuple[int, ...]] = {}
    for cell in cells_in_order(structure):
        layer = layer_of(cell.x, cell.y, columns, rows)
        found[cell] = tuple(
            length
            for length in action_lengths(lengths)
            if all(
                structure.is_filled(*covered) and layer_of(covered.x, covered.y, columns, rows) == layer
                for covered in BlockPlacement(*cell, length).cells()
            )
        )
    return found
