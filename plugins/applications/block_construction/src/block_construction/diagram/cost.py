"""What a diagram costs: its connection faults and its blocks."""

from __future__ import annotations

from typing import Iterable, Sequence, Tuple

from block_construction.diagram.codes import FAULTS, cell_codes
from rqt_mrta_py.hooks import BlockPlacement, Voxel

__all__ = ["connection_faults", "diagram_cost"]


def connection_faults(placements: Iterable[BlockPlacement]) -> Tuple[Voxel, ...]:
    """List the cells that make a connection fault with the cell above them, sorted.

    Dantas (2017), equation 5.4: F_r is how many there are.
    """
    codes = cell_codes(placements)
    return tuple(
        sorted(cell for cell, code in codes.items() if (code, codes.get(cell._replace(z=cell.z + 1), 0)) in FAULTS)
    )


def diagram_cost(placements: Sequence[BlockPlacement]) -> int:
    """Give F_rb = F_r + F_b: connection faults and blocks, to be as few as can be.

    Dantas (2017), equation 5.5.
    """
    return len(connection_faults(placements)) + len(placements)
