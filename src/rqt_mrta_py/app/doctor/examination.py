"""All checks on all subjects."""

from __future__ import annotations

from typing import Callable, Iterable, Iterator, List, Tuple

from rqt_mrta_py.app.doctor.files import check_files
from rqt_mrta_py.app.doctor.subject import Subject
from rqt_mrta_py.errors import ConfigError, MrtaError, Problem

__all__ = ["CHECKS", "Check", "examine"]

Check = Callable[[Subject], Iterator[Problem]]
"""Gives what is wrong with a subject; the first that a ConfigError carries too."""

CHECKS: Tuple[Check, ...] = (check_files,)
"""In the order in which they are asked."""


def examine(subjects: Iterable[Subject], checks: Iterable[Check] = CHECKS) -> Tuple[Problem, ...]:
    """Ask every check about every subject; one that fails on one subject lets the others go on.

    Args:
        subjects: packages and files.
        checks: what to look at.

    Returns:
        Everything that is wrong, each once, sorted by path, line and element.
    """
    wanted = tuple(checks)
    return tuple(sorted({problem for subject in subjects for check in wanted for problem in _asked(check, subject)}))


def _asked(check: Check, subject: Subject) -> List[Problem]:
    found: List[Problem] = []
    try:
        found.extend(check(subject))
    except ConfigError as error:
        found.extend(error.problems)
    except MrtaError as error:
        # A plugin that does not keep the contract, told by its name.
        found.append(Problem(str(subject.place), 0, "", str(error)))
    return found
