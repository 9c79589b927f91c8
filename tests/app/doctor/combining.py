"""Two files of the corpus in one: what is wrong with either is wrong with it, in lines that are told again."""

from __future__ import annotations

import re
from difflib import SequenceMatcher
from typing import Dict, List, NamedTuple, Optional, Sequence, Tuple

_PLACE = re.compile(r"(?<=\.xml:)[0-9]+|(?<=in line )[0-9]+|(?<=by line )[0-9]+")


class Combined(NamedTuple):
    """A text with the changes of two others, and where their lines are in it.

    Attributes:
        text: of both.
        lines: 1-based lines of it by those of either.
    """

    text: str
    lines: Tuple[Dict[int, int], Dict[int, int]]

    def moved(self, problem: str, side: int) -> Optional[str]:
        """Say of the text what is said of one of the two; None if the other one changes a line that it speaks of."""
        lines = self.lines[side]
        if any(int(found) not in lines for found in _PLACE.findall(problem)):
            return None
        return _PLACE.sub(lambda match: str(lines[int(match.group())]), problem)


class _Change(NamedTuple):
    first: int
    last: int
    text: Sequence[str]
    start: int
    side: int


def combine(sound: str, one: str, other: str) -> Optional[Combined]:
    """Put the changes of two texts into the one that both are made of.

    Args:
        sound: what both are made of.
        one: with some lines changed.
        other: with others changed.

    Returns:
        All three in one; None if both change the same lines.
    """
    base = sound.splitlines(keepends=True)
    changes = sorted([*_changes(base, one, 0), *_changes(base, other, 1)])
    if any(later.first <= earlier.last for earlier, later in zip(changes, changes[1:])):
        return None
    merged: List[str] = []
    lines: Tuple[Dict[int, int], Dict[int, int]] = ({}, {})
    counts = [0, 0]
    at = 0
    for change in [*changes, _Change(len(base), len(base), (), 0, 0)]:
        for line in base[at : change.first]:
            merged.append(line)
            for side in (0, 1):
                counts[side] += 1
                lines[side][counts[side]] = len(merged)
        for line in change.text:
            merged.append(line)
            counts[change.side] += 1
            lines[change.side][counts[change.side]] = len(merged)
        counts[1 - change.side] += change.last - change.first
        at = change.last
    return Combined("".join(merged), lines)


def _changes(base: Sequence[str], text: str, side: int) -> List[_Change]:
    changed = text.splitlines(keepends=True)
    codes = SequenceMatcher(None, base, changed, autojunk=False).get_opcodes()
    return [_Change(i, j, changed[k:m], k, side) for tag, i, j, k, m in codes if tag != "equal"]
