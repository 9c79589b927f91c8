"""In which order parts of a structure are built."""

from __future__ import annotations

from typing import Dict, List, Tuple

from block_construction.diagram.diagram import AssemblyDiagram

__all__ = ["Group", "build_groups"]

Group = Tuple[int, ...]
"""Numbers of the blocks of one concentric layer on one level; their order among themselves is free."""


def build_groups(diagram: AssemblyDiagram, *, level_first: bool = False) -> Tuple[Group, ...]:
    """Part a diagram's blocks into groups, in the order in which they are built.

    By default from the innermost layer out, and each layer from the bottom up: inner columns are reached while what
    lies outside of them is still empty, and every block lies on blocks of its own layer.

    Args:
        diagram: what is built.
        level_first: finish each level, from the innermost layer out, before the next is begun.

    Dantas (2017), section 5.4.
    Differs from the paper: it also says that no level is begun before the one below is whole, which contradicts the
    order of its own network; that is the order of ``level_first``.
    """
    groups: Dict[Tuple[int, int], List[int]] = {}
    for block in diagram.blocks:
        inward, level = -block.layer, block.placement.z
        groups.setdefault((level, inward) if level_first else (inward, level), []).append(block.number)
    return tuple(tuple(groups[key]) for key in sorted(groups))
