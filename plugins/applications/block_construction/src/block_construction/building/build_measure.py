"""The measure ``build``: what was built, how exactly, and what fetching and placing took."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Dict, List, Mapping, NamedTuple, Optional, Sequence, Tuple

from block_construction.building.eyes import WITHIN
from block_construction.building.slot import KIND, BlockTask, block_task
from block_construction.building.state import BUILDER_STATE, BUILDER_STATE_TYPE
from block_construction.team.removals import REMOVALS, removed_robots
from rqt_mrta_py.hooks import Heard, MeasureSetup, Subscription
from rqt_mrta_py.model import MissionRecord

__all__ = ["BuildMeasure", "PlacingError", "errors_of"]

_STATES = Subscription(f"/@robot_id@/{BUILDER_STATE}", BUILDER_STATE_TYPE, ("task", "activity", "pose/x", "pose/y"))
_BODIES = Subscription("/simulation/bodies", "rqt_mrta_py/Detections", ("detections",))
_BUMPER = "/bumper"
_BUMPERS = Subscription(f"/@robot_id@{_BUMPER}", "std_msgs/Bool", ("data",))
_STRIDE = 0.01
"""Ways are measured between spots so far apart [m]: noise of a robot that stands is no way."""
_HEIGHT = 0.005
"""So near its height a block lies on what is under it [m]."""
_TURN = math.radians(10.0)
"""Turned no more than so far a block lies along its slot [rad]."""
_PAUSE = 2.0
"""Of a robot that says nothing for so long nobody knows what it does [s]."""


@dataclass
class _Account:
    """What robots spent on fetching or placing.

    Attributes:
        seconds: of time, waiting included [s].
        metres: of way [m].
    """

    seconds: float = 0.0
    metres: float = 0.0


@dataclass
class _Robot:
    """What was heard of one robot last."""

    task: str = ""
    activity: str = "idle"
    at: float = 0.0
    spot: Tuple[float, float] = (math.nan, math.nan)
    has_block: bool = False
    touches: bool = False


class BuildMeasure:
    """Listens to builders and to where blocks are in the end; a Measure.

    Fetching lasts from the beginning of a task until its block is drawn back from the supply place, placing from there
    until the task ends: the source's manipulation and assembly. A block counts as placed if a body as long as its
    slot lies in it: within 2 cm of the middle, within 5 mm of its height, turned by at most 10 degrees, held by nobody.

    Args:
        setup: whose mission may have tasks of kind ``place_block``; if it has none, nothing is heard.
    """

    def __init__(self, setup: MeasureSetup) -> None:
        self._slots: Dict[str, BlockTask] = {}
        for task in setup.mission.every_task:
            if task.kind == KIND:
                try:
                    self._slots[task.id] = block_task(task)
                except ValueError:
                    continue
        self._robots: Dict[str, _Robot] = {}
        self._fetching, self._placing = _Account(), _Account()
        self._waiting = 0.0
        self._nearest = math.inf
        self._collisions: Optional[int] = None
        self._bodies: Sequence[Any] = ()

    def subscriptions(self) -> Sequence[Subscription]:
        """Hear builders and the simulation, if anything is built."""
        return (_STATES, _BODIES, _BUMPERS, REMOVALS) if self._slots else ()

    def hear(self, heard: Heard) -> None:
        """Take in one message."""
        fields = heard.fields
        if heard.topic == REMOVALS.topic:
            for robot_id in removed_robots(heard):
                self._robots.pop(robot_id, None)
            return
        if not heard.robot:
            self._bodies = fields["detections"]
            return
        robot = self._robots.setdefault(heard.robot, _Robot())
        if heard.topic.endswith(_BUMPER):
            self._collisions = (self._collisions or 0) + (bool(fields["data"]) and not robot.touches)
            robot.touches = bool(fields["data"])
            return
        here = (fields["pose/x"], fields["pose/y"])
        elapsed = heard.receipt - robot.at
        # Who has placed its block and makes room is at no work.
        if robot.task and robot.activity != "idle" and elapsed <= _PAUSE:
            account = self._placing if robot.has_block else self._fetching
            account.seconds += elapsed
            if robot.activity == "waiting":
                self._waiting += elapsed
        self._drive(robot, here)
        gaps = [math.dist(here, other.spot) for other in self._robots.values() if other is not robot]
        self._nearest = min([self._nearest, *(gap for gap in gaps if not math.isnan(gap))])
        task, activity = fields["task"], fields["activity"]
        if task != robot.task:
            robot.has_block = activity == "placing"
        elif robot.activity == "fetching" and activity != "fetching":
            robot.has_block = True
        elif robot.activity == "placing" and activity != "placing":
            robot.has_block = False
        robot.task, robot.activity, robot.at = task, activity, heard.receipt

    def value(self, record: MissionRecord) -> Optional[Dict[str, Any]]:
        """Give what was built.

        Args:
            record: not needed.

        Returns:
            ``blocks``: how many there are to be; ``placed``: how many lie in their slots in the end; ``mean_error`` and
            ``max_error``: of those, from the middles of their slots, seen from above, and ``max_height_error``: up or
            down [m], None where there are none; ``fetching`` and ``placing``: ``seconds`` and ``metres`` of all robots
            together; ``waiting``: of these, so many seconds;
            ``nearest``: how near the middles of two robots came to each other [m], None for one robot; ``collisions``:
            how often a robot began to touch anything but blocks, as its bumper felt, so that two robots that meet count
            twice, None without bumpers. None where nothing is built.
        """
        if not self._slots:
            return None
        found = errors_of(list(self._slots.values()), self._bodies)
        errors = [each.aside for each in found]
        accounts = {
            name: {"seconds": account.seconds, "metres": account.metres}
            for name, account in (("fetching", self._fetching), ("placing", self._placing))
        }
        return {
            "blocks": len(self._slots),
            "placed": len(errors),
            "mean_error": math.fsum(errors) / len(errors) if errors else None,
            "max_error": max(errors, default=None),
            "max_height_error": max((each.height for each in found), default=None),
            **accounts,
            "waiting": self._waiting,
            "nearest": None if math.isinf(self._nearest) else self._nearest,
            "collisions": self._collisions,
        }

    def _drive(self, robot: _Robot, here: Tuple[float, float]) -> None:
        way = math.dist(robot.spot, here)
        if way >= _STRIDE and robot.task:
            account = self._placing if robot.has_block else self._fetching
            account.metres += way
        if not way < _STRIDE:
            robot.spot = here


class PlacingError(NamedTuple):
    """How far a body lies off its slot.

    Attributes:
        aside: of its middle, seen from above [m].
        height: up or down [m].
    """

    aside: float
    height: float


def errors_of(slots: Sequence[BlockTask], bodies: Sequence[Mapping[str, Any]]) -> List[PlacingError]:
    """Give how far bodies lie off the slots that they lie in; nothing of slots that are not filled rightly.

    Args:
        slots: where bodies belong.
        bodies: as ``/simulation/bodies`` tells of them.
    """
    errors: List[PlacingError] = []
    for slot in slots:
        inside = [_error(slot, body["position"]) for body in bodies if _fits(slot, body)]
        nearest = min(inside, default=PlacingError(math.inf, math.inf))
        if nearest.aside <= WITHIN:
            errors.append(nearest)
    return errors


def _error(slot: BlockTask, position: Mapping[str, float]) -> PlacingError:
    aside = math.dist((position["x"], position["y"]), (slot.x, slot.y))
    return PlacingError(aside, abs(position["z"] - slot.z))


def _fits(slot: BlockTask, body: Mapping[str, Any]) -> bool:
    """Tell whether a body is as long as a slot, lies along it, and lies on its level, wherever that is."""
    if body["held"] or body["kind"] != slot.kind or abs(body["position"]["z"] - slot.z) > _HEIGHT:
        return False
    # A block of one unit lies along x or y, as it is placed from the one side or the other.
    period = math.pi if slot.units > 1 else math.pi / 2.0
    turn = math.remainder(body["yaw"] - slot.yaw, period)
    return abs(turn) <= _TURN
