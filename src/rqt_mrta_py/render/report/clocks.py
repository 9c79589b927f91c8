"""Time as messages tell it: the robots' clocks, and each connection's rate, gaps and stamps."""

from __future__ import annotations

from typing import List, Optional, Sequence

from rqt_mrta_py.model.timing import ClockPair, ConnectionTiming, Gap, RobotClock, SenderClock
from rqt_mrta_py.render.report.html import Content, Html, element, joined
from rqt_mrta_py.render.report.report_input import ReportInput
from rqt_mrta_py.render.report.tables import moment, section, table
from rqt_mrta_py.render.times import seconds

__all__ = ["clocks_section"]

_MOST = 1000
_STAMPS = ("offset [ms]", "drift [ppm]", "ahead by at least [ms]", "later, half [ms]", "later, 95 % [ms]")
_PAIR = ("robot", "against", "ahead by at least [ms]", "at most [ms]")
_NOTE = (
    "Header stamps against the time of receipt. An offset is that of the promptest messages: the clock's error less "
    "the shortest latency, which messages that go one way cannot tell apart; the clock is ahead by at least what is "
    "said, where that is above 0."
)


def clocks_section(given: ReportInput) -> Optional[Html]:
    """List what messages tell of time; None where nobody measured."""
    if given.clocks is None or not given.clocks.connections:
        return None
    start = given.view.record.start or 0.0
    connections = given.clocks.connections
    robots = [_robot(each) for each in given.clocks.robots[:_MOST]]
    pairs = given.clocks.pairs[:_MOST]
    rows = [_connection(each, start) for each in connections[:_MOST]]
    more = len(connections) - len(rows)
    heads = ("topic", "node", "messages", "rate [Hz]", "period [ms]", "jitter [ms]", "longest silence [s]", "gaps")
    return section(
        "clocks",
        "Clocks and gaps",
        table("The robots' clocks", ("robot", "told by", *_STAMPS), robots, 2) if robots else None,
        table("Clocks of robots that recorded each other", _PAIR, [_pair(each) for each in pairs], 2)
        if pairs
        else None,
        element(
            "details",
            element("summary", f"All {len(connections)} connections"),
            table("Connections", (*heads, *_STAMPS), rows, 2),
            element("p", f"{more} more are in clocks.json", class_="hint") if more else None,
            open=not robots,
        ),
        note=_NOTE,
    )


def _robot(each: RobotClock) -> List[Content]:
    return [each.robot, element("code", each.topic), *_stamps(each.clock)]


def _pair(each: ClockPair) -> List[Content]:
    return [each.robot, each.other, _scaled(each.at_least, 1e3), _scaled(each.at_most, 1e3)]


def _connection(each: ConnectionTiming, start: float) -> List[Content]:
    return [
        element("code", each.topic),
        element("code", each.caller or "?"),
        f"{each.messages:,}",
        _scaled(each.rate, 1.0),
        _scaled(each.period, 1e3),
        _scaled(each.jitter, 1e3),
        _scaled(each.longest, 1.0),
        "–" if each.gaps is None else joined([f"{each.gaps:,}", _longest(each.longest_gaps, start)]),
        *_stamps(each.clock),
    ]


def _longest(gaps: Sequence[Gap], start: float) -> Optional[Html]:
    """Lead to the longest gap."""
    if not gaps:
        return None
    gap = max(gaps, key=lambda each: each.end - each.start)
    return joined([": ", moment(gap.start - start), f" for {seconds(gap.end - gap.start)}"])


def _stamps(clock: Optional[SenderClock]) -> List[Content]:
    if clock is None:
        return ["–"] * len(_STAMPS)
    return [
        _scaled(clock.offset, 1e3),
        _scaled(clock.drift, 1e6),
        _scaled(clock.at_least, 1e3),
        _scaled(clock.delay_median, 1e3),
        _scaled(clock.delay_high, 1e3),
    ]


def _scaled(value: Optional[float], factor: float) -> str:
    return "–" if value is None else f"{value * factor:,.4g}"
