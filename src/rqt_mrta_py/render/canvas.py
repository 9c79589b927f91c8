"""Shapes and words on a picture, placed with sub-pixel coordinates and antialiased."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple, Sequence, Tuple

import numpy as np

from rqt_mrta_py.render.libraries import opencv
from rqt_mrta_py.render.palette import Colour
from rqt_mrta_py.render.text import Style, ascent, halo_patch, patch, text_width

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Box", "Canvas", "Point", "label_size"]

_SHIFT = 4
_SCALE = 1 << _SHIFT

Point = Tuple[float, float]
"""x to the right, y down [pixels]."""


class Box(NamedTuple):
    """A rectangle of pixels: left and top belong to it, right and bottom do not."""

    left: float
    top: float
    right: float
    bottom: float

    @property
    def width(self) -> float:
        """Give the width [pixels]."""
        return self.right - self.left

    @property
    def height(self) -> float:
        """Give the height [pixels]."""
        return self.bottom - self.top

    @property
    def centre(self) -> Point:
        """Give the middle."""
        return (self.left + self.right) / 2.0, (self.top + self.bottom) / 2.0

    def inset(self, left: float, top: float, right: float, bottom: float) -> Box:
        """Give the rectangle that is left when margins [pixels] are cut off."""
        return Box(self.left + left, self.top + top, self.right - right, self.bottom - bottom)

    def meets(self, other: Box) -> bool:
        """Tell whether two rectangles share a pixel."""
        return (
            self.left < other.right and other.left < self.right and self.top < other.bottom and other.top < self.bottom
        )

    def holds(self, other: Box) -> bool:
        """Tell whether another rectangle lies wholly in this one."""
        return (
            self.left <= other.left
            and self.top <= other.top
            and other.right <= self.right
            and other.bottom <= self.bottom
        )


class Canvas:
    """A picture being drawn.

    Args:
        image: (height, width, 3), blue, green, red; drawn upon in place.
    """

    def __init__(self, image: NDArray[np.uint8]) -> None:
        self.image = image
        self._cv2 = opencv()

    def part(self, box: Box) -> Canvas:
        """Give a part of this picture, whose upper left corner is (0, 0) and beyond which nothing is drawn."""
        left, top, right, bottom = (max(round(edge), 0) for edge in box)
        return Canvas(self.image[top:bottom, left:right])

    def fill(self, box: Box, colour: Colour) -> None:
        """Fill a rectangle of whole pixels."""
        rows = slice(max(round(box.top), 0), max(round(box.bottom), 0))
        self.image[rows, max(round(box.left), 0) : max(round(box.right), 0)] = colour[::-1]

    def frame(self, box: Box, colour: Colour, width: int = 1) -> None:
        """Draw the border of a rectangle, inside it."""
        left, top, right, bottom = (round(edge) for edge in box)
        for edges in (
            Box(left, top, right, top + width),
            Box(left, bottom - width, right, bottom),
            Box(left, top, left + width, bottom),
            Box(right - width, top, right, bottom),
        ):
            self.fill(edges, colour)

    def line(self, points: Sequence[Point], colour: Colour, width: int = 1, closed: bool = False) -> None:
        """Draw a line through points."""
        self.strokes([points], colour, width, closed)

    def strokes(self, strokes: Sequence[Sequence[Point]], colour: Colour, width: int = 1, closed: bool = False) -> None:
        """Draw several lines in one colour; each is a sequence of points or an array (points, 2)."""
        fixed = [_fixed(points) for points in strokes]
        self._cv2.polylines(self.image, fixed, closed, colour[::-1], width, self._cv2.LINE_AA, _SHIFT)

    def dashes(self, start: Point, end: Point, colour: Colour, width: int = 1, dash: float = 6.0) -> None:
        """Draw a dashed straight line; dashes and gaps have the same length [pixels]."""
        first, last = np.array(start, dtype=np.float64), np.array(end, dtype=np.float64)
        length = float(np.hypot(*(last - first)))
        if length < 1.0:
            return
        starts = np.arange(0.0, length, 2.0 * dash)
        ends = np.minimum(starts + dash, length)
        step = (last - first) / length
        self.strokes([(first + a * step, first + b * step) for a, b in zip(starts, ends)], colour, width)

    def polygon(self, points: Sequence[Point], colour: Colour) -> None:
        """Fill a polygon."""
        self._cv2.fillPoly(self.image, [_fixed(points)], colour[::-1], self._cv2.LINE_AA, _SHIFT)

    def disc(self, centre: Point, radius: float, colour: Colour) -> None:
        """Fill a circle."""
        self._circle(centre, radius, colour, -1)

    def ring(self, centre: Point, radius: float, colour: Colour, width: int = 1) -> None:
        """Draw a circle."""
        self._circle(centre, radius, colour, width)

    def text(
        self,
        x: float,
        y: float,
        text: str,
        style: Style,
        colour: Colour,
        ground: Colour,
        anchor: float = 0.0,
    ) -> float:
        """Write on a flat ground.

        Args:
            x: where the words begin, or end, or have their middle.
            y: of the middle of capital letters.
            text: one line; nothing is written if it is empty.
            style: its look.
            colour: of the words.
            ground: colour of the ground; the words' rectangle is filled with it.
            anchor: 0 if x is the beginning, 0.5 the middle, 1 the end.

        Returns:
            The width taken [pixels].
        """
        if not text:
            return 0.0
        words, baseline = patch(text, style, colour, ground)
        left = round(x - anchor * words.shape[1])
        top = round(y + ascent(style) / 2.0) - baseline
        into, source = _overlap(self.image.shape, words.shape, left, top)
        self.image[into] = words[source]
        return float(words.shape[1])

    def label(self, box: Box, text: str, style: Style, colour: Colour, halo: Colour) -> None:
        """Write with a halo over anything, in the middle of a box."""
        added, kept, baseline = halo_patch(text, style, colour, halo)
        left = round((box.left + box.right - added.shape[1]) / 2.0)
        top = round((box.top + box.bottom + ascent(style)) / 2.0) - baseline
        into, source = _overlap(self.image.shape, added.shape, left, top)
        self.image[into] = (added[source] + kept[source] * self.image[into]) >> 8

    def _circle(self, centre: Point, radius: float, colour: Colour, width: int) -> None:
        x, y = round(centre[0] * _SCALE), round(centre[1] * _SCALE)
        self._cv2.circle(self.image, (x, y), round(radius * _SCALE), colour[::-1], width, self._cv2.LINE_AA, _SHIFT)


def label_size(text: str, style: Style) -> Tuple[int, int]:
    """Give the size of a label's box with a little air: width and height [pixels]."""
    return text_width(text, style) + 2, ascent(style) + 7


def _fixed(points: Sequence[Point]) -> NDArray[np.int32]:
    array = np.asarray(points, dtype=np.float64)
    return np.rint(np.clip(array, -9999.0, 9999.0) * _SCALE).astype(np.int32).reshape(-1, 1, 2)


def _overlap(
    image: Sequence[int], words: Sequence[int], left: int, top: int
) -> Tuple[Tuple[slice, slice], Tuple[slice, slice]]:
    """Cut words off at the picture's edges."""
    first_row, first_column = max(-top, 0), max(-left, 0)
    last_row, last_column = min(words[0], image[0] - top), min(words[1], image[1] - left)
    into = (slice(top + first_row, max(top + last_row, 0)), slice(left + first_column, max(left + last_column, 0)))
    return into, (slice(first_row, max(last_row, 0)), slice(first_column, max(last_column, 0)))
