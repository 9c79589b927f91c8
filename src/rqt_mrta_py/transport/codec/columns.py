"""Writers of many messages of one type, column by column: what one array says of all of them is written in one go.

The first messages of a form are written one by one. They become a sheet, on which only the numbers change from then on.
"""

from __future__ import annotations

import re
import struct
from typing import Any, Dict, List, Mapping, Sequence, Tuple

import numpy as np

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Column, Page
from rqt_mrta_py.transport.codec.definitions import Definition
from rqt_mrta_py.transport.codec.encoder_text import Encoder
from rqt_mrta_py.transport.codec.sheets import Sheet
from rqt_mrta_py.wording import shown

__all__ = ["ColumnEncoder"]

_MOST_SHEETS = 256
"""How many sheets are kept for a type: one for each topic and group of robots that speak together, and one for each
robot that says many messages together."""

_FAULTS = (ArithmeticError, TypeError, ValueError, struct.error)
"""What a sheet raises for numbers that do not fit."""

_INDEX = re.compile(r"0|[1-9][0-9]{0,3}")
"""A place in an array of messages; larger ones are no message's, but would take the memory of one."""

_ACCEPTED = "a number, a text, a list of one text a message, or an array of numbers with one row a message"


class ColumnEncoder:
    """Serialises messages of one type from columns.

    Args:
        definition: of the type.
        encode: serialises one message of it.
    """

    def __init__(self, definition: Definition, encode: Encoder) -> None:
        self._definition = definition
        self._encode = encode
        self._sheets: Dict[Tuple[Any, ...], Sheet] = {}

    def write(self, columns: Mapping[str, Column], count: int) -> Page:
        """Serialise messages; see ``hooks.Codec``."""
        key = (count, *[_form(path, column) for path, column in columns.items()])
        try:
            sheet = self._sheets.get(key)
            if sheet is not None:
                return sheet.write(columns)
        except _FAULTS:
            # One of the messages says which value it is.
            pass
        raws = self._write_each(columns, count)
        if not raws:
            return Page(b"", ())
        if len(self._sheets) >= _MOST_SHEETS:
            self._sheets.clear()
        sheet = Sheet(self._definition, nest({path: path for path in columns}), columns, raws)
        self._sheets[key] = sheet
        return Page(b"".join(raws), sheet.runs)

    def _write_each(self, columns: Mapping[str, Column], count: int) -> List[bytes]:
        name = self._definition.type
        values = {path: _values(name, path, column, count) for path, column in columns.items()}
        raws: List[bytes] = []
        for row in range(count):
            try:
                raws.append(self._encode(nest({path: rows[row] for path, rows in values.items()})))
            except TransportError as error:
                if count == 1:
                    raise
                raise TransportError(f"{error} (row {row} of {count})") from error
            except ValueError as error:
                raise TransportError(f"{name}: {error}") from error
        return raws


def nest(leaves: Mapping[str, Any]) -> Dict[str, Any]:
    """Turn values by path into nested fields.

    Args:
        leaves: by names joined by ``/``, a number standing for a place in an array.

    Raises:
        ValueError: of two paths one leads through the end of the other.
    """
    tree: Dict[str, Any] = {}
    for path, leaf in leaves.items():
        node = tree
        *above, last = path.split("/")
        for name in above:
            node = node.setdefault(name, {})
            if node.__class__ is not dict:
                raise ValueError(f"{path}: a path that it begins with has a column too; accepted is one of the two")
        if last in node:
            raise ValueError(f"{path}: a path that begins with it has a column too; accepted is one of the two")
        node[last] = leaf
    return {name: _with_lists(node) for name, node in tree.items()}


def _with_lists(node: Any) -> Any:
    if node.__class__ is not dict:
        return node
    below = {name: _with_lists(item) for name, item in node.items()}
    if all(map(_INDEX.fullmatch, below)):
        return [below.get(str(index), {}) for index in range(max(map(int, below)) + 1)]
    return below


def _form(path: str, column: Column) -> Tuple[Any, ...]:
    """Give what fixes a column's place on a sheet: all but the numbers."""
    if isinstance(column, np.ndarray):
        return (path, column.shape, column.dtype.char)
    if isinstance(column, str):
        return (path, column)
    if isinstance(column, (list, tuple)):
        return (path, tuple(column))
    return (path,)


def _values(type_name: str, path: str, column: Column, count: int) -> Sequence[Any]:
    """Give a column's value for each message, as Python has it."""
    rows: Sequence[Any] = ()
    if isinstance(column, np.ndarray):
        fits = column.ndim > 0 and column.dtype.kind in "biuf" and column.dtype.itemsize <= 8
        if fits:
            rows = column.tolist()
    elif isinstance(column, (list, tuple)):
        rows = column
        fits = all(isinstance(text, str) for text in rows)
    else:
        rows = (column,) * count
        fits = isinstance(column, (str, int, float, np.number, np.bool_))
    if not fits:
        raise TransportError(f"{type_name}: {path}: {shown(column)} does not fit; accepted is {_ACCEPTED}")
    if len(rows) != count:
        raise TransportError(f"{type_name}: {path}: {len(rows)} rows; accepted is one for each of {count} messages")
    return rows
