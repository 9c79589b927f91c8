"""Tables of text, whole away from a terminal and folded to the width of one."""

from __future__ import annotations

import shutil
import sys
import textwrap
from typing import Iterator, List, Optional, Sequence

from rqt_mrta_py.wording import printable

__all__ = ["print_table", "table_lines"]

_GAP = "  "
_LEAST = 24
"""Where less room than this is left for the last column, its cells get lines of their own."""

_INDENT = "    "


def print_table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> None:
    """Print columns as wide as their widest cell, the last as it is; on a terminal, folded to its width."""
    is_terminal = sys.stdout is not None and sys.stdout.isatty()
    for line in table_lines(head, rows, shutil.get_terminal_size().columns if is_terminal else None):
        print(line)


def table_lines(head: Sequence[str], rows: Sequence[Sequence[str]], width: Optional[int] = None) -> List[str]:
    """Lay a table out.

    Args:
        head: titles of the columns.
        rows: cells, as many as titles.
        width: to which the last column is folded [characters]; None: it stays whole.

    Returns:
        The lines, without blanks at their ends. No text is left out, whatever the width.
    """
    table = [[printable(cell) for cell in row] for row in (head, *rows)]
    widths = [max(len(row[column]) for row in table) for column in range(len(head) - 1)]
    longest = max(len(row[-1]) for row in table)
    left = sum(widths) + len(_GAP) * len(widths)
    fits = width is None or left + longest <= width
    room = longest if fits or width is None else width - left
    lines: List[str] = []
    for row in table:
        start = "".join(cell.ljust(size) + _GAP for cell, size in zip(row, widths))
        if fits:
            lines.append(f"{start}{row[-1]}".rstrip())
        elif room >= _LEAST:
            folded = list(_folded(row[-1], room))
            lines.append(f"{start}{folded[0]}".rstrip())
            lines.extend(" " * left + line for line in folded[1:])
        else:
            lines.append(start.rstrip())
            lines.extend(f"{_INDENT}{line}" for line in _folded(row[-1], (width or 0) - len(_INDENT)) if line)
    return lines


def _folded(text: str, room: int) -> Iterator[str]:
    """Fold a text between words; gives one empty line of an empty text."""
    yield from textwrap.wrap(text, max(room, _LEAST), break_long_words=False, break_on_hyphens=False) or [""]
