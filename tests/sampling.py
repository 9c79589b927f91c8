"""Families of like tests, of which the quick suite runs some and ``./test --long`` all."""

from __future__ import annotations

from typing import Any, Callable, Hashable, Iterable, List, Set

import pytest

__all__ = ["every", "one_of_each"]


def every(step: int, cases: Iterable[Any]) -> List[Any]:
    """Give all cases as parameters; of each so many that follow one another, all but the first are long."""
    return [case if number % step == 0 else _long(case) for number, case in enumerate(cases)]


def one_of_each(kind: Callable[[Any], Hashable], cases: Iterable[Any]) -> List[Any]:
    """Give all cases as parameters; all but the first of each kind are long."""
    given: List[Any] = []
    seen: Set[Hashable] = set()
    for case in cases:
        found = kind(case)
        given.append(_long(case) if found in seen else case)
        seen.add(found)
    return given


def _long(case: Any) -> Any:
    values = case if isinstance(case, tuple) else (case,)
    return pytest.param(*values, marks=pytest.mark.long)
