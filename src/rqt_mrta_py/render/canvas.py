"""Shapes and words on a picture, placed with sub-pixel coordinates and antialiased."""

from __future__ import annotations

from bisect import bisect_left
from typing import TYPE_CHECKING, List, Mapping, NamedTuple, Sequence, Tuple, Union

import numpy as np

from rqt_mrta_py.render.libraries import opencv
from rqt_mrta_py.render.palette import Colour
from rqt_mrta_py.render.text import Style, ascent, halo_patch, patch, text_width

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Box", "Canvas", "Point", "Points", "label_size"]

_SHIFT = 4
_SCALE = 1 << _SHIFT
# Further outside the picture fixed point would overflow [pixels].
_FAR = 9999.0
# Of a circle larger than this nobody sees the round; fixed point has an end [pixels].
_LARGEST = 2000.0
# From so many points on a line is slimmed, by less than a third of a pixel.
_LONG = 16
_SLACK = 0.3 * _SCALE

Point = Tuple[float, float]
"""x to the right, y down [pixels]."""

Points = Union[Sequence[Point], "NDArray[np.float64]"]
"""Of a line: one point after the other, or an array (points, 2)."""


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
        left, top, right, bottom = (round(edge) for edge in box)
        if right > left and bottom > top:
            self._cv2.rectangle(self.image, (left, top), (right - 1, bottom - 1), colour[::-1], -1)

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

    def line(self, points: Points, colour: Colour, width: int = 1, closed: bool = False) -> None:
        """Draw a line through points."""
        self._polylines([_fixed(points)], colour, width, closed)

    def strokes(self, strokes: Sequence[Points], colour: Colour, width: int = 1) -> None:
        """Draw several lines in one colour."""
        self._polylines([_fixed(points) for points in strokes], colour, width)

    def thin_lines(self, points: NDArray[np.float64], lengths: Sequence[int], colour: Colour) -> None:
        """Draw many lines in one colour, one pixel wide and not smoothed, as quickly as can be.

        Args:
            points: of all lines, one after the other (points, 2).
            lengths: how many points each line has.
            colour: of all.
        """
        fixed, start, pieces = _fixed(points) >> _SHIFT, 0, []
        for length in lengths:
            if length > 1:
                pieces.append(fixed[start : start + length])
            start += length
        self._cv2.polylines(self.image, pieces, False, colour[::-1], 1, self._cv2.LINE_8)

    def broken_lines(
        self, points: NDArray[np.float64], by_colour: Mapping[Colour, Sequence[Tuple[int, int]]], width: int = 1
    ) -> None:
        """Draw many lines, each broken wherever a point is not a number.

        Args:
            points: of all lines, one after the other (points, 2).
            by_colour: for each colour the first point of each of its lines, and the one after its last.
            width: of the lines [pixels].
        """
        gaps = np.flatnonzero(np.isnan(points[:, 1])).tolist()
        fixed = _fixed(points)
        for colour, lines in by_colour.items():
            pieces = []
            for start, end in lines:
                inside = gaps[bisect_left(gaps, start) : bisect_left(gaps, end)]
                edges = [start - 1, *inside, end]
                pieces += [fixed[before + 1 : after] for before, after in zip(edges, edges[1:]) if after > before + 1]
            self._polylines(pieces, colour, width)

    def dashes(self, left: float, right: float, y: float, colour: Colour, dash: int = 4) -> None:
        """Draw a dashed horizontal line, one pixel high; dashes and gaps have the same length [pixels]."""
        row = min(max(round(y), 0), self.image.shape[0] - 1)
        for begin in range(round(left), round(right), 2 * dash):
            self.image[row, begin : min(begin + dash, round(right))] = colour[::-1]

    def polygon(self, points: Points, colour: Colour) -> None:
        """Fill a polygon."""
        self._cv2.fillPoly(self.image, [_fixed(points)], colour[::-1], self._cv2.LINE_AA, _SHIFT)

    def disc(self, centre: Point, radius: float, colour: Colour) -> None:
        """Fill a circle."""
        self._circle(centre, radius, colour, -1)

    def ring(self, centre: Point, radius: float, colour: Colour, width: int = 1) -> None:
        """Draw a circle."""
        self._circle(centre, radius, colour, width)

    def text(  # noqa: PLR0917 - of words on a page, what, where and how read well in a row
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

    def upright_text(self, x: float, y: float, text: str, style: Style, *, colour: Colour, ground: Colour) -> None:
        """Write upwards on a flat ground, in the middle of a point."""
        words = np.rot90(patch(text, style, colour, ground)[0])
        left, top = round(x - words.shape[1] / 2.0), round(y - words.shape[0] / 2.0)
        into, source = _overlap(self.image.shape, words.shape, left, top)
        self.image[into] = words[source]

    def label(self, box: Box, text: str, style: Style, colour: Colour, halo: Colour) -> None:
        """Write with a halo over anything, in the middle of a box."""
        added, kept, baseline = halo_patch(text, style, colour, halo)
        left = round((box.left + box.right - added.shape[1]) / 2.0)
        top = round((box.top + box.bottom + ascent(style)) / 2.0) - baseline
        into, source = _overlap(self.image.shape, added.shape, left, top)
        ground = self.image[into]
        blended = np.multiply(kept[source], ground, dtype=np.uint16)
        blended += added[source]
        blended >>= 8
        ground[:] = blended

    def paste(self, left: int, top: int, picture: NDArray[np.uint8], shown: NDArray[np.bool_]) -> None:
        """Lay a small picture over this one where it is shown; both (height, width, 3)."""
        height, width, _ = picture.shape
        if left >= 0 and top >= 0:
            ground = self.image[top : top + height, left : left + width]
            if ground.shape == picture.shape:
                np.copyto(ground, picture, where=shown)
                return
        ground = self.image[max(top, 0) : max(top + height, 0), max(left, 0) : max(left + width, 0)]
        if ground.size:
            rows, columns, _ = ground.shape
            cut = np.s_[max(-top, 0) : max(-top, 0) + rows, max(-left, 0) : max(-left, 0) + columns]
            np.copyto(ground, picture[cut], where=shown[cut])

    def _polylines(self, lines: List[NDArray[np.int32]], colour: Colour, width: int, closed: bool = False) -> None:
        """Draw lines, long ones without the points that nobody would miss."""
        slim = [self._cv2.approxPolyDP(line, _SLACK, closed) if len(line) >= _LONG else line for line in lines]
        self._cv2.polylines(self.image, slim, closed, colour[::-1], width, self._cv2.LINE_AA, _SHIFT)

    def _circle(self, centre: Point, radius: float, colour: Colour, width: int) -> None:
        # Not a number compares as False.
        if not (abs(centre[0]) < _FAR and abs(centre[1]) < _FAR and radius > 0.0):
            return
        radius = min(radius, _LARGEST)
        x, y = round(centre[0] * _SCALE), round(centre[1] * _SCALE)
        self._cv2.circle(self.image, (x, y), round(radius * _SCALE), colour[::-1], width, self._cv2.LINE_AA, _SHIFT)


def label_size(text: str, style: Style) -> Tuple[int, int]:
    """Give the size of a label's box with a little air: width and height [pixels]."""
    return text_width(text, style) + 2, ascent(style) + 7


def _fixed(points: Points) -> NDArray[np.int32]:
    if not isinstance(points, np.ndarray):
        # A few numbers are turned sooner one by one.
        return np.array([(_fixed_number(x), _fixed_number(y)) for x, y in points], dtype=np.int32)
    # fmax and fmin also turn what is not a number into one.
    scaled: NDArray[np.float64] = np.fmin(np.fmax(points, -_FAR), _FAR)
    scaled *= _SCALE
    fixed: NDArray[np.int32] = np.rint(scaled, out=scaled).astype(np.int32)
    return fixed


def _fixed_number(value: float) -> int:
    # Not a number compares as False.
    return round(_SCALE * (value if -_FAR < value < _FAR else -_FAR if value < 0.0 else _FAR))


def _overlap(
    image: Sequence[int], words: Sequence[int], left: int, top: int
) -> Tuple[Tuple[slice, slice], Tuple[slice, slice]]:
    """Cut words off at the picture's edges."""
    first_row, first_column = max(-top, 0), max(-left, 0)
    last_row, last_column = min(words[0], image[0] - top), min(words[1], image[1] - left)
    into = (slice(top + first_row, max(top + last_row, 0)), slice(left + first_column, max(left + last_column, 0)))
    return into, (slice(first_row, max(last_row, 0)), slice(first_column, max(last_column, 0)))
