"""What it means that messages came, whatever they say."""

from __future__ import annotations

from itertools import repeat
from typing import Callable, Dict, Optional, Sequence, Tuple

from rqt_mrta_py.hooks import Connection, Sighting, Stamped
from rqt_mrta_py.supervisor.message_key import MessageKey
from rqt_mrta_py.supervisor.presence import Presence
from rqt_mrta_py.supervisor.robots import RobotWatch
from rqt_mrta_py.supervisor.team import Team

__all__ = ["Sightings"]


class Sightings:
    """Takes in that messages came: time passes, and their robots count as heard.

    Args:
        team: who is told.
        presence: knows whose messages they are.
        enter: called with a message before anything follows from it, perhaps repeatedly; lets time pass up to it.
    """

    def __init__(self, team: Team, presence: Presence, enter: Callable[[MessageKey], None]) -> None:
        self._team = team
        self._presence = presence
        self._enter = enter
        self._owners: Dict[int, Optional[RobotWatch]] = {}
        self._known = -1

    def of(self, connections: Sequence[Connection]) -> Sighting:
        """Give who is told of the messages of some connections, where one of each comes at one moment.

        Args:
            connections: one or more.
        """
        return self._of_one(connections[0]) if len(connections) == 1 else self._of_several(connections)

    def owner(self, connection: Connection) -> Optional[RobotWatch]:
        """Give the robot whose messages come on a connection; None if of none that is known so far."""
        return self._presence.owner(connection)

    def together(self, messages: Sequence[Stamped], ordinals: Sequence[int]) -> None:
        """Take in that messages came, while all robots are heard, nothing is to be settled and nothing falls due.

        Of each robot only its last one counts then.

        Args:
            messages: in order; their connections live as long as this.
            ordinals: of each.
        """
        team = self._team
        if len(team.robots) != self._known:
            self._known = len(team.robots)
            self._owners.clear()
        owners = self._owners
        last: Dict[RobotWatch, Tuple[Stamped, int]] = {}
        for stamped, ordinal in zip(messages, ordinals):
            connection = stamped[0]
            try:
                robot = owners[id(connection)]
            except KeyError:
                robot = owners[id(connection)] = self._presence.owner(connection)
            if robot is not None:
                last[robot] = (stamped, ordinal)
        for robot, ((connection, receipt_ns, _), ordinal) in last.items():
            robot.heard_at = receipt_ns / 1_000_000_000
            robot.last_message = (connection.topic, robot.heard_at, ordinal)

    # Nearly all messages of a mission end in one of these two, and nearly always time stands still and nothing waits
    # for them.

    def _of_one(self, connection: Connection) -> Sighting:
        topic, team, enter, owner = connection.topic, self._team, self._enter, self._presence.owner
        book, robots = team.book, team.robots
        robot: Optional[RobotWatch] = None
        known = -1

        def sight(receipt: float, ordinals: Sequence[int]) -> None:
            nonlocal robot, known
            message = (topic, receipt, ordinals[0])
            if receipt > team.now or book.unsettled:
                enter(message)
            if len(robots) != known:
                robot, known = owner(connection), len(robots)
            if robot is None:
                return
            if robot.silent or book.expired:
                enter(message)
                team.hear(robot, message)
            else:
                robot.heard_at, robot.last_message = team.now, message

        return sight

    def _of_several(self, connections: Sequence[Connection]) -> Sighting:
        topics = tuple([connection.topic for connection in connections])
        team, enter, owner = self._team, self._enter, self._presence.owner
        book, robots, expired = team.book, team.robots, team.book.expired
        owners: Sequence[Optional[RobotWatch]] = ()
        known = -1

        def sight(receipt: float, ordinals: Sequence[int]) -> None:
            nonlocal owners, known
            if receipt > team.now:
                enter((topics[0], receipt, ordinals[0]))
            if len(robots) != known:
                owners, known = [owner(connection) for connection in connections], len(robots)
            now = team.now
            for robot, message in zip(owners, zip(topics, repeat(receipt), ordinals)):
                if book.unsettled:
                    enter(message)
                if robot is None:
                    continue
                if robot.silent or expired:
                    enter(message)
                    team.hear(robot, message)
                else:
                    robot.heard_at = now
                    robot.last_message = message

        return sight
