"""Assembly diagrams as files: JSON that can be read again, and a table for people."""

from __future__ import annotations

import csv
import io
import math
from typing import Any, Dict, List, Mapping, Sequence

from block_construction.diagram.diagram import AssemblyDiagram, assembly_diagram
from block_construction.documents import parsed_document
from block_construction.errors import ConstructionError
from block_construction.structure.voxels import check_size
from rqt_mrta_py.hooks import BlockPlacement, Structure

__all__ = ["SCHEMA", "diagram_csv", "diagram_document", "read_diagram"]

SCHEMA = "rqt_mrta_py/assembly_diagram/1"
_LONGEST_NAME = 255
_KEYS = ("name", "heights", "lengths", "placements")
_PLACEMENT_KEYS = ("x", "y", "level", "length")


def diagram_document(diagram: AssemblyDiagram) -> Dict[str, Any]:
    """Give a diagram as plain JSON; ``read_diagram`` reads it."""
    return {
        "schema": SCHEMA,
        "name": diagram.structure.name,
        "heights": [list(row) for row in diagram.structure.heights],
        "lengths": list(diagram.lengths),
        "placements": [
            dict(zip(_PLACEMENT_KEYS, (each.x, each.y, each.z, each.length))) for each in diagram.placements
        ],
    }


def diagram_csv(diagram: AssemblyDiagram) -> str:
    """Write a diagram as the source's table: number, middle of the slot [m], orientation [degrees], type, layer, level.

    The origin is the corner of column 1 and row 1.
    """
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(("number", "x", "y", "z", "orientation_deg", "type", "layer", "level"))
    for block in diagram.blocks:
        middle = (f"{block.x:.3f}", f"{block.y:.3f}", f"{block.z:.3f}")
        orientation = round(math.degrees(block.yaw))
        writer.writerow((block.number, *middle, orientation, block.units, block.layer, block.placement.z))
    return stream.getvalue()


def read_diagram(name: str, text: str) -> AssemblyDiagram:
    """Read what ``diagram_document`` gives.

    Args:
        name: of the file, for errors.
        text: JSON.

    Raises:
        ConstructionError: it is no such document, or its blocks do not cover its structure; says where.
    """
    document = parsed_document(name, text, SCHEMA, _KEYS)
    heights = [_numbers(name, f"heights[{row}]", each) for row, each in enumerate(_items(name, document, "heights"))]
    if heights:
        check_size(
            name, max(map(len, heights)), len(heights), max(1, *(height for row in heights for height in row), 1)
        )
    called = document["name"]
    if not isinstance(called, str) or not called.isprintable() or not 1 <= len(called) <= _LONGEST_NAME:
        raise ConstructionError(
            f"{name}: name: must be one line of 1 to {_LONGEST_NAME} printable characters (found {ascii(called)[:80]})"
        )
    try:
        structure = Structure(called, tuple(map(tuple, heights)))
    except ValueError as error:
        raise ConstructionError(f"{name}: heights: {error}") from error
    placements: List[BlockPlacement] = []
    for number, each in enumerate(_items(name, document, "placements")):
        if not isinstance(each, Mapping):
            raise ConstructionError(
                f"{name}: placements[{number}]: must be an object with {', '.join(_PLACEMENT_KEYS)}"
            )
        values = _numbers(name, f"placements[{number}]", [each.get(key) for key in _PLACEMENT_KEYS])
        if not values[3]:
            raise ConstructionError(f"{name}: placements[{number}]: length must not be 0")
        placements.append(BlockPlacement(*values))
    lengths = _numbers(name, "lengths", _items(name, document, "lengths"))
    try:
        return assembly_diagram(structure, lengths, placements)
    except ConstructionError as error:
        raise ConstructionError(f"{name}: {error}") from error


def _items(name: str, document: Mapping[str, Any], key: str) -> Sequence[Any]:
    found = document[key]
    if not isinstance(found, list):
        raise ConstructionError(f"{name}: {key}: must be a list (found {type(found).__name__})")
    return found


def _numbers(name: str, where: str, found: Any) -> List[int]:
    if not isinstance(found, list) or any(type(value) is not int for value in found):
        raise ConstructionError(f"{name}: {where}: must be whole numbers (found {str(found)[:80]})")
    return found
