"""Why a task went to whom it went: who could have had it, who took it when, and on what grounds.

All times are seconds on the stream's clock (receipt).
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Mapping, NamedTuple, Optional, Tuple, Union

from rqt_mrta_py.model.states import Outcome, RobotState, TaskState
from rqt_mrta_py.model.task import Task

__all__ = ["Candidate", "Explanation", "Ground", "Spell", "Whereabouts"]

GroundValue = Union[str, bool, int, float, None]


@dataclass(frozen=True)
class Ground:
    """Something that speaks for or against that a robot takes a task, as an architecture's own messages tell it.

    Attributes:
        time: when it was said, or fell due [s].
        task: id of the task that it is about.
        text: what it is, in a few words that go on after the robot's name.
        robot: normalised id of the robot whose ground it is; empty: of none in particular.
        values: numbers and words that it rests on, by name; units in the names, where they are not 1.
    """

    time: float
    task: str
    text: str
    robot: str = ""
    values: Mapping[str, GroundValue] = field(default_factory=dict)


class Candidate(NamedTuple):
    """A robot that a task could go to, or not.

    Attributes:
        robot: its id.
        able: whether it may and can carry the task out; None: nobody knows.
        why: the reason, in a few words.
    """

    robot: str
    able: Optional[bool]
    why: str


class Whereabouts(NamedTuple):
    """What a robot was doing over [start, end) [s].

    Attributes:
        robot: its id.
        state: of the robot; None: nothing is known of it yet.
        tasks: ids of what it held, by start.
        start, end: how long it did so; at least as long as it is asked about [s].
    """

    robot: str
    state: Optional[RobotState]
    tasks: Tuple[str, ...]
    start: float
    end: float


@dataclass(frozen=True)
class Spell:
    """A time over [start, end) [s] in which one robot held the task, or nobody did.

    Attributes:
        start, end: when [s].
        robot: who held it; empty: nobody.
        outcome: how that ended; None: nobody held it.
        states: of the task, in the order in which it went through them.
        text: why it ended so; empty if nobody says.
        others: robots that could have had it: what they were doing when it was taken, or all the while if nobody had
            it; in the order of candidates, each by start.
        more: how much of that is left out.
    """

    start: float
    end: float
    robot: str = ""
    outcome: Optional[Outcome] = None
    states: Tuple[TaskState, ...] = ()
    text: str = ""
    others: Tuple[Whereabouts, ...] = ()
    more: int = 0


@dataclass(frozen=True)
class Explanation:
    """Why one task went to whom it went.

    Attributes:
        task: its id.
        definition: what it is; None if nobody says.
        state: at the end.
        candidates: every robot that is known, in the record's order.
        spells: holds and times between them, by start.
        grounds: by time; of very many the first and the last.
        more: how many grounds are left out.
        note: what is to be known of the grounds, such as that there is nobody who tells them; may be empty.
    """

    task: str
    definition: Optional[Task]
    state: TaskState
    candidates: Tuple[Candidate, ...] = ()
    spells: Tuple[Spell, ...] = ()
    grounds: Tuple[Ground, ...] = ()
    more: int = 0
    note: str = ""
