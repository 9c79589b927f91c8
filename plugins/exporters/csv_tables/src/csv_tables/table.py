"""CSV as RFC 4180 has it: commas, CRLF, quotes where needed; UTF-8, a point before the decimals, a header."""

from __future__ import annotations

import csv
import io
from typing import Iterable, Sequence, Union

__all__ = ["Cell", "csv_bytes", "seconds"]

Cell = Union[str, bool, int, float, None]

# Spreadsheets take a text that begins so for a formula and carry it out (OWASP, "CSV injection").
_FORMULA_SIGNS = ("=", "+", "-", "@", "\t", "\r", "\n")


def csv_bytes(head: Sequence[str], rows: Iterable[Sequence[Cell]]) -> bytes:
    """Write a table.

    Args:
        head: names of the columns, with units.
        rows: one cell for each column. Texts that a spreadsheet would take for a formula get a leading apostrophe;
            a NUL, which many readers of CSV refuse, is written as U+FFFD; truth values are written ``true`` and
            ``false``, None as nothing, numbers as Python writes them.

    Returns:
        The file's content.
    """
    text = io.StringIO(newline="")
    writer = csv.writer(text, lineterminator="\r\n")
    writer.writerow([_written(cell) for cell in head])
    writer.writerows([_written(cell) for cell in row] for row in rows)
    # A lone surrogate, as broken JSON may hold, has no place in UTF-8.
    return text.getvalue().encode("utf-8", "backslashreplace")


def seconds(time: float, start: float) -> float:
    """Give the time since a start, in whole nanoseconds [s]."""
    return round(time - start, 9)


def _written(cell: Cell) -> Union[str, int, float]:
    if cell is None:
        return ""
    if isinstance(cell, bool):
        return "true" if cell else "false"
    if isinstance(cell, str):
        text = cell.replace("\0", "\ufffd")
        return f"'{text}" if text.startswith(_FORMULA_SIGNS) else text
    # Of subclasses such as NumPy's scalars the digits only.
    return float(cell) if isinstance(cell, float) else int(cell)
