"""The legend of a figure: one for all its charts, in rows above them."""

from __future__ import annotations

from typing import Dict, List, NamedTuple, Sequence, Tuple

from rqt_mrta_py.hooks import Figure, LineStyle
from rqt_mrta_py.render.palette import Colour
from rqt_mrta_py.render.text import Style, shorten, text_width

__all__ = ["KEY_WIDTH", "ROW_HEIGHT", "WORDS", "Key", "legend_rows"]

WORDS = Style(14)
"""How the names of lines look."""

KEY_WIDTH = 34.0
"""Of a line's sample [pixels]."""

ROW_HEIGHT = 22.0
"""Of a row of the legend [pixels]."""

_MOST_ROWS = 4
_WIDEST = 300.0
_GAP, _BETWEEN = 8.0, 26.0


class Key(NamedTuple):
    """One entry.

    Attributes:
        left: where its sample begins [pixels].
        words: as they are written.
        colour: of the sample; empty for words alone.
        style: of the sample.
    """

    left: float
    words: str
    colour: Tuple[Colour, ...]
    style: LineStyle


def legend_rows(figure: Figure, colours: Sequence[Sequence[Colour]], left: float, right: float) -> List[List[Key]]:
    """Arrange the names of a figure's lines, each once, in the order of their first mention.

    Args:
        figure: whose lines.
        colours: of all lines, chart by chart.
        left: where rows begin [pixels].
        right: where they must end [pixels].

    Returns:
        Rows from top to bottom, four at most; what has no room is counted at the end.
    """
    named: Dict[str, Tuple[Colour, LineStyle]] = {}
    for chart, row in zip(figure.charts, colours):
        for line, colour in zip(chart.lines, row):
            if line.label:
                named.setdefault(line.label, (colour, line.style))
    rows: List[List[Key]] = []
    x = right
    for done, (label, (colour, style)) in enumerate(named.items()):
        words = shorten(label, WORDS, _WIDEST)
        width = KEY_WIDTH + _GAP + text_width(words, WORDS)
        if x + width > right:
            if len(rows) == _MOST_ROWS:
                last = rows[-1].pop()
                rows[-1].append(Key(last.left, f"+{len(named) - done + 1} more", (), last.style))
                break
            rows.append([])
            x = left
        rows[-1].append(Key(x, words, (colour,), style))
        x += width + _BETWEEN
    return rows
