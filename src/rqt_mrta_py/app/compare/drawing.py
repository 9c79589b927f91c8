"""One task's allocations in both missions as two lanes of bars (SVG)."""

from __future__ import annotations

from html import escape
from typing import List, Optional, Sequence

from rqt_mrta_py.app.compare.allocations import TaskComparison
from rqt_mrta_py.app.compare.side import Holding
from rqt_mrta_py.app.compare.wording import holding
from rqt_mrta_py.render.palette import TASK_COLOURS, Colour, readable_on

__all__ = ["lanes"]

_WIDTH = 960
_LEFT = 28
_BAR = 20
_LANE = 26
_AXIS = 22
_LETTER = 7.5
"""About as wide as a letter of a bar's label."""

_STEPS = (1.0, 2.0, 5.0)
_MOST_TICKS = 10


def lanes(task: TaskComparison, robots: Sequence[str], until: float) -> str:
    """Draw who held a task when.

    Args:
        task: with its allocations.
        robots: all ids; a robot has the same colour on every picture.
        until: where the time axis ends, at least the longer mission's duration [s].

    Returns:
        An ``svg`` element; every text from outside is escaped.
    """
    scale = (_WIDTH - _LEFT - 8) / max(until, 1e-9)
    height = 2 * _LANE + _AXIS
    title = escape(f"{task.task}: who held it in A, above, and in B, below")
    parts = [
        f'<svg role="img" viewBox="0 0 {_WIDTH} {height}" aria-label="{title}">',
        *_axis(until, scale),
    ]
    for lane, name in enumerate(("A", "B")):
        top = lane * _LANE
        parts.append(f'<text class="lane" x="6" y="{top + 15}">{name}</text>')
        for pair in task.pairs:
            held = pair[2 + lane]
            if isinstance(held, Holding):
                parts.append(_bar(held, robots, top, scale))
    return "".join([*parts, "</svg>"])


def _bar(held: Holding, robots: Sequence[str], top: int, scale: float) -> str:
    ground = TASK_COLOURS[robots.index(held.robot) % len(TASK_COLOURS)] if held.robot in robots else TASK_COLOURS[0]
    left, width = _LEFT + held.start * scale, max((held.end - held.start) * scale, 1.0)
    label: Optional[str] = held.robot if width > len(held.robot) * _LETTER + 8 else None
    text = (
        ""
        if label is None
        else f'<text x="{left + 5:.1f}" y="{top + 15}" fill="{_hex(readable_on(ground))}">{escape(label)}</text>'
    )
    return (
        f"<g><title>{escape(f'{held.robot}: {holding(held)}')}</title>"
        f'<rect x="{left:.1f}" y="{top + 1}" width="{width:.1f}" height="{_BAR}" fill="{_hex(ground)}"/>{text}</g>'
    )


def _axis(until: float, scale: float) -> List[str]:
    parts = [f'<line class="axis" x1="{_LEFT}" x2="{_WIDTH - 8}" y1="{2 * _LANE}" y2="{2 * _LANE}"/>']
    step = _step(until)
    for number in range(int(until / step) + 1):
        x = _LEFT + number * step * scale
        parts.append(f'<line class="grid" x1="{x:.1f}" x2="{x:.1f}" y1="0" y2="{2 * _LANE + 4}"/>')
        if x < _WIDTH - 40:
            unit = " s" if number == 0 else ""
            parts.append(f'<text class="tick" x="{x:.1f}" y="{2 * _LANE + 17}">{number * step:g}{unit}</text>')
    return parts


def _step(until: float) -> float:
    """Give the time between ticks: 1, 2 or 5 times a power of ten, and not more ticks than can be read [s]."""
    power = 1e-3
    while power < 1e12:
        for factor in _STEPS:
            if until <= _MOST_TICKS * factor * power:
                return factor * power
        power *= 10.0
    return max(until, 1.0)


def _hex(colour: Colour) -> str:
    return "#" + "".join(f"{part:02x}" for part in colour)
