"""A diagram as it will stand, seen from above its corner of column 1 and row 1."""

from __future__ import annotations

import math
from typing import Dict, Iterator, List, Mapping, Sequence, Tuple

from block_construction.diagram.diagram import AssemblyDiagram
from block_construction.pictures.colours import block_key, block_tint
from block_construction.structure.layers import cells_in_order
from rqt_mrta_py.hooks import Area, Drawing, DrawingPanel, Shape, Stroke, Voxel

__all__ = ["isometric_drawing", "project"]

_TOP, _FRONT, _LEFT = 0.55, 0.25, 0.0
"""How light the faces are: the more they look up."""
_EDGE = -0.55

_Place = Tuple[float, float, float]
_Step = Tuple[int, int, int]
_Steps = Tuple[_Step, ...]
_Line = Tuple[Tuple[float, float], Tuple[float, float]]

_FACES: Tuple[Tuple[_Steps, _Step, float], ...] = (
    (((0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)), (0, 0, 1), _TOP),
    (((0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1)), (0, -1, 0), _FRONT),
    (((0, 1, 0), (0, 0, 0), (0, 0, 1), (0, 1, 1)), (-1, 0, 0), _LEFT),
)
"""Corners of the three visible faces of a cell, where each looks to, how light it is."""


def project(place: _Place) -> Tuple[float, float]:
    """Give where a place [cells] is seen: x grows to the upper right, y to the upper left, z upwards."""
    x, y, z = place
    return (x - y) * math.cos(math.pi / 6.0), (x + y) * math.sin(math.pi / 6.0) + z


def isometric_drawing(diagram: AssemblyDiagram) -> Drawing:
    """Draw the whole structure, its blocks by colour."""
    owner = {cell: block for block in diagram.blocks for cell in block.placement.cells()}
    shapes: List[Shape] = []
    number_of: Dict[Voxel, int] = {cell: block.number for cell, block in owner.items()}
    # What is nearer comes later: first the farthest column, in it the farthest row, from the bottom up.
    for cell in sorted(cells_in_order(diagram.structure), key=lambda each: (-each.x, -each.y, each.z)):
        for corners, normal, lightness in _FACES:
            if _moved(cell, normal) not in number_of:
                places = tuple(project((cell.x + x, cell.y + y, cell.z + z)) for x, y, z in corners)
                tint = block_tint(owner[cell].units, lightness)
                shapes.append(Area(places, tint, tint))
                edge = block_tint(owner[cell].units, _EDGE)
                shapes += [Stroke(ends, edge, 2) for ends in _edges(cell, corners, normal, number_of)]
    title = f"{diagram.structure.name}: {len(diagram.blocks)} blocks on {diagram.structure.levels} levels"
    key = block_key([units for units, count in diagram.counts.items() if count])
    return Drawing("isometric", title, (DrawingPanel("", tuple(shapes)),), key=key)


def _edges(cell: Voxel, corners: _Steps, normal: _Step, number_of: Mapping[Voxel, int]) -> Iterator[_Line]:
    """Find the sides of a face where its block ends, or where another face rises from it."""
    for first, second in zip(corners, (*corners[1:], corners[0])):
        # Twice the way from the face's middle to the side's, so that it stays whole.
        outward = [2 * (first[axis] + second[axis]) - sum(corner[axis] for corner in corners) for axis in range(3)]
        beyond = _moved(cell, [(step > 0) - (step < 0) for step in outward])
        if number_of.get(beyond) != number_of[cell] or _moved(beyond, normal) in number_of:
            start, end = (project((cell.x + x, cell.y + y, cell.z + z)) for x, y, z in (first, second))
            yield start, end


def _moved(cell: Voxel, step: Sequence[int]) -> Voxel:
    return Voxel(cell.x + step[0], cell.y + step[1], cell.z + step[2])
