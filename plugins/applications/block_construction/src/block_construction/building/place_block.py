"""The behaviour ``place_block``: fetches a block and puts it into its slot."""

from __future__ import annotations

import math
from contextlib import suppress
from typing import Any, Dict, List, Mapping, NamedTuple, Optional, Sequence, Tuple

from block_construction.building.errand import Errand
from block_construction.building.eyes import DETECTIONS, Eyes
from block_construction.building.gripping import CENTRED, Grip
from block_construction.building.helpers import Helpers
from block_construction.building.performer import Felt
from block_construction.building.pose_filter import PoseFilter
from block_construction.building.procedures import TRAVEL_SPEED, assembly
from block_construction.building.routes import way_length
from block_construction.building.seams import Board, Solo
from block_construction.building.site_map import SiteMap
from block_construction.building.slot import KIND, BlockTask, block_task
from block_construction.building.state import BuilderState, Teller
from block_construction.building.team_journey import dock_before, team_trip
from block_construction.building.teamwork import Team
from block_construction.diagram.block_set import BODY_HEIGHT, PITCH
from block_construction.team.board import TeamBoard
from block_construction.team.lingering import Placement
from block_construction.team.peers import Dock
from block_construction.team.traffic import Post, Traffic
from rqt_mrta_py.hooks import (
    ArmModel,
    BehaviourSetup,
    BehaviourStep,
    Command,
    Heard,
    Outgoing,
    Perception,
    Subscription,
)
from rqt_mrta_py.model import Pose, Progress, Task, Twist

__all__ = ["PLANNED_SPEED", "PlaceBlock", "place_block", "posts_of"]

ARM_STATE = Subscription("arm/state", "std_msgs/Float64", ("data",))
MAGNET_STATE = Subscription("magnet/state", "std_msgs/String", ("data",))
ODOMETRY = Subscription(
    "odom",
    "nav_msgs/Odometry",
    (
        "pose/pose/position/x",
        "pose/pose/position/y",
        "pose/pose/orientation/z",
        "pose/pose/orientation/w",
    ),
)

_STALE = 2.0
PLANNED_SPEED = 0.97 * TRAVEL_SPEED
"""Ways are planned a little slower than the robot drives, so that it keeps up [m/s]."""
_LYING = 0.06
"""What is kept clear around the middle of a block that lies ready across a corner: robots come by before it, and at
its ends walls leave them no room [m]."""
_COST_HOLDS = 2.0
"""What a task costs among teammates is not reckoned anew before so long [s]."""
_REPEAT = 0.5
"""What arm and magnet were told is told again after so long, for messages may be lost [s]."""
_SAME_SPEED = 2e-4
_SAME_TURN = 1e-3
"""Velocities that differ by less are not worth a command [m/s, rad/s]."""
_SAME_ANGLE = 1e-4
_WARN = 4  # rosgraph_msgs/Log.WARN
_NO_TWIST = Twist()
_STILL = (Command("base", _NO_TWIST),)


class _Told(NamedTuple):
    """What arm or magnet was told last, and when [s]."""

    value: float
    at: float


class PlaceBlock:
    """Carries out tasks of kind ``place_block`` for one robot with an arm and a magnet.

    Arm and magnet are commanded by messages of its own, and not as commands of each tick: they shall stay as they are
    when a task ends or is let go, the block held and the arm up.

    Args:
        setup: whose behaviour.
        board: what others have said.

    Raises:
        ValueError: the robot has no arm.
    """

    def __init__(self, setup: BehaviourSetup, board: Optional[Board] = None) -> None:
        arm = setup.model.arm
        if arm is None:
            raise ValueError(f"robot model {setup.model.name}: tasks of kind {KIND} need a robot with an arm")
        self._setup = setup
        self._arm: ArmModel = arm
        alone = len(setup.team) < 2
        self._board = board or (Solo() if alone else TeamBoard(setup.robot_id, setup.team, PLANNED_SPEED, self.docks))
        self._slots: Dict[str, Tuple[Task, BlockTask]] = {}
        self._traffic: Dict[Tuple[Tuple[float, ...], float], Traffic] = {}
        self._site = SiteMap()
        self._numbers: Dict[int, str] = {}
        self._filter = PoseFilter()
        self._odometry: Optional[Heard] = None
        self._counted: Optional[Pose] = None
        self._eyes = Eyes()
        self._state = BuilderState()
        self._teller = Teller()
        self._errand: Optional[Errand] = None
        self._holding: Tuple[str, int, Optional[Grip]] = ("", 0, None)
        self._before: Optional[Pose] = None
        self._commands: Sequence[Command] = _STILL
        self._twist = Twist()
        self._told: Dict[str, _Told] = {}
        self._placements: Dict[str, Placement] = {}
        self._costs: Dict[str, Tuple[float, float]] = {}
        for task in setup.tasks:
            if task.kind == KIND:
                # What makes no sense is told when it is asked whether the task is applicable.
                with suppress(ValueError):
                    self._slot(task)

    def subscriptions(self) -> Sequence[Subscription]:
        """Hear arm, magnet, odometry and detector, and what others say."""
        return (ARM_STATE, MAGNET_STATE, ODOMETRY, DETECTIONS, *self._board.subscriptions())

    def applicable(self, task: Task, perception: Perception) -> bool:
        """Tell whether the robot knows where it is, and arm and magnet are heard.

        Raises:
            ValueError: the task's data make no sense, or the arm does not reach its level; says why.
        """
        self._slot(task)
        return perception.pose is not None and all(
            _is_fresh(perception, topic) for topic in (ARM_STATE.topic, MAGNET_STATE.topic)
        )

    def cost(self, task: Task, perception: Perception) -> Optional[float]:
        """Give the way to the best supply place and from there to the slot [m]; None if there is none."""
        pose, slot = perception.pose, self._slot(task)
        if pose is None:
            return None
        errand = self._errand
        if errand is not None and errand.slot is slot and self._state.task == task.id:
            return errand.left(pose)
        traffic, covered = self._traffic_of(slot), self._site.covered
        if self._grip_for(slot, _held(perception)) is not None:
            return way_length(traffic, pose, slot, covered, None)
        if isinstance(self._board, TeamBoard):
            return self._cost_in_team(task.id, slot, perception, pose)
        lengths = [way_length(traffic, pose, slot, covered, fetch) for fetch in slot.supply]
        return min((length for length in lengths if length is not None), default=None)

    def start(self, task: Task, perception: Perception) -> None:
        """Set out for the supply, or with what the robot holds already for the slot."""
        self._filter.resume(perception.now)
        self._errand = None
        self._commands, self._twist = _STILL, Twist()
        state = self._state
        state.task, state.activity, state.action, state.way = task.id, "idle", "", ()

    def step(self, task: Task, perception: Perception) -> BehaviourStep:
        """Carry out one control tick; stand still while the robot does not know where it is."""
        felt = self._feel(perception)
        if felt is None:
            self._twist, self._commands = Twist(), _STILL
            return BehaviourStep(_STILL)
        now, site, state = perception.now, self._site, self._state
        site.hear(self._board.placed(perception))
        seen = self._eyes.look(perception, felt.pose, self._counted)
        messages: List[Outgoing] = []
        if seen is not None:
            messages.extend(self._announce(number, now) for number in site.look(seen))
        errand = self._errand
        if errand is None:
            slot = self._slot(task)
            helpers = Helpers(self._arm, self._traffic_of(slot), site, self._team(slot))
            grip = self._grip_for(slot, felt.held)
            errand = self._errand = Errand(helpers, slot, state, felt, grip=grip, before=self._before)
        move = errand.step(perception, felt, seen)
        self._before = errand.before or self._before
        self._holding = (felt.held, errand.slot.units, errand.grip) if felt.held else ("", 0, None)
        if move.progress is not Progress.RUNNING:
            state.task, state.activity, state.action, state.way, state.goal = "", "idle", "", (), ()
            self._errand = None
        state.placed, state.missing = frozenset(site.placed), frozenset(site.missing)
        self._tell("arm", move.arm, _SAME_ANGLE, now, messages)
        self._tell("magnet", 1.0 if move.magnet else 0.0, 0.5, now, messages)
        messages.extend(self._log(f"task={task.id} {line}", now) for line in move.logs)
        messages.extend(self._teller.tell(state, now, felt.pose))
        return BehaviourStep(self._drive(move.twist), move.progress, move.detail, messages)

    def _feel(self, perception: Perception) -> Optional[Felt]:
        """Put together what the robot knows of itself; None if something is missing."""
        odometry = perception.newest(ODOMETRY.topic)
        if odometry is not self._odometry:
            self._odometry, self._counted = odometry, _counted(odometry)
        pose = self._filter.step(perception.now, perception.pose, self._counted, self._twist)
        angle, held = perception.newest(ARM_STATE.topic), perception.newest(MAGNET_STATE.topic)
        if pose is None or angle is None or held is None:
            return None
        doubts = self._filter.doubt, self._filter.turn_doubt
        return Felt(perception.now, pose, *doubts, float(angle.fields["data"]), str(held.fields["data"]))

    def _slot(self, task: Task) -> BlockTask:
        """Read a task, once; raises ValueError as of ``applicable``."""
        known = self._slots.get(task.id)
        if known is None or known[0] is not task:
            slot = block_task(task)
            for height in (BODY_HEIGHT / 2.0, slot.z):
                assembly(self._arm, height, CENTRED.ahead)
            known = self._slots[task.id] = (task, slot)
            self._site.slots[known[1].block] = known[1]
            self._numbers[known[1].block] = task.id
        return known[1]

    def _traffic_of(self, slot: BlockTask) -> Traffic:
        """Give who knows ways around the structure that a slot belongs to."""
        key = (slot.site, slot.arena)
        if key not in self._traffic:
            places = {fetch for _, other in self._slots.values() for fetch in other.supply}
            posts = posts_of([(fetch.x, fetch.y) for fetch in places])
            radius = self._setup.model.radius
            closed = isinstance(self._board, TeamBoard)
            self._traffic[key] = Traffic(
                slot.arena, slot.site, radius, PLANNED_SPEED, PITCH, posts=posts, closed=closed
            )
        return self._traffic[key]

    def _team(self, slot: BlockTask) -> Optional[Team]:
        if not isinstance(self._board, TeamBoard):
            return None
        if len(self._placements) != len(self._slots):
            numbers = {name: each.block for name, (_, each) in self._slots.items()}
            self._placements = {
                name: Placement(
                    each.block,
                    tuple([numbers[before] for before in task.predecessors if before in numbers]),
                    dock_before(each.facing),
                )
                for name, (task, each) in self._slots.items()
            }
        return Team(self._setup.robot_id, self._board, self._traffic_of(slot), self._placements)

    def docks(self) -> Mapping[str, Dock]:
        """Give from where blocks are placed, by the tasks' ids."""
        return {name: placement.dock for name, placement in self._placements.items()}

    def _cost_in_team(self, name: str, slot: BlockTask, perception: Perception, pose: Pose) -> Optional[float]:
        known = self._costs.get(name)
        if known is not None and 0.0 <= perception.now - known[0] < _COST_HOLDS:
            return known[1]
        team = self._team(slot)
        if team is None:
            return None
        trip, _ = team_trip(team.board, team.traffic, slot, (perception, pose), self._site.covered)
        cost = math.inf if trip is None else trip.cost
        self._costs[name] = (perception.now, cost)
        return cost

    def _grip_for(self, slot: BlockTask, held: str) -> Optional[Grip]:
        """Give how the robot holds a block that belongs into the slot; None if it holds none."""
        name, units, grip = self._holding
        return grip if held and held == name and units == slot.units else None

    def _drive(self, twist: Twist) -> Sequence[Command]:
        """Give the commands to the base; the same again where little has changed."""
        old = self._twist
        if (
            twist == _NO_TWIST
            or abs(twist.vx - old.vx) > _SAME_SPEED
            or abs(twist.vy - old.vy) > _SAME_SPEED
            or abs(twist.wz - old.wz) > _SAME_TURN
        ):
            self._commands = (Command("base", twist),) if twist != old else self._commands
            self._twist = twist
        return self._commands

    def _tell(self, actuator: str, value: float, same: float, now: float, messages: List[Outgoing]) -> None:
        told = self._told.get(actuator)
        if told is not None and abs(told.value - value) < same and now - told.at < _REPEAT:
            return
        self._told[actuator] = _Told(value, now)
        messages.append(Outgoing(f"{actuator}/command", "std_msgs/Float64", {"data": value}))

    def _announce(self, number: int, now: float) -> Outgoing:
        """Let the task of a block that is gone appear anew, as an operator would."""
        detail = f"block {number} is not in its slot any more"
        fields = {
            "header": {"stamp": now},
            "task_id": self._numbers[number],
            "progress": Progress.APPEARED.code,
            "detail": detail,
        }
        return Outgoing("/mrta/task_progress", "rqt_mrta_py/TaskProgress", fields)

    def _log(self, text: str, now: float) -> Outgoing:
        robot = self._setup.robot_id
        line = f"robot={robot} {text}"
        fields = {"header": {"stamp": now}, "level": _WARN, "name": f"/{robot}/agent", "msg": line}
        return Outgoing("/rosout", "rosgraph_msgs/Log", fields)


def place_block(setup: BehaviourSetup) -> PlaceBlock:
    """Make the behaviour for one robot."""
    return PlaceBlock(setup)


def posts_of(places: Sequence[Tuple[float, float]]) -> Tuple[Post, ...]:
    """Give what is driven around where blocks lie ready [m]."""
    return tuple(sorted({Post(x, y, _LYING) for x, y in places}))


def _counted(heard: Optional[Heard]) -> Optional[Pose]:
    if heard is None:
        return None
    x, y, qz, qw = map(heard.fields.__getitem__, ODOMETRY.fields)
    return Pose(x, y, 2.0 * math.atan2(qz, qw))


def _held(perception: Perception) -> str:
    heard = perception.newest(MAGNET_STATE.topic)
    return "" if heard is None else str(heard.fields["data"])


def _is_fresh(perception: Perception, topic: str) -> bool:
    heard: Optional[Any] = perception.newest(topic)
    return heard is not None and perception.now - heard.receipt <= _STALE
