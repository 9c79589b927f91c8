"""Repeats: messages that say what the one before them said, of which only the last before anything changes counts.

A robot says ten times a second what it does. Each such message puts off when that expires, and does no more; so who
reads a recording hears the last of them alone, as long as nothing falls due, and comes to the same.
"""

from __future__ import annotations

import math
from enum import Enum
from typing import Callable, Dict, FrozenSet, List, Optional, Sequence, Set, Tuple

from rqt_mrta_py.hooks import (
    AllocationEnded,
    AllocationExpired,
    AllocationStarted,
    Connection,
    Fact,
    Heard,
    RobotHeard,
    RobotSilent,
    RobotStateChanged,
    Subscription,
    TaskStateChanged,
    TopicSilent,
)
from rqt_mrta_py.supervisor.agenda import Due, Entry, due_after
from rqt_mrta_py.supervisor.clocks import Timekeeper, Voice
from rqt_mrta_py.supervisor.ears import Callback, Ears
from rqt_mrta_py.supervisor.echo import Echo, Name
from rqt_mrta_py.supervisor.message_key import MessageKey
from rqt_mrta_py.supervisor.robots import RobotWatch
from rqt_mrta_py.supervisor.team import Team
from rqt_mrta_py.supervisor.topics import Topics

__all__ = ["Attention", "Repeats", "look_again"]

_TURNS = (
    AllocationEnded,
    AllocationExpired,
    AllocationStarted,
    RobotHeard,
    RobotSilent,
    RobotStateChanged,
    TaskStateChanged,
    TopicSilent,
)
"""Facts after which a message that repeats another one may say something new."""

_Pairs = Sequence[Tuple[Subscription, Callback]]


class Attention(Enum):
    """Which of the messages that repeat one another somebody must hear."""

    ECHO = "echo"
    """The first, as long as nothing changes of what it speaks of: from others that say the same the same follows."""
    LAST = "last"
    """The first, and the last before anything changes."""
    EACH = "each"
    """Each, in its order; nothing follows from it for robots, tasks or allocations."""
    TIMED = "timed"
    """Each, but of those whose stamps are as they should be only when it was received."""
    AT_ONCE = "at_once"
    """Each, and all that came before on any topic must have been taken in by then."""


class Repeats:
    """Tells when messages need not be heard one by one, and takes in that they came.

    Args:
        topics: of the architecture.
        team: see ``Team``.
        ears: know whose messages come on a connection.
        timekeeper: holds receipts against one another.
        next_due: when something happens without a message [s].
        enter: lets time pass up to a message.
    """

    def __init__(
        self,
        topics: Topics,
        team: Team,
        ears: Ears,
        timekeeper: Timekeeper,
        *,
        next_due: Callable[[], float],
        enter: Callable[[MessageKey], None],
    ) -> None:
        self._topics = topics
        self._team = team
        self._ears = ears
        self._timekeeper = timekeeper
        self._next_due = next_due
        self._enter = enter
        self._facts = 0
        self._turned: Set[Name] = set()
        self._admitted = (0, 0)
        self._attention: Dict[Callback, Attention] = {}

    def sort(self, ears: _Pairs, interpreter: _Pairs, timing: _Pairs, last: Optional[Sequence[Subscription]]) -> None:
        """Take note of who hears what.

        Args:
            ears: what monitored topics say.
            interpreter: what the architecture's own messages say.
            timing: who holds receipts against one another.
            last: of what the interpreter hears only the last of messages that repeat one another matters, and of the
                rest only the first; None: it must hear each.
        """
        again: List[Subscription] = []
        once: List[Subscription] = []
        topics = self._topics
        for reader in (*topics.busy, *topics.idle, *topics.allocated):
            # What another id stands for may change without a word here.
            (again if reader.table is None else once).append(reader.subscription())
        once += [reader.subscription() for reader in (*topics.incoming, *topics.completed, *topics.failed)]
        habitual = frozenset(again) - frozenset(once)
        for wish, callback in ears:
            self._attention[callback] = Attention.ECHO if wish in habitual else Attention.AT_ONCE
        for wish, callback in interpreter:
            known = Attention.ECHO if last is None or wish not in last else Attention.LAST
            self._attention[callback] = Attention.AT_ONCE if last is None else known
        self._attention.update((callback, Attention.TIMED) for _, callback in timing)

    def attention(self, callback: Callback) -> Attention:
        """Say which of the messages that repeat one another somebody must hear."""
        return self._attention.get(callback, Attention.EACH)

    def note(self, fact: Fact) -> None:
        """Take note of a fact."""
        self._facts += 1
        if isinstance(fact, _TURNS):
            self._turned.add((getattr(fact, "robot", ""), getattr(fact, "task", "")))

    @property
    def stirrings(self) -> int:
        """How often a message said anything that mattered, or would have, had it not been late."""
        return self._facts + self._team.book.late

    def listen(self) -> Echo:
        """Record what the next message does, from now until this is called again.

        Returns:
            What it does, and so messages that say the same; but for what they tell an interpreter.
        """
        echo = self._team.echo = Echo()
        return echo

    def turned(self) -> Optional[Set[Name]]:
        """Tell what has changed since this was last asked.

        Returns:
            Robots and tasks: messages that speak of them, and repeat others, may say something new. None: all may.
        """
        admitted = len(self._team.robots), len(self._team.tasks)
        turned: Optional[Set[Name]] = self._turned
        if admitted != self._admitted:
            self._admitted, turned = admitted, None
        self._turned = set()
        return turned

    def follow(self, echo: Echo, message: MessageKey) -> None:
        """Take in a message of which only that follows which followed from one before it."""
        echo.follow(message, self._team.agenda)

    def tell_again(self, heard: Heard) -> None:
        """Let the interpreter hear a message that says what the one before it said."""
        self._ears.hear_again(heard)

    @property
    def quiet_until(self) -> float:
        """A time up to which nothing falls due, as far as is known now [s].

        Minus infinity if something is to be settled. Robots that are waited for are another matter.
        """
        return self._next_due() if self._team.robots and not self._team.book.unsettled else -math.inf

    def look_again(self) -> None:
        """Look when that which falls due next is truly due: what was heard since has put it off."""
        if not self._team.book.unsettled:
            look_again(self._team, self._topics.silence)
            self._timekeeper.look_again()

    @property
    def awaited(self) -> FrozenSet[str]:
        """Ids of the robots of which it matters that they are heard: they count as silent, or one waits for them."""
        silent = [robot.id for robot in self._team.robots.values() if robot.silent]
        return frozenset([*silent, *(robot for robot, _ in self._team.book.expired)])

    def owner(self, connection: Connection) -> Optional[RobotWatch]:
        """Give the robot whose messages come on a connection; None if of none that is known so far."""
        return self._ears.owner(connection)

    @property
    def voice(self) -> Optional[Voice]:
        """Whose message came last, of those that are timed; None if of no robot of the team."""
        return self._timekeeper.latest

    def reach(self, message: MessageKey) -> None:
        """Let time pass up to a message that nobody hears who would do so."""
        self._enter(message)


def look_again(team: Team, silence: float) -> None:
    """Look when that which stands first on a team's agenda is truly due, until it is the one that falls due first.

    Args:
        team: settled.
        silence: how long a robot says nothing until it counts as lost [s].
    """
    agenda = team.agenda
    while agenda.next < math.inf:
        due = _true_due(team, agenda.first, silence)
        if due is None:
            agenda.take()
        elif due > agenda.next:
            agenda.put_off(due)
        else:
            return


def _true_due(team: Team, entry: Entry, silence: float) -> Optional[float]:
    """Say when an entry falls due as things stand [s]; None if it stands for nothing any more."""
    kind, robot_id, task_id = entry
    if kind is Due.ROBOT_STATE:
        return team.robots[robot_id].fresh_until
    if kind is Due.SILENCE:
        return due_after(team.robots[robot_id].heard_at, silence)
    if not robot_id:
        return team.tasks[task_id].anonymous_until
    hold = team.book.find(robot_id, task_id)
    return None if hold is None or hold.expired is not None else hold.due
