"""The network of automata, one for each filled cell, as arrays."""

from __future__ import annotations

from typing import TYPE_CHECKING, List, NamedTuple, Sequence, Tuple

import numpy as np

from block_construction.diagram.actions import actions_by_cell
from block_construction.diagram.codes import codes_of
from block_construction.structure.layers import layer_of
from rqt_mrta_py.hooks import BlockPlacement, Structure, Voxel

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Indices = NDArray[np.int64]

__all__ = ["Network", "network_of", "placements_of"]


class Network(NamedTuple):
    """Automata and their actions; n automata, A actions in all, C cells that actions cover in all.

    Automata are numbered as Dantas (2017), section 5.2, does, from 0; actions stand one automaton after the other.

    Attributes:
        first: where each automaton's actions begin, and where the last one's end, (n + 1,).
        lengths: signed length of each action's block, (A,).
        begin: where each action's cells begin, and where the last one's end, (A + 1,).
        cells: automata whose cells an action covers, its own first, (C,).
        codes: of these cells, (C,).
        above, below: the automaton of the cell above and below, or -1, (n,).
        level, layer: of each automaton's cell, (n,).
        column, row: of each automaton's cell, (n,).
    """

    first: Indices
    lengths: Indices
    begin: Indices
    cells: Indices
    codes: Indices
    above: Indices
    below: Indices
    level: Indices
    layer: Indices
    column: Indices
    row: Indices


def network_of(structure: Structure, lengths: Sequence[int]) -> Network:
    """Make the network of a structure.

    Args:
        structure: what shall be built.
        lengths: units of the blocks that there are, growing.
    """
    actions = actions_by_cell(structure, lengths)
    number = {cell: index for index, cell in enumerate(actions)}
    first, begin = [0], [0]
    signed: List[int] = []
    cells: List[int] = []
    codes: List[int] = []
    for cell, allowed in actions.items():
        for length in allowed:
            signed.append(length)
            cells += [number[covered] for covered in BlockPlacement(*cell, length).cells()]
            codes += codes_of(length)
            begin.append(len(cells))
        first.append(len(signed))
    above = [number.get(cell._replace(z=cell.z + 1), -1) for cell in actions]
    below = [number.get(cell._replace(z=cell.z - 1), -1) for cell in actions]
    layer = [layer_of(cell.x, cell.y, structure.columns, structure.rows) for cell in actions]
    columns = (
        *(first, signed, begin, cells, codes, above, below, [cell.z for cell in actions], layer),
        *([cell.x for cell in actions], [cell.y for cell in actions]),
    )
    return Network(*(np.array(column, dtype=np.int64) for column in columns))


def placements_of(network: Network, chosen: Sequence[int]) -> Tuple[BlockPlacement, ...]:
    """Give the blocks that selected automata chose.

    Args:
        network: of the structure.
        chosen: the action of each automaton, or -1 where a block of another's covers its cell.
    """
    return tuple(
        BlockPlacement(
            *Voxel(int(network.column[automaton]), int(network.row[automaton]), int(network.level[automaton])),
            int(network.lengths[action]),
        )
        for automaton, action in enumerate(chosen)
        if action >= 0
    )
