"""Time as connections tell it: rates, gaps, and header stamps against the time of receipt."""

from __future__ import annotations

from typing import List, Optional, Sequence

from rqt_mrta_py.render.report.html import Content, Html, element
from rqt_mrta_py.render.report.report_input import ClockRow, ReportInput
from rqt_mrta_py.render.report.tables import section, table

__all__ = ["clocks_section"]

_MOST = 1000


def clocks_section(given: ReportInput) -> Optional[Html]:
    """List what was measured of connections; None where nobody measured."""
    if not given.clocks:
        return None
    heads = [
        "topic",
        "node",
        "messages",
        "rate [Hz]",
        "jitter [ms]",
        "longest gap [s]",
        "offset [ms]",
        "known to within [ms]",
        "drift [ppm]",
        "remark",
    ]
    shown = given.clocks[:_MOST]
    more = len(given.clocks) - len(shown)
    return section(
        "clocks",
        "Clocks and gaps",
        table("Clocks and gaps", heads, [_row(row) for row in shown], 2),
        element("p", f"{more} more connections are in clocks.json", class_="hint") if more else None,
        note="header stamps against the time of receipt; an offset above 0: stamps are ahead. What is latency and what "
        "the clock cannot be told apart more closely than the bound says.",
    )


def _row(row: ClockRow) -> List[Content]:
    cells: Sequence[Content] = [
        element("code", row.topic),
        element("code", row.node or "?"),
        f"{row.messages:,}",
        _scaled(row.rate, 1.0),
        _scaled(row.jitter, 1e3),
        _scaled(row.longest_gap, 1.0),
        _scaled(row.offset, 1e3),
        _scaled(row.bound, 1e3),
        _scaled(row.drift, 1e6),
        row.remark,
    ]
    return list(cells)


def _scaled(value: Optional[float], factor: float) -> str:
    return "–" if value is None else f"{value * factor:,.4g}"
