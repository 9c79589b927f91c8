"""Pictures in layers: parts drawn upon what lies below, and pictures printed of what they show together."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Dict, List, Optional, Sequence

import numpy as np

from rqt_mrta_py.render.canvas import Box, Canvas
from rqt_mrta_py.render.page import Part

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Layer", "Printer"]


class Layer:
    """A picture that is kept: parts upon what lies below, of which only those are drawn anew that look different.

    A part is drawn from its content alone, upon what lies below. So what a layer shows is a function of the parts and
    of what lies below, whatever it showed before.

    Args:
        image: what it shows without parts; the layer's own from now on.
        below: what lies below and looks like the image now; None for a ground, which never changes.

    Attributes:
        image: what it shows, (height, width, 3), blue, green, red; for reading.
        changes: how often anything was changed.
    """

    def __init__(self, image: NDArray[np.uint8], below: Optional[Layer] = None) -> None:
        self.image = image
        self.changes = 0
        self._below = below
        self._seen = 0 if below is None else below.changes
        self._parts: Dict[Box, Optional[Part]] = {}
        self._changed: Dict[Box, int] = {}

    def on_top(self) -> Layer:
        """Make a layer that lies on this one."""
        return Layer(self.image.copy(), self)

    def changed_since(self, changes: int) -> List[Box]:
        """List where anything was changed since it had been so often."""
        return [box for box, number in self._changed.items() if number > changes]

    def show(self, parts: Sequence[Part]) -> None:
        """Show these parts and no others.

        Args:
            parts: no two of them share a pixel.
        """
        wanted = {part.box: part for part in parts}
        stale = self._changed_below()
        for box, part in list(self._parts.items()):
            if part is None or wanted.get(box) != part or any(box.meets(other) for other in stale):
                stale.append(box)
                del self._parts[box]
        for box in stale:
            self._clear(box)
        for box, part in wanted.items():
            if box not in self._parts:
                # A part that cannot be drawn leaves something to be cleared.
                self._parts[box] = None
                self._note(box)
                part.draw(Canvas(self.image), part.content)
                self._parts[box] = part

    def _changed_below(self) -> List[Box]:
        if self._below is None:
            return []
        changed = self._below.changed_since(self._seen)
        self._seen = self._below.changes
        return changed

    def _clear(self, box: Box) -> None:
        if self._below is not None:
            _copy(box, self._below.image, self.image)
            self._note(box)

    def _note(self, box: Box) -> None:
        self.changes += 1
        self._changed[box] = self.changes


class _Print:
    """A picture that was printed, and how often the layer had changed when it was."""

    __slots__ = ("changes", "image")

    def __init__(self, layer: Layer) -> None:
        self.image = layer.image.copy()
        self.changes = layer.changes


class Printer:
    """Hands out pictures of a layer, in memory that nobody else holds any more; only what was changed is copied there.

    To fetch memory anew, or to copy a whole picture, costs more than to draw a part.

    Args:
        layer: what is printed.
    """

    _MOST = 4

    def __init__(self, layer: Layer) -> None:
        self._layer = layer
        self._prints: List[_Print] = []
        self._references = 0

    def print(self) -> NDArray[np.uint8]:
        """Give a picture of the layer as it is, not to be written on; it stays as it is while anybody holds it."""
        shown = self._free().view()
        shown.flags.writeable = False
        return shown

    def _free(self) -> NDArray[np.uint8]:
        layer = self._layer
        for each in self._prints:
            # Counted here just as it was when nobody else held it; arrays made from a picture count too.
            if sys.getrefcount(each.image) <= self._references:
                for box in layer.changed_since(each.changes):
                    _copy(box, layer.image, each.image)
                each.changes = layer.changes
                return each.image
        each = _Print(layer)
        if len(self._prints) < self._MOST:
            self._prints.append(each)
            self._references = sys.getrefcount(each.image)
        return each.image


def _copy(box: Box, source: NDArray[np.uint8], into: NDArray[np.uint8]) -> None:
    left, top, right, bottom = (round(edge) for edge in box)
    into[top:bottom, left:right] = source[top:bottom, left:right]
