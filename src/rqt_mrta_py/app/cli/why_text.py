"""Explanations of tasks on the terminal."""

from __future__ import annotations

import math
import re
import textwrap
from typing import Iterator, Sequence

from rqt_mrta_py.model import Explanation, Ground, Spell
from rqt_mrta_py.render.explaining import (
    candidate_groups,
    ends_of,
    named,
    others_in_lines,
    spell_in_words,
    task_in_words,
)
from rqt_mrta_py.render.text import printable
from rqt_mrta_py.render.times import seconds

__all__ = ["why_text"]

_WIDTH = 110
_UNIT = re.compile(r" (?=[smh]\b)")
_NO_BREAK = "\u00a0"
"""Between a number and its unit no line ends."""
_MOST = 60
"""Of holds and grounds of one task so many are printed; the others stand in ``why.json``."""


def why_text(explanations: Sequence[Explanation], start: float) -> str:
    """Write explanations as lines.

    Args:
        explanations: of tasks.
        start: of the mission, from which times are counted [s].
    """
    return "\n".join(line for each in explanations for line in _lines(each, start))


def _lines(explanation: Explanation, start: float) -> Iterator[str]:
    yield ""
    yield from _row(f"why {named([explanation.task])}", ": ", task_in_words(explanation))
    yield "  who could have had it"
    for group in candidate_groups(explanation.candidates):
        yield from _row(f"    {group.answer:<8}", " ", f"{group.robots}: {group.why}")
    if not explanation.candidates:
        yield "    no robot is known"
    yield "  who took it, and when"
    first, left_out, last = ends_of(explanation.spells, _MOST)
    for spell in first:
        yield from _spell(spell, start)
    if left_out:
        yield f"    {left_out} more in why.json"
    for spell in last:
        yield from _spell(spell, start)
    yield "  on what grounds"
    yield from _grounds(explanation, start)


def _spell(spell: Spell, start: float) -> Iterator[str]:
    times = f"  {seconds(spell.start - start):>10} to {seconds(spell.end - start):>9}"
    who = named([spell.robot]) if spell.robot else "nobody"
    yield from _row(times, "  ", f"{who}: {spell_in_words(spell)}")
    for line in others_in_lines(spell, start):
        yield from _row(" " * len(times), "    ", line)


def _grounds(explanation: Explanation, start: float) -> Iterator[str]:
    end = max((spell.end for spell in explanation.spells), default=math.inf)
    told = [each for each in explanation.grounds if each.time <= end]
    later = len(explanation.grounds) - len(told)
    first, left_out, last = ends_of(told, _MOST)
    width = max((len(named([each.robot])) for each in (*first, *last)), default=0)
    for ground in first:
        yield from _ground(ground, start, width)
    if left_out:
        yield f"    {left_out} more in why.json"
    for ground in last:
        yield from _ground(ground, start, width)
    if later:
        yield f"    {later} more, of when it had ended, in why.json"
    if explanation.more:
        yield f"    {explanation.more} more were told, and not kept"
    if explanation.note:
        yield from _row("    ", "", explanation.note)


def _ground(ground: Ground, start: float, width: int) -> Iterator[str]:
    head = f"  {seconds(ground.time - start):>10}  {named([ground.robot]) if ground.robot else '':<{width}}"
    yield from _row(head, "  " if width else "", printable(ground.text))


def _row(head: str, gap: str, text: str) -> Iterator[str]:
    """Write a text beside its head, further lines below its first."""
    indent = len(head) + len(gap) if len(head) + len(gap) < _WIDTH // 2 else 8
    kept = _UNIT.sub(_NO_BREAK, printable(text, 2000))
    lines = textwrap.wrap(
        kept, _WIDTH, initial_indent=head + gap, subsequent_indent=" " * indent, break_on_hyphens=False
    )
    yield from (line.replace(_NO_BREAK, " ") for line in lines or [head])
