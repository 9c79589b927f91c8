"""Whose message is it: robots by the namespaces of topics and callers."""

from __future__ import annotations

from typing import Container, Mapping, Optional

from rqt_mrta_py.hooks import Connection
from rqt_mrta_py.supervisor.robots import RobotWatch

__all__ = ["Presence"]


class Presence:
    """Finds the robot in whose namespace messages are published.

    Args:
        robots: by normalised id; may grow.
        naming: topics whose messages themselves name the robot that speaks. There the caller does not count: some
            recorders write all publishers of a topic under the name of one.
    """

    def __init__(self, robots: Mapping[str, RobotWatch], naming: Container[str] = ()) -> None:
        self._robots = robots
        self._naming = naming

    def owner(self, connection: Connection) -> Optional[RobotWatch]:
        """Find the robot whose messages come on a connection; that holds until another robot joins.

        Returns:
            The robot in whose namespace the caller is, else the one in whose namespace the topic is, else None;
            None too where the message itself names its robot.
        """
        if connection.topic in self._naming:
            return None
        return self._find(connection.caller) or self._find(connection.topic)

    def _find(self, name: str) -> Optional[RobotWatch]:
        """Find the robot with the longest id whose namespace a resolved name lies in."""
        robot_id = name[1:]
        while "/" in robot_id:
            robot_id = robot_id.rsplit("/", 1)[0]
            if robot_id in self._robots:
                return self._robots[robot_id]
        return None
