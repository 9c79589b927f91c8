"""Marks: which bytes of a message decide what some of its fields say.

Two messages that are equally long and equal in these bytes say the same in these fields, so thousands of them can be
held against one another without reading any.
"""

from __future__ import annotations

import struct
from typing import List, NamedTuple, Optional, Sequence, Tuple

from rqt_mrta_py.hooks import Connection
from rqt_mrta_py.transport.codec.definitions import Field, parse_definition
from rqt_mrta_py.transport.codec.wire import Sizes

__all__ = ["Marker", "Marks"]

_MOST = 64
"""Messages with more parts of changing length are not looked at: reading them is as quick."""

_u32 = struct.Struct("<I").unpack_from


class Marks(NamedTuple):
    """Bytes of one message, as it is laid out.

    Attributes:
        layout: where the lengths stand that say where everything else is, 4 bytes each.
        said: where the fields stand: begin and end.
    """

    layout: Tuple[int, ...]
    said: Tuple[Tuple[int, int], ...]

    def places(self) -> List[int]:
        """List all bytes, each once, in order."""
        spans = [*((place, place + 4) for place in self.layout), *self.said]
        return sorted({place for begin, end in spans for place in range(begin, end)})


class Marker:
    """Marks messages of one connection.

    Args:
        connection: whose.
        paths: of the fields that matter, joined by ``/``; the definition has them.

    Raises:
        TransportError: the definition cannot be understood.
    """

    def __init__(self, connection: Connection, paths: Sequence[str]) -> None:
        self._definition = parse_definition(connection.type, connection.definition)
        self._sizes = Sizes(self._definition)
        self._paths = {tuple(path.split("/")) for path in paths}

    def mark(self, raw: bytes) -> Optional[Marks]:
        """Mark a message.

        Returns:
            The marks; None if the bytes do not fit the definition, or have too many parts of changing length.
        """
        walk = _Walk(raw, self)
        try:
            end = walk.message(self._definition.type, 0, ())
        except (_UnmarkableError, struct.error):
            return None
        return Marks(tuple(walk.layout), tuple(walk.said)) if end == len(raw) else None

    def has(self, path: str) -> bool:
        """Tell whether the definition has a field."""
        spec = self._definition.root
        *above, last = path.split("/")
        for step in above:
            item = next((each for each in spec.fields if each.name == step), None)
            if item is None or item.is_array or item.is_primitive:
                return False
            spec = self._definition.specs[item.type]
        return any(each.name == last for each in spec.fields)

    def fields(self, type_name: str) -> Sequence[Field]:
        """List the fields of a type that the definition knows."""
        return self._definition.specs[type_name].fields

    def size(self, item: Field) -> Optional[int]:
        """Give the bytes that a value, or an element of an array, takes; None if that changes."""
        if item.type == "string" or not self._sizes.is_fixed(item.type):
            return None
        return self._sizes.element(item)

    def matters(self, path: Tuple[str, ...]) -> bool:
        """Tell whether a field is one of those that matter, or part of one."""
        return any(path[:depth] in self._paths for depth in range(1, len(path) + 1))


class _UnmarkableError(Exception):
    """A message that is not worth it."""


class _Walk:
    """Steps over one message."""

    def __init__(self, raw: bytes, marker: Marker) -> None:
        self.layout: List[int] = []
        self.said: List[Tuple[int, int]] = []
        self._raw = raw
        self._marker = marker

    def message(self, type_name: str, place: int, above: Tuple[str, ...]) -> int:
        """Step over a message; answer where it ends."""
        for item in self._marker.fields(type_name):
            path = (*above, item.name)
            begin = place
            place = self._array(item, place, path) if item.is_array else self._value(item, place, path)
            if place > len(self._raw):
                raise _UnmarkableError
            if (item.is_primitive or item.is_array) and self._marker.matters(path):
                self.said.append((begin, place))
        return place

    def _value(self, item: Field, place: int, path: Tuple[str, ...]) -> int:
        if item.type == "string":
            return place + 4 + self._length(place)
        return place + (self._marker.size(item) or 0) if item.is_primitive else self.message(item.type, place, path)

    def _array(self, item: Field, place: int, path: Tuple[str, ...]) -> int:
        count = item.length
        if count is None:
            count = self._length(place)
            place += 4
        size = self._marker.size(item)
        if size is not None:
            return place + count * size
        for _ in range(count):
            place = self._value(item, place, path)
            if place > len(self._raw) or len(self.layout) > _MOST:
                raise _UnmarkableError
        return place

    def _length(self, place: int) -> int:
        if len(self.layout) > _MOST:
            raise _UnmarkableError
        self.layout.append(place)
        return int(_u32(self._raw, place)[0])
