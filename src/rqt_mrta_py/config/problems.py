"""Collecting what is wrong with one file, so that the user hears of all problems at once."""

from __future__ import annotations

from typing import List, Tuple

from rqt_mrta_py.errors import ConfigError, Problem

__all__ = ["Problems"]


class Problems:
    """The problems of one file, found while it is read.

    Args:
        path: the file as problems shall name it.
    """

    def __init__(self, path: str) -> None:
        self.path = path
        self._found: List[Problem] = []

    def add(self, line: int, element: str, message: str) -> None:
        """Note one problem.

        Args:
            line: 1-based; 0 where a line makes no sense.
            element: what the line speaks of.
            message: what is wrong with the value received; what is accepted.
        """
        self._found.append(Problem(self.path, line, element, message))

    def raise_if_any(self) -> None:
        """End the reading of a file that has problems.

        Raises:
            ConfigError: with every problem noted so far.
        """
        if self._found:
            raise ConfigError(self._found)

    @property
    def found(self) -> Tuple[Problem, ...]:
        """What was noted so far, sorted."""
        return tuple(sorted(set(self._found)))

    @property
    def elements(self) -> Tuple[str, ...]:
        """What was spoken of so far, in the order of the file."""
        return tuple(dict.fromkeys(problem.element for problem in self.found))

    def __len__(self) -> int:
        return len(self._found)
