"""Whose message is it: robots by the namespaces of topics and callers."""

from __future__ import annotations

from typing import Container, Dict, Mapping, Optional, Tuple

from rqt_mrta_py.supervisor.robots import RobotWatch

__all__ = ["Presence"]


class Presence:
    """Finds the robot in whose namespace a message was published.

    Args:
        robots: by normalised id; may grow.
        naming: topics whose messages themselves name the robot that speaks. There the caller does not count: some
            recorders write all publishers of a topic under the name of one.
    """

    def __init__(self, robots: Mapping[str, RobotWatch], naming: Container[str] = ()) -> None:
        self._robots = robots
        self._naming = naming
        self._known = 0
        self._owners: Dict[Tuple[str, str], Optional[RobotWatch]] = {}

    def owner(self, topic: str, caller: str) -> Optional[RobotWatch]:
        """Find a message's robot.

        Args:
            topic: resolved.
            caller: resolved name of the node that published it; empty if unknown.

        Returns:
            The robot in whose namespace the caller is, else the one in whose namespace the topic is, else None;
            None too where the message itself names its robot.
        """
        if len(self._robots) != self._known:
            self._owners.clear()
            self._known = len(self._robots)
        key = (topic, caller)
        if key not in self._owners:
            self._owners[key] = None if topic in self._naming else self._find(caller) or self._find(topic)
        return self._owners[key]

    def _find(self, name: str) -> Optional[RobotWatch]:
        """Find the robot with the longest id whose namespace a resolved name lies in."""
        robot_id = name[1:]
        while "/" in robot_id:
            robot_id = robot_id.rsplit("/", 1)[0]
            if robot_id in self._robots:
                return self._robots[robot_id]
        return None
