"""Drawings: plans and views made of areas, strokes and words; data only, never pixels."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, NamedTuple, Optional, Tuple, Union

__all__ = ["Area", "Drawing", "DrawingPanel", "Shape", "Stroke", "Tint", "Words"]

Places = Tuple[Tuple[float, float], ...]


class Tint(NamedTuple):
    """A colour.

    Attributes:
        colour: an index into the palette that all pictures share, whose first is blue, or one of ``Drawing``'s.
        lightness: from -1, which is ink, by 0, the colour itself, to 1, which is white.
    """

    colour: int
    lightness: float = 0.0


class Area(NamedTuple):
    """A filled polygon.

    Attributes:
        points: its corners, in the panel's own unit; y goes up.
        fill: of what is inside.
        edge: of the line around it; None for none.
    """

    points: Places
    fill: Tint
    edge: Optional[Tint] = None


class Stroke(NamedTuple):
    """A line from point to point.

    Attributes:
        points: as for an area.
        tint: of the line.
        width: of the line [pixels].
    """

    points: Places
    tint: Tint
    width: int = 1


class Words(NamedTuple):
    """A short text around a point, left out where it has no room.

    Attributes:
        x, y: its middle, in the panel's own unit.
        text: one line.
        room: how wide it may be, in the panel's own unit; None: as wide as it is.
        tint: of the letters.
        size: of the letters [pixels].
    """

    x: float
    y: float
    text: str
    room: Optional[float] = None
    tint: Tint = Tint(-2)
    size: int = 13


Shape = Union[Area, Stroke, Words]


@dataclass(frozen=True)
class DrawingPanel:
    """One of the parts of a drawing, which lie side by side.

    Attributes:
        title: above it; empty for none.
        shapes: what comes later covers what comes before.
    """

    title: str
    shapes: Tuple[Shape, ...]


@dataclass(frozen=True)
class Drawing:
    """One picture, all of whose panels have one scale.

    Attributes:
        name: of its file, without ending: letters, digits, ``_`` and ``-``.
        title: above all.
        panels: row by row from the upper left.
        columns: how many panels are in a row.
        key: what colours mean, in order, below the title.
    """

    RED: ClassVar[int] = -1
    INK: ClassVar[int] = -2
    MUTED: ClassVar[int] = -3

    name: str
    title: str
    panels: Tuple[DrawingPanel, ...]
    columns: int = 1
    key: Tuple[Tuple[Tint, str], ...] = ()
