"""The errors that may leave a room: one class per room under MrtaError.

A border re-raises a library's error as one of these, with ``from``; programming mistakes stay ValueError and
TypeError. The command line turns an MrtaError into one line on stderr and its ``exit_code``.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Iterable, Tuple

__all__ = [
    "ConfigError",
    "DiscoveryError",
    "HookError",
    "MissingDependencyError",
    "MrtaError",
    "Problem",
    "RenderError",
    "RobotError",
    "SimError",
    "SupervisorError",
    "TransportError",
    "UsageError",
]


class MrtaError(Exception):
    """Base of every error that a user can cause or repair."""

    exit_code = 3


class UsageError(MrtaError):
    """The command line asks for something that does not exist or does not fit together."""

    exit_code = 2


class MissingDependencyError(MrtaError):
    """A library or program that this piece of work needs is not installed."""

    exit_code = 4


class DiscoveryError(MrtaError):
    """A package cannot be found or its manifest cannot be read."""


class HookError(MrtaError):
    """A plugin does not keep the contract, or failed where its answer was needed."""


class TransportError(MrtaError):
    """A message, a type or a bag cannot be read or written."""


class SupervisorError(MrtaError):
    """The stream contradicts itself in a way that supervision cannot go on."""


class RobotError(MrtaError):
    """The host of a robot cannot carry out what its agent decided."""


class SimError(MrtaError):
    """A simulated world cannot be built or stepped."""


class RenderError(MrtaError):
    """A picture cannot be drawn or written."""


@dataclass(frozen=True, order=True)
class Problem:
    """One thing that is wrong with one place of an input.

    Attributes:
        path: the file, or the name of the object where there is no file.
        line: 1-based line in the file; 0 where a line makes no sense.
        element: what the line speaks of, for instance ``robots/robot_0/id`` or a parameter's path.
        message: what is wrong with the value received; what is accepted.
    """

    path: str
    line: int
    element: str
    message: str

    def __str__(self) -> str:
        where = f"{self.path}:{self.line}" if self.line else self.path
        return ": ".join(part for part in (where, self.element, self.message) if part)


class ConfigError(MrtaError):
    """A file or value of a configuration is not acceptable; carries all problems at once.

    Attributes:
        problems: every problem found, sorted by path, line and element.
    """

    def __init__(self, problems: Iterable[Problem]) -> None:
        self.problems: Tuple[Problem, ...] = tuple(sorted(set(problems)))
        super().__init__("\n".join(str(problem) for problem in self.problems))
