"""What the reader of an rqt_mrta.xml finds wrong within one of its elements, so that no check tells of it again."""

from __future__ import annotations

from typing import Iterable, Tuple

from rqt_mrta_py.errors import Problem

__all__ = ["flaws_of"]


def flaws_of(lines: Tuple[int, int], problems: Iterable[Problem]) -> Tuple[Problem, ...]:
    """Give the problems that a reader notes within an element.

    Args:
        lines: the first and the last of the element; elements that share lines share problems.
        problems: of the whole file.
    """
    first, last = lines
    return tuple(problem for problem in problems if first <= problem.line <= last)
