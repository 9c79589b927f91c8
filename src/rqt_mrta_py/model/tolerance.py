"""How much worse a figure of a mission may be than that of the mission it is compared with."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

__all__ = ["Tolerance", "Worse"]


class Worse(Enum):
    """Which way a figure gets worse."""

    HIGHER = "higher"
    LOWER = "lower"
    EITHER = "either"
    NEVER = "never"


@dataclass(frozen=True)
class Tolerance:
    """What is allowed of figures whose names match a pattern.

    The greater of the two allowances counts.

    Attributes:
        figure: name of a figure; ``*`` stands for any characters, ``?`` for one, ``[xy]`` for one of those.
        worse: which way these figures get worse.
        relative: allowed change as a share of the first mission's figure, at least 0.
        absolute: allowed change in the figure's own unit, at least 0.
    """

    figure: str
    worse: Worse
    relative: float = 0.0
    absolute: float = 0.0

    def __post_init__(self) -> None:
        if not (self.relative >= 0.0 and self.absolute >= 0.0):
            raise ValueError(f"tolerances must be from 0 (got {self.relative!r}, {self.absolute!r})")

    def allowance(self, first: float) -> float:
        """Give the allowed change from the first mission's figure, in its unit."""
        return max(self.absolute, self.relative * abs(first))
