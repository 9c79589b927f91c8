"""A diagram level by level, as seen from above."""

from __future__ import annotations

from typing import List, Set, Tuple

from block_construction.diagram.block_set import PITCH, body_size
from block_construction.diagram.diagram import AssemblyDiagram, PlacedBlock
from block_construction.pictures.colours import block_key, block_tint
from rqt_mrta_py.hooks import Area, Drawing, DrawingPanel, Shape, Tint, Voxel, Words

__all__ = ["block_area", "level_drawing", "rectangle"]

_LIGHT = 0.35
_MOST_COLUMNS = 4


def rectangle(left: float, bottom: float, right: float, top: float) -> Tuple[Tuple[float, float], ...]:
    """Give the corners of a rectangle."""
    return ((left, bottom), (right, bottom), (right, top), (left, top))


def block_area(block: PlacedBlock, x: float, y: float, lightness: float) -> Area:
    """Give a block's body as seen from above.

    Args:
        block: of a diagram.
        x: of its middle.
        y: of its middle.
        lightness: of its colour.
    """
    body = body_size(block.units)
    along, across = body.length / 2.0, body.width / 2.0
    half_x, half_y = (along, across) if block.placement.length > 0 else (across, along)
    points = rectangle(x - half_x, y - half_y, x + half_x, y + half_y)
    return Area(points, block_tint(block.units, lightness), block_tint(block.units, -0.4))


def level_drawing(diagram: AssemblyDiagram) -> Drawing:
    """Draw each level: bodies in their slots, numbers of blocks, connection faults with the level above."""
    structure = diagram.structure
    faults = set(diagram.faults)
    panels = tuple(_level(diagram, level, faults) for level in range(1, structure.levels + 1))
    found = f"{len(diagram.blocks)} blocks, {len(faults)} connection faults"
    key = block_key([units for units, count in diagram.counts.items() if count], _LIGHT)
    if faults:
        key += ((Tint(Drawing.RED, 0.2), "connection fault with the level above"),)
    columns = min(_MOST_COLUMNS, len(panels))
    return Drawing("levels", f"{structure.name}: {found}, cost {diagram.cost}", panels, columns, key)


def _level(diagram: AssemblyDiagram, level: int, faults: Set[Voxel]) -> DrawingPanel:
    structure = diagram.structure
    width, depth = structure.columns * PITCH, structure.rows * PITCH
    shapes: List[Shape] = [Area(rectangle(0.0, 0.0, width, depth), Tint(Drawing.MUTED, 0.93), Tint(Drawing.MUTED, 0.6))]
    for y in range(structure.rows):
        for x in range(structure.columns):
            if structure.is_filled(x + 1, y + 1, level):
                cell = rectangle(x * PITCH, y * PITCH, (x + 1) * PITCH, (y + 1) * PITCH)
                fault = Voxel(x + 1, y + 1, level) in faults
                ground = Tint(Drawing.RED, 0.2) if fault else Tint(Drawing.MUTED, 0.75)
                shapes.append(Area(cell, ground, Tint(Drawing.MUTED, 0.5)))
    blocks = [block for block in diagram.blocks if block.placement.z == level]
    for block in blocks:
        shapes.append(block_area(block, block.x, block.y, _LIGHT))
        shapes.append(Words(block.x, block.y, str(block.number), room=PITCH))
    return DrawingPanel(f"level {level}: {len(blocks)} block{'s' * (len(blocks) != 1)}", tuple(shapes))
