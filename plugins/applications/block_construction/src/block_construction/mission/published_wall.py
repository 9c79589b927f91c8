"""The source's own plan for the wall, which its real robot carried out (Dantas 2017, table 19).

Of each block the table gives the middle of its slot [cm], an angle and its type; there is one supply place at
(280, 100) cm, which has all types. Cells are 8 cm wide from (138, 84) cm on, so that the structure's middle is
(150, 100) cm: the arena that this is the middle of measures 3 m along x, and the place lies 0.2 m before its wall.

Differs from the paper: our arenas are squares, so that all y are 0.5 m more; and the place's angle of 90 degrees is
taken for that of the blocks that lie there, for a robot that looked there in that direction could not come from the
site. Angles of two blocks of level 2 contradict the cells that they must cover; cells decide.
"""

from __future__ import annotations

from typing import Tuple

from block_construction.diagram.block_set import DEFAULT_LENGTHS
from block_construction.diagram.diagram import AssemblyDiagram, assembly_diagram
from block_construction.execution.arena import Arena
from block_construction.execution.problem import Step
from block_construction.execution.supply import SupplyPlace
from block_construction.execution.supply_file import Supply
from block_construction.structure.library import library_structure
from rqt_mrta_py.hooks import BlockPlacement

__all__ = ["WALL_ORDER", "wall_diagram", "wall_steps", "wall_supply"]

WALL_ORDER: Tuple[BlockPlacement, ...] = (
    BlockPlacement(1, 4, 1, 2),
    BlockPlacement(3, 2, 1, -3),
    BlockPlacement(1, 1, 1, 3),
    BlockPlacement(3, 1, 2, -3),
    BlockPlacement(2, 4, 2, 2),
    BlockPlacement(2, 1, 2, 1),
)
"""Blocks in the order in which they are placed: table 19 from (146, 112, 4) to (150, 88, 12) cm."""


def wall_diagram() -> AssemblyDiagram:
    """Give the diagram that the plan builds."""
    return assembly_diagram(library_structure("wall"), DEFAULT_LENGTHS, WALL_ORDER)


def wall_supply() -> Supply:
    """Give the arena and its one supply place."""
    arena = Arena(side=3.0, start=(1.5, 0.3))
    return Supply(arena, (SupplyPlace(1, 2.80, 1.50, 0.0, dict.fromkeys(DEFAULT_LENGTHS)),))


def wall_steps() -> Tuple[Step, ...]:
    """Give the plan: everything is fetched from the one place."""
    numbers = {block.placement: block.number for block in wall_diagram().blocks}
    return tuple(Step(1, numbers[placement]) for placement in WALL_ORDER)
