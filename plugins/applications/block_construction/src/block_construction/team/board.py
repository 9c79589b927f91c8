"""What teammates have said: where they are and will be, what they have placed, and who is there no more."""

from __future__ import annotations

import math
from typing import Callable, Dict, FrozenSet, List, Mapping, Optional, Sequence, Set, Tuple

from block_construction.team.driver import Driver
from block_construction.team.peers import Dock, Peer, dock_at
from block_construction.team.removals import REMOVALS, removed_robots
from block_construction.team.timed_way import TimedPoint, TimedWay, place_at
from block_construction.team.traffic import Traffic
from rqt_mrta_py.hooks import Heard, Perception, Subscription

__all__ = ["TeamBoard"]

_STATE_FIELDS = (
    *("header/stamp", "task", "activity", "pose/x", "pose/y"),
    *("way_time", "way_x", "way_y", "goal", "placed", "missing"),
)
_SILENT = 5.0
"""Who has said nothing for so long stays where he was, as far as others know [s]."""
_SAME_PLACE = 0.02
"""A robot that says to be so near where it stood stands there still [m]."""
_OFF_ITS_WAY = 0.09
"""Who is farther from where its way says follows it no more [m]: it would ask for another one at 6 cm, and the poses
that are told may be off."""
_AT_WORK = ("driving", "fetching", "placing")
_PROCEDURES = ("fetching", "placing")

TaskDocks = Callable[[], Mapping[str, Dock]]


class TeamBoard:
    """Hears what teammates say.

    Who has been silent for 5 s stands where it last said to be, for ever, until an operator tells that it was removed.
    An operator names all who were removed so far, for only the newest message is heard; who speaks again is back.
    Who is seen off the way that it has reserved, for it has let go of its task or has stopped, stands where it is seen.
    Of who has not said anything yet, the localiser says where it is.

    Args:
        robot_id: of the robot that hears.
        team: ids of all robots, this one included.
        speed: of every robot [m/s].
        docks: gives those of all slots, by the tasks' ids.
    """

    def __init__(self, robot_id: str, team: Sequence[str], speed: float, docks: TaskDocks) -> None:
        self._robot_id, self._speed, self._docks = robot_id, speed, docks
        self._others = tuple(robot for robot in team if robot != robot_id)
        self._removed: Dict[str, float] = {}
        self._announced: Optional[Heard] = None
        self._standing: Dict[str, TimedPoint] = {}
        self._driver: Optional[Driver] = None
        self._ways: Dict[str, Tuple[Heard, TimedWay]] = {}
        self._peers: Tuple[object, Tuple[Peer, ...]] = (None, ())
        self._kept: object = None

    def subscriptions(self) -> Sequence[Subscription]:
        """Hear what the others say, where they are, and who was removed."""
        wishes: List[Subscription] = [REMOVALS]
        for robot in self._others:
            wishes.append(Subscription(_state(robot), "block_construction/BuilderState", _STATE_FIELDS))
            wishes.append(
                Subscription(_pose(robot), "geometry_msgs/PoseStamped", ("pose/position/x", "pose/position/y"))
            )
        return wishes

    def driver(self, traffic: Traffic) -> Driver:
        """Give who reserves this robot's ways."""
        if self._driver is None:
            self._driver = Driver(self._robot_id, traffic, self._speed)
        return self._driver

    def places(self, perception: Perception) -> Sequence[Tuple[float, float]]:
        """Give where the teammates that are there were seen last [m]."""
        seen = [perception.newest(_pose(peer.id)) for peer in self.peers(perception)]
        return [_place(pose) for pose in seen if pose is not None]

    def placed(self, perception: Perception) -> FrozenSet[int]:
        """Give the numbers of the blocks that teammates have seen in their slots, and none found missing since."""
        placed: Set[int] = set()
        gone: Dict[int, float] = {}
        told = [heard for heard in map(perception.newest, map(_state, self._others)) if heard is not None]
        for heard in sorted(told, key=lambda heard: heard.receipt):
            for number in heard.fields["missing"]:
                gone[int(number)] = heard.receipt
            placed.update(int(number) for number in heard.fields["placed"])
        return frozenset(placed - {number for number in gone if not self._is_placed_again(number, told)})

    def peers(self, perception: Perception) -> Tuple[Peer, ...]:
        """Give what is known of the teammates that are there, by their ids."""
        self._take_in_removals(perception)
        heard = {robot: perception.newest(_state(robot)) for robot in self._others}
        silent = tuple(each is not None and perception.now - each.receipt > _SILENT for each in heard.values())
        unknown = [perception.newest(_pose(robot)) for robot, each in heard.items() if each is None]
        astray = [self._astray(robot, each, perception) for robot, each in heard.items()]
        key = (
            tuple(map(id, heard.values())),
            silent,
            tuple(map(id, unknown)),
            tuple(astray),
            tuple(self._removed.items()),
        )
        if key != self._peers[0]:
            found = []
            for robot, is_silent, stands in zip(self._others, silent, astray):
                peer = self._peer(robot, heard[robot], perception, is_silent, stands)
                if peer is not None:
                    found.append(peer)
            # The messages are kept, so that their identities stay theirs.
            self._peers = (key, tuple(found))
            self._kept = (heard, unknown)
        return self._peers[1]

    def _take_in_removals(self, perception: Perception) -> None:
        announced = perception.newest(REMOVALS.topic)
        if announced is not None and announced is not self._announced:
            self._announced = announced
            for robot in removed_robots(announced):
                self._removed[robot] = announced.receipt

    @staticmethod
    def _is_placed_again(number: int, told: Sequence[Heard]) -> bool:
        """Tell whether somebody who has not found a block missing says that it lies in its slot."""
        missing = max(heard.receipt for heard in told if number in heard.fields["missing"])
        return any(
            number in heard.fields["placed"] and number not in heard.fields["missing"] and heard.receipt > missing
            for heard in told
        )

    def _astray(self, robot: str, heard: Optional[Heard], perception: Perception) -> Optional[TimedPoint]:
        """Give where a robot stands that is not where it said that it would be; None if it is, or nobody knows."""
        seen = perception.newest(_pose(robot))
        if heard is None or seen is None or heard.fields["activity"] in _PROCEDURES:
            return None
        way, place = self._way(robot, heard), _place(seen)
        if not way or seen.receipt < heard.receipt or math.dist(place_at(way, seen.receipt), place) <= _OFF_ITS_WAY:
            return None
        return self._stand(robot, heard.receipt, place)

    def _peer(
        self, robot: str, heard: Optional[Heard], perception: Perception, silent: bool, astray: Optional[TimedPoint]
    ) -> Optional[Peer]:
        if heard is None:
            pose = perception.newest(_pose(robot))
            if pose is None or self._is_removed(robot, pose):
                return None
            return Peer(robot, (self._stand(robot, perception.now, _place(pose)),), idle=True)
        if self._is_removed(robot, heard):
            return None
        fields = heard.fields
        if astray is not None:
            return Peer(robot, (astray,), idle=True)
        way = self._way(robot, heard)
        if silent or not way:
            place = (float(fields["pose/x"]), float(fields["pose/y"]))
            return Peer(robot, (self._stand(robot, heard.receipt, place),), idle=silent or not fields["task"])
        self._standing.pop(robot, None)
        docks = self._docks()
        works = fields["activity"] in _AT_WORK
        target = docks.get(fields["task"]) if fields["activity"] not in ("placing", "idle") else None
        goal = Dock(*map(float, fields["goal"])) if len(fields["goal"]) == 4 else None
        dock = dock_at((way[-1].x, way[-1].y), list(docks.values())) if works else None
        return Peer(robot, way, dock, goal, target, task=fields["task"], lingers=fields["activity"] == "idle")

    def _way(self, robot: str, heard: Heard) -> TimedWay:
        """Read the way that a robot has reserved, once."""
        known = self._ways.get(robot)
        if known is None or known[0] is not heard:
            fields = heard.fields
            points = zip(fields["way_time"], fields["way_x"], fields["way_y"])
            way = tuple([TimedPoint(float(time), float(x), float(y)) for time, x, y in points])
            known = self._ways[robot] = (heard, way)
        return known[1]

    def _is_removed(self, robot: str, heard: Heard) -> bool:
        removed = self._removed.get(robot)
        return removed is not None and heard.receipt <= removed

    def _stand(self, robot: str, time: float, place: Tuple[float, float]) -> TimedPoint:
        known = self._standing.get(robot)
        if known is None or math.dist(known[1:], place) > _SAME_PLACE:
            known = self._standing[robot] = TimedPoint(time, *place)
        return known


def _state(robot: str) -> str:
    return f"/{robot}/builder_state"


def _pose(robot: str) -> str:
    return f"/{robot}/pose"


def _place(pose: Heard) -> Tuple[float, float]:
    return float(pose.fields["pose/position/x"]), float(pose.fields["pose/position/y"])
