"""Where something was said."""

from __future__ import annotations

from typing import NamedTuple

from rqt_mrta_py.errors import Problem

__all__ = ["Origin"]


class Origin(NamedTuple):
    """A line of a file, or a flag of the command line.

    Attributes:
        path: the file, or the flag.
        line: 1-based; 0 for a flag.
        element: what the line speaks of; empty for a flag.
    """

    path: str
    line: int = 0
    element: str = ""

    def problem(self, message: str) -> Problem:
        """Say what is wrong there."""
        return Problem(self.path, self.line, self.element, message)
