"""Small builds, whose ways can be told by hand."""

from __future__ import annotations

import math
from typing import Dict, Optional, Sequence, Tuple

from block_construction.diagram.diagram import assembly_diagram
from block_construction.execution.arena import Arena
from block_construction.execution.problem import BuildProblem
from block_construction.execution.supply import SupplyPlace

from rqt_mrta_py.hooks import BlockPlacement, Structure

ARENA = Arena()
CORNERS = ((0.2, 0.2), (2.0, 0.2), (0.2, 2.0), (2.0, 2.0))


def place(number: int, x: float, y: float, stock: Dict[int, Optional[int]]) -> SupplyPlace:
    return SupplyPlace(number, x, y, math.atan2(y - 1.1, x - 1.1), stock)


def problem(
    heights: Sequence[Sequence[int]],
    placements: Sequence[Tuple[int, int, int, int]],
    places: Optional[Sequence[SupplyPlace]] = None,
    **options: bool,
) -> BuildProblem:
    """Make a problem of heights, the first row being y = 1; by default places in all corners have everything."""
    structure = Structure("small", tuple(map(tuple, heights)))
    diagram = assembly_diagram(structure, (1, 2, 3), [BlockPlacement(*each) for each in placements])
    if places is None:
        stock: Dict[int, Optional[int]] = {1: None, 2: None, 3: None}
        places = [place(number, x, y, stock) for number, (x, y) in enumerate(CORNERS, 1)]
    return BuildProblem(diagram, places, ARENA, **options)


RING = [[1, 1, 1], [1, 0, 1], [1, 1, 1]]
RING_BLOCKS = [(1, 1, 1, 2), (3, 1, 1, -2), (2, 3, 1, 2), (1, 2, 1, -2)]
"""Two blocks along x and two along y around an empty cell, a pinwheel."""
