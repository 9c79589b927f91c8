"""What the original nodes do otherwise than the equations, as parts to choose from: here those by the equations.

``original`` has the others. A robot's agent takes all its parts from one Timing.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable, Dict, Optional, Protocol

from mrta_alliance import equations
from mrta_alliance.equations import TIME_TOLERANCE
from mrta_alliance.history import History, TaskHistory
from mrta_alliance.parameters import AllianceParameters

__all__ = ["BY_EQUATIONS", "Announcer", "Inhibition", "PromptAnnouncer", "StandingInhibition", "Timing"]


class Inhibition(Protocol):
    """Knows which behaviour sets of a robot keep which others down."""

    def note(self, task: str, active: bool) -> None:
        """Remember whether the behaviour set for a task is active now; told after everything that may change it."""
        ...

    def inhibits(self, task: str) -> bool:
        """Judge whether the behaviour set for a task is kept down (equation 3.2)."""
        ...


class Announcer(Protocol):
    """Knows when the robot announces what it does."""

    def due(self, task: Optional[str], now: float) -> Optional[str]:
        """Tell which task to announce now, if any; asked once a cycle.

        Args:
            task: that the robot carries out; None if it does nothing.
            now: the time of this cycle [s].
        """
        ...


class StandingInhibition:
    """Inhibited while any other set is active (equation 3.2); implements Inhibition."""

    def __init__(self) -> None:
        """Start with nothing active."""
        self._active: Dict[str, None] = {}

    def note(self, task: str, active: bool) -> None:
        """Remember whether the behaviour set for a task is active now."""
        if active:
            self._active[task] = None
        else:
            self._active.pop(task, None)

    def inhibits(self, task: str) -> bool:
        """Judge by equation 3.2; sets that are not active need no asking, so the cost does not grow with them."""
        return equations.inhibited(other != task for other in self._active)


class PromptAnnouncer:
    """Announces a task in the cycle in which it is taken up, then once a period; implements Announcer.

    Differs from the original nodes: there the first announcement goes out one period later. In that period the
    original leaves everybody else free to take up the same task, and a supervisor without a word on who has it.
    """

    def __init__(self, period: float) -> None:
        """Start with nothing announced.

        Args:
            period: of announcements [s].
        """
        self._period = period
        self._announced: Optional[str] = None
        self._next = 0.0

    def due(self, task: Optional[str], now: float) -> Optional[str]:
        """Tell which task to announce now, if any."""
        begun = task != self._announced
        self._announced = task
        if task is None:
            return None
        if begun:
            self._next = now
        if now < self._next - TIME_TOLERANCE:
            return None
        # Due times keep their period, though only cycles can meet them; a robot that had stopped does not catch up.
        due = self._next + self._period
        self._next = due if due > now else now + self._period
        return task


@dataclass(frozen=True)
class Timing:
    """The parts of one robot's agent.

    Attributes:
        hears_first: whether a cycle takes in what came before it evaluates, not after.
        extended: whether extensions of the equations count: head start and fairness.
        history: makes a task's memory of announcements.
        inhibition: makes the robot's.
        announcer: makes the robot's, from the period of announcements [s].
    """

    hears_first: bool
    extended: bool
    history: Callable[[AllianceParameters], TaskHistory]
    inhibition: Callable[[], Inhibition]
    announcer: Callable[[float], Announcer]


BY_EQUATIONS = Timing(
    hears_first=True,
    extended=True,
    history=lambda told: History(told.buffer_horizon),
    inhibition=StandingInhibition,
    announcer=PromptAnnouncer,
)
"""What this package does unless told otherwise."""
