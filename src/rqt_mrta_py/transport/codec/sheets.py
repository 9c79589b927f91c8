"""Messages of one form that lie one after the other in memory, with views of the numbers that change."""

from __future__ import annotations

from itertools import groupby
from typing import Any, Dict, Iterator, List, Mapping, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from rqt_mrta_py.hooks import Column, Page
from rqt_mrta_py.transport.codec.column_parts import part_types, parts_of_column, parts_of_number
from rqt_mrta_py.transport.codec.definitions import Definition, Field
from rqt_mrta_py.transport.codec.wire import Sizes

__all__ = ["Sheet"]

_View = Tuple[slice, "NDArray[Any]"]
"""Rows of the sheet, and the bytes of one part of a value in them."""


class _Place(NamedTuple):
    """Where the messages of one layout have a value."""

    path: str
    type: str
    offset: int
    width: Optional[int]


class _Slot:
    """Where all messages have the values of one column: views of each part of a value, one for each layout."""

    __slots__ = ("last", "type", "views")

    def __init__(self, type_name: str) -> None:
        self.type = type_name
        self.views: List[List[_View]] = [[] for _ in part_types(type_name)]
        self.last: Any = None


class Sheet:
    """Messages of one form: all but their numbers stays as it was in the first.

    Messages whose texts have the same lengths have the same layout; their values lie at equal distances.

    Attributes:
        runs: as in Page, of all pages that are written on the sheet.

    Args:
        definition: of their type.
        tree: the columns' paths, nested as the fields are.
        columns: that the first messages were written from.
        raws: the first messages, at least one.
    """

    def __init__(
        self, definition: Definition, tree: Mapping[str, Any], columns: Mapping[str, Column], raws: Sequence[bytes]
    ) -> None:
        layouts: Dict[Tuple[int, ...], List[int]] = {}
        measured = {path: _lengths(column, len(raws)) for path, column in columns.items()}
        known = {path: lengths for path, lengths in measured.items() if lengths is not None}
        for row in range(len(raws)):
            layouts.setdefault(tuple(lengths[row] for lengths in known.values()), []).append(row)
        order = [row for rows in layouts.values() for row in rows]
        self._order = None if order == list(range(len(raws))) else np.array(order)
        self.runs = [(len(list(run)), size) for size, run in groupby(map(len, raws))]
        self._buffer = bytearray(b"".join([raws[row] for row in order]))
        self._cuts: List[Tuple[int, int]] = [(0, 0)] * len(raws)
        self._slots: Dict[str, _Slot] = {}
        sizes = Sizes(definition)
        first = start = 0
        for lengths, rows in layouts.items():
            size = len(raws[rows[0]])
            for number, row in enumerate(rows):
                self._cuts[row] = (start + number * size, start + (number + 1) * size)
            for place in _Walk(definition, sizes, dict(zip(known, lengths))).places(tree):
                self._add(place, slice(first, first + len(rows)), start, size)
            first, start = first + len(rows), start + len(rows) * size

    def write(self, columns: Mapping[str, Column]) -> Page:
        """Serialise messages of this form.

        Args:
            columns: with the paths, texts, shapes and kinds of numbers of those that the sheet was made from.

        Raises:
            ArithmeticError, TypeError, ValueError, struct.error: a number does not fit.
        """
        for path, slot in self._slots.items():
            column = columns[path]
            if isinstance(column, np.ndarray):
                parts = parts_of_column(slot.type, column if self._order is None else column[self._order])
                for part, views in zip(parts, slot.views):
                    for rows, view in views:
                        view[...] = part[rows]
            elif column is not slot.last:
                for word, views in zip(parts_of_number(slot.type, column), slot.views):
                    for _, view in views:
                        view[...] = word
                slot.last = column
        content = bytes(self._buffer)
        if self._order is not None:
            content = b"".join([content[start:end] for start, end in self._cuts])
        return Page(content, self.runs)

    def _add(self, place: _Place, rows: slice, start: int, size: int) -> None:
        slot = self._slots.get(place.path)
        if slot is None:
            slot = self._slots[place.path] = _Slot(place.type)
        types = part_types(place.type)
        element = sum(part.itemsize for part in types)
        offset = start + place.offset
        count = rows.stop - rows.start
        for views, part in zip(slot.views, types):
            shape, strides = ((count,), (size,)) if place.width is None else ((count, place.width), (size, element))
            views.append((rows, np.ndarray(shape, part, self._buffer, offset, strides)))
            offset += part.itemsize


class _Walk:
    """Finds where messages of one layout have their numbers.

    Args:
        definition: of their type.
        sizes: of what it contains.
        lengths: by path: of texts [bytes], of rows of array fields [elements].
    """

    def __init__(self, definition: Definition, sizes: Sizes, lengths: Mapping[str, int]) -> None:
        self._definition = definition
        self._sizes = sizes
        self._lengths = lengths
        self._offset = 0

    def places(self, tree: Mapping[str, Any]) -> Iterator[_Place]:
        """Give the places of numbers; the tree holds the paths of columns, nested as the fields are."""
        return self._message(self._definition.type, tree)

    def _message(self, type_name: str, tree: Mapping[str, Any]) -> Iterator[_Place]:
        for item in self._definition.specs[type_name].fields:
            below = tree.get(item.name)
            if item.is_array:
                yield from self._array(item, below)
            elif item.is_primitive or below is None:
                if below is not None and item.type != "string":
                    yield _Place(below, item.type, self._offset, None)
                self._offset += self._sizes.element(item) + self._lengths.get(below or "", 0)
            else:
                yield from self._message(item.type, below)

    def _array(self, item: Field, below: Union[str, List[Any], None]) -> Iterator[_Place]:
        size = self._sizes.element(item)
        if item.length is None:
            self._offset += 4
        if isinstance(below, list):
            for element in below:
                yield from self._message(item.type, element)
        elif below is None:
            self._offset += size * (item.length or 0)
        elif self._lengths[below]:
            yield _Place(below, item.type, self._offset, self._lengths[below])
            self._offset += size * self._lengths[below]


def _lengths(column: Column, count: int) -> Optional[Sequence[int]]:
    """Give the length of each message's text or row; None where each message has one number."""
    if isinstance(column, str):
        return [len(column.encode())] * count
    if isinstance(column, (list, tuple)):
        return [len(text.encode()) for text in column]
    if isinstance(column, np.ndarray) and column.ndim > 1:
        return [column.shape[1]] * count
    return None
