"""The supervisor's ears: which topics to hear, and what each of their messages tells the team."""

from __future__ import annotations

from functools import partial
from typing import Callable, List, Optional, Sequence, Tuple

from rqt_mrta_py.hooks import (
    AllocationInterpreter,
    Applicability,
    Connection,
    Heard,
    Sighting,
    Stamped,
    Subscription,
)
from rqt_mrta_py.model import Progress, RobotState, normalise_id
from rqt_mrta_py.supervisor.interpreter_ear import InterpreterEar, Sign
from rqt_mrta_py.supervisor.joins import JoinTable
from rqt_mrta_py.supervisor.message_key import MessageKey, key_of
from rqt_mrta_py.supervisor.presence import Presence
from rqt_mrta_py.supervisor.readers import TopicReader
from rqt_mrta_py.supervisor.robots import RobotWatch
from rqt_mrta_py.supervisor.sightings import Sightings
from rqt_mrta_py.supervisor.statements import Report, Statements
from rqt_mrta_py.supervisor.team import Team
from rqt_mrta_py.supervisor.topics import Topics
from rqt_mrta_py.supervisor.values import STAMP, text_of
from rqt_mrta_py.wording import shown

__all__ = ["Callback", "Ears"]

Callback = Callable[[Heard], None]

_PROGRESS_TOPIC = "/mrta/task_progress"
_PROGRESS_TYPE = "rqt_mrta_py/TaskProgress"
_OPERATOR = frozenset({Progress.APPEARED, Progress.WITHDRAWN, Progress.REASSIGNED})


class Ears:
    """Turns messages into what the team is told.

    Args:
        topics: what to hear of the architecture.
        team: who is told.
        enter: called with each message first, perhaps repeatedly; lets time pass up to it.
        report: takes a message that makes no sense, and why.
    """

    def __init__(
        self,
        topics: Topics,
        team: Team,
        enter: Callable[[MessageKey], None],
        report: Callable[[Heard, str], None],
    ) -> None:
        self._topics = topics
        self._team = team
        self._enter = enter
        self._report = report
        self._statements = Statements(team, topics.hold)
        self._sightings = Sightings(team, Presence(team.robots, topics.naming), enter)
        self._interpreter: Optional[InterpreterEar] = None

    def sighting(self, connections: Sequence[Connection]) -> Sighting:
        """Give who is told first of all messages of connections: time passes, and their robots count as heard."""
        return self._sightings.of(connections)

    def owner(self, connection: Connection) -> Optional[RobotWatch]:
        """Give the robot whose messages come on a connection; None if of none that is known so far."""
        return self._sightings.owner(connection)

    def sight_together(self, messages: Sequence[Stamped], ordinals: Sequence[int]) -> None:
        """Take in that messages came, where nothing follows from any but the last of each robot."""
        self._sightings.together(messages, ordinals)

    def listeners(self) -> List[Tuple[Subscription, Callback]]:
        """Say what to hear, and who hears it, in the order in which one message shall be taken in."""
        topics = self._topics
        pairs = [(table.subscription(), self._hears_join(table)) for table in topics.tables]
        pairs += [self._reads(reader, self._hears_busy(reader)) for reader in topics.busy]
        pairs += [self._reads(reader, self._hears_idle(reader)) for reader in topics.idle]
        pairs += [self._reads(reader, self._hears_incoming(reader)) for reader in topics.incoming]
        pairs += [self._reads(reader, self._hears_allocated(reader)) for reader in topics.allocated]
        pairs += [self._reads(reader, self._hears_end(reader, Progress.DONE)) for reader in topics.completed]
        pairs += [self._reads(reader, self._hears_end(reader, Progress.FAILED)) for reader in topics.failed]
        paths = ("task_id", "robot_id", "progress", "detail", STAMP)
        pairs.append((Subscription(_PROGRESS_TOPIC, _PROGRESS_TYPE, paths), self._hear_progress))
        return pairs

    def listeners_for(
        self, interpreter: Optional[AllocationInterpreter], architecture: str
    ) -> Sequence[Tuple[Subscription, Callback]]:
        """Say what an interpreter wants to hear, and who hears it for it.

        Args:
            interpreter: reads the architecture's own signs; None if it has none.
            architecture: its package, for errors.

        Raises:
            HookError: the interpreter raises; names it. So do the callbacks.
        """
        if interpreter is None:
            return ()
        ear = self._interpreter = InterpreterEar(interpreter, architecture, self._come_to, self._take_sign)
        # Each with a callback of its own, by which they are told apart.
        return [(wish, partial(ear.hear)) for wish in ear.subscriptions()]

    @property
    def last_matters(self) -> Optional[Sequence[Subscription]]:
        """Of what the interpreter hears, that of which the last of messages that repeat one another matters.

        None if each of all messages does.
        """
        return None if self._interpreter is None else self._interpreter.last_matters

    def hear_again(self, heard: Heard) -> None:
        """Let the interpreter hear a message that says what the one before it said."""
        if self._interpreter is not None:
            self._interpreter.hear_again(heard)

    def _come_to(self, heard: Heard) -> None:
        self._enter(key_of(heard))

    def _take_sign(self, sign: Sign, heard: Heard) -> None:
        self._hear_speaker(sign.robot, heard)
        if isinstance(sign, Applicability):
            self._statements.judged(sign)
        else:
            self._statements.signed(sign, heard)

    def _hears_join(self, table: JoinTable) -> Callback:
        def hear(heard: Heard) -> None:
            self._enter(key_of(heard))
            table.hear(heard)

        return hear

    def _reads(self, reader: TopicReader, hear: Callback) -> Tuple[Subscription, Callback]:
        """Say what a reader wants and who hears it: only what counts, and what stands for no task is reported."""
        topic, table = reader.topic, reader.table
        if topic.condition is None and table is None:
            return reader.subscription(), hear

        def attend(heard: Heard) -> None:
            self._enter(key_of(heard))
            if not reader.counts(heard):
                return
            key = reader.key_of(heard)
            if table is not None and key and not table.find(key):
                self._report(
                    heard, f"{shown(key)} stands for no task: nothing on {table.join.name} has named it before"
                )
            hear(heard)

        return reader.subscription(), attend

    def _hears_busy(self, reader: TopicReader) -> Callback:
        # A busy message that names the task allocates it, unless its topic is listed for that by itself.
        listed = {(each.topic.name, each.topic.type) for each in self._topics.allocated}
        allocates = reader.tells_task and (reader.topic.name, reader.topic.type) not in listed
        timeout = reader.timeout
        hold = self._topics.busy_timeout

        def hear(heard: Heard) -> None:
            self._enter(key_of(heard))
            robot_id = reader.robot_of(heard)
            self._team.speak_of(robot_id)
            robot = self._team.find_robot(robot_id)
            if robot is None:
                self._statements.wonder_at_robot(robot_id, heard)
            else:
                self._team.hear(robot, key_of(heard))
                self._team.renew(robot, RobotState.BUSY, timeout)
                if allocates:
                    self._statements.allocated(reader.task_of(heard), robot.id, hold, heard)

        return hear

    def _hears_idle(self, reader: TopicReader) -> Callback:
        timeout = reader.timeout

        def hear(heard: Heard) -> None:
            self._enter(key_of(heard))
            robot_id = reader.robot_of(heard)
            self._team.speak_of(robot_id)
            robot = self._team.find_robot(robot_id)
            if robot is None:
                self._statements.wonder_at_robot(robot_id, heard)
            else:
                self._team.hear(robot, key_of(heard))
                self._team.renew(robot, RobotState.IDLE, timeout)

        return hear

    def _hears_incoming(self, reader: TopicReader) -> Callback:
        def hear(heard: Heard) -> None:
            self._enter(key_of(heard))
            self._team.appear(reader.task_of(heard))

        return hear

    def _hears_allocated(self, reader: TopicReader) -> Callback:
        timeout = max(reader.timeout, self._topics.busy_timeout)

        def hear(heard: Heard) -> None:
            self._enter(key_of(heard))
            robot_id = reader.robot_of(heard)
            self._hear_speaker(robot_id, heard)
            self._statements.allocated(reader.task_of(heard), robot_id, timeout, heard)

        return hear

    def _hears_end(self, reader: TopicReader, progress: Progress) -> Callback:
        def hear(heard: Heard) -> None:
            self._enter(key_of(heard))
            robot_id = reader.robot_of(heard)
            self._hear_speaker(robot_id, heard)
            self._statements.reported(Report(reader.task_of(heard), robot_id, progress), heard)

        return hear

    def _hear_progress(self, heard: Heard) -> None:
        self._enter(key_of(heard))
        code = heard.fields["progress"]
        progress = Progress.of_code(code)
        if progress is None:
            self._report(heard, f"progress is {code}; accepted is 0 to {len(Progress) - 1}")
            return
        robot_id = normalise_id(text_of(heard.fields, "robot_id"))
        if progress not in _OPERATOR:
            self._hear_speaker(robot_id, heard)
        task_id = normalise_id(text_of(heard.fields, "task_id"))
        detail = text_of(heard.fields, "detail")
        self._statements.reported(Report(task_id, robot_id, progress, detail), heard)

    def _hear_speaker(self, robot_id: str, heard: Heard) -> None:
        """Count the robot that a message names as heard, unless somebody is known to have sent it."""
        self._team.speak_of(robot_id)
        robot = None if heard.caller else self._team.find_robot(robot_id)
        if robot is not None:
            self._team.hear(robot, key_of(heard))
