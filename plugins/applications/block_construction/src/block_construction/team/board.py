"""What teammates have said: where they are and will be, what they have placed, and who is there no more."""

from __future__ import annotations

import math
from typing import Any, Callable, Dict, FrozenSet, List, Mapping, Optional, Sequence, Set, Tuple

from block_construction.team.driver import Driver
from block_construction.team.peers import Dock, Peer, dock_at, peer_ways
from block_construction.team.timed_way import TimedPoint, TimedWay
from block_construction.team.traffic import Traffic
from rqt_mrta_py.hooks import Heard, Perception, Subscription

__all__ = ["ROBOT_REMOVED", "TeamBoard"]

ROBOT_REMOVED = "/mrta/robot_removed"

_STATE_FIELDS = (
    *("header/stamp", "task", "activity", "pose/x", "pose/y"),
    *("way_time", "way_x", "way_y", "goal", "placed", "missing"),
)
_SILENT = 5.0
"""Who has said nothing for so long stays where he was, as far as others know [s]."""
_SAME_PLACE = 0.02
"""A robot that says to be so near where it stood stands there still [m]."""
_AT_WORK = ("driving", "fetching", "placing")

TaskDocks = Callable[[], Mapping[str, Dock]]


class TeamBoard:
    """Hears what teammates say.

    Who has been silent for 5 s stands where it last said to be, for ever, until an operator tells that it was removed.
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
        self._peers: Tuple[object, Tuple[Peer, ...]] = (None, ())
        self._kept: object = None

    def subscriptions(self) -> Sequence[Subscription]:
        """Hear what the others say, where they are, and who was removed."""
        wishes: List[Subscription] = [Subscription(ROBOT_REMOVED, "std_msgs/String", ("data",))]
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

    def others(self, perception: Perception) -> Sequence[TimedWay]:
        """Give the ways that teammates have reserved."""
        return peer_ways(self.peers(perception))

    def may_enter(self, perception: Perception, claim: str) -> bool:
        """Let everybody go: a place belongs to whoever has reserved a way that ends there."""
        return True

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
        key = (tuple(map(id, heard.values())), silent, tuple(map(id, unknown)), len(self._removed))
        if key != self._peers[0]:
            found = []
            for robot, is_silent in zip(self._others, silent):
                peer = self._peer(robot, heard[robot], perception, is_silent)
                if peer is not None:
                    found.append(peer)
            # The messages are kept, so that their identities stay theirs.
            self._peers = (key, tuple(found))
            self._kept = (heard, unknown)
        return self._peers[1]

    def _take_in_removals(self, perception: Perception) -> None:
        announced = perception.newest(ROBOT_REMOVED)
        if announced is not None and announced is not self._announced:
            self._announced = announced
            self._removed[str(announced.fields["data"])] = announced.receipt

    @staticmethod
    def _is_placed_again(number: int, told: Sequence[Heard]) -> bool:
        """Tell whether somebody who has not found a block missing says that it lies in its slot."""
        missing = max(heard.receipt for heard in told if number in heard.fields["missing"])
        return any(
            number in heard.fields["placed"] and number not in heard.fields["missing"] and heard.receipt > missing
            for heard in told
        )

    def _peer(self, robot: str, heard: Optional[Heard], perception: Perception, silent: bool) -> Optional[Peer]:
        if heard is None:
            pose = perception.newest(_pose(robot))
            if pose is None or self._is_removed(robot, pose):
                return None
            place = (float(pose.fields["pose/position/x"]), float(pose.fields["pose/position/y"]))
            return Peer(robot, (self._stand(robot, perception.now, place),), idle=True)
        if self._is_removed(robot, heard):
            return None
        fields = heard.fields
        way = _way(fields)
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


def _way(fields: Mapping[str, Any]) -> TimedWay:
    points = zip(fields["way_time"], fields["way_x"], fields["way_y"])
    return tuple([TimedPoint(float(time), float(x), float(y)) for time, x, y in points])
