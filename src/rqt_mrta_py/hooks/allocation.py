"""How an architecture's own signs tell what became of an allocation.

Topics alone say who holds a task; why it was let go, each architecture says in its own words. An interpreter hears
them and answers in the supervisor's.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable, NamedTuple, Optional, Protocol, Sequence, Tuple, Union

from rqt_mrta_py.hooks.stream import Heard, Subscription
from rqt_mrta_py.model import Outcome

__all__ = [
    "AllocationInterpreter",
    "AllocationInterpreterFactory",
    "AllocationSign",
    "Applicability",
    "InterpreterSetup",
]


class AllocationSign(NamedTuple):
    """What one message says of one robot and one task.

    Attributes:
        robot: normalised id.
        task: its id.
        outcome: how the allocation ended with this message; None: the robot still holds the task.
        text: why, in a few words.
    """

    robot: str
    task: str
    outcome: Optional[Outcome] = None
    text: str = ""


class Applicability(NamedTuple):
    """What one message says of whether a robot can carry out a task now; to be told when it changes.

    Attributes:
        robot: normalised id; empty: of all robots.
        task: its id.
        applicable: whether it can; what nobody has said counts as true.
    """

    robot: str
    task: str
    applicable: bool


@dataclass(frozen=True)
class InterpreterSetup:
    """What an interpreter is made from: ids of the known robots and tasks; both may be empty for a foreign bag."""

    robots: Tuple[str, ...]
    tasks: Tuple[str, ...]


class AllocationInterpreter(Protocol):
    """Reads one architecture's signs.

    One with an attribute ``repeats_matter`` that is False may be told of fewer messages: where those of one connection
    say the same again and again in all fields asked for, the first, then the last before anything changes, and each
    once a robot or task has changed that its answer to the one before spoke of. So reviews are quicker; what follows
    from a message must then be the same though it be heard twice, and depend on what was said of its own robot and task
    alone: to one that repeats another the answer counts as known. If its attribute ``last_matters`` lists some of its
    subscriptions, it is told so of the last of their messages only; those are to be listed of which it remembers when
    they were heard.
    """

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear; asked once. Names must be absolute or patterns."""
        ...

    def hear(self, heard: Heard) -> Sequence[Union[AllocationSign, Applicability]]:
        """Answer what one message says of allocations, or of who can carry out what; usually nothing."""
        ...


AllocationInterpreterFactory = Callable[[InterpreterSetup], AllocationInterpreter]
