"""What a builder makes of what its teammates say."""

from __future__ import annotations

import math
from typing import Any, Dict, List, Optional

import pytest
from block_construction.building.team_journey import comes_nearer
from block_construction.team.board import TeamBoard
from block_construction.team.lingering import Placement, is_done
from block_construction.team.peers import Dock, Peer, peer_ways
from block_construction.team.removals import REMOVALS
from block_construction.team.timed_way import TimedPoint

from rqt_mrta_py.hooks import Heard
from rqt_mrta_py.model import Pose, Twist

DOCKS = {"block1": Dock(1.0, 0.27, 1.0, 0.39), "block2": Dock(1.93, 1.1, 1.81, 1.1)}


class Ear:
    """What was heard, newest by topic."""

    def __init__(self) -> None:
        self.now = 0.0
        self.pose: Optional[Pose] = None
        self.heard: Dict[str, Heard] = {}

    def newest(self, topic: str) -> Optional[Heard]:
        return self.heard.get(topic)

    def hear(self, topic: str, fields: Dict[str, Any]) -> None:
        self.heard[topic] = Heard(topic, "", self.now, fields)

    def state(self, robot: str, *way: TimedPoint, **fields: Any) -> None:
        told: Dict[str, Any] = {"header/stamp": self.now, "task": "block1", "activity": "driving"}
        told.update({"pose/x": 0.5, "pose/y": 0.5, "goal": [], "placed": [], "missing": []})
        told.update({f"way_{name}": list(values) for name, values in zip(("time", "x", "y"), zip(*way))})
        self.hear(f"/{robot}/builder_state", {"way_time": [], "way_x": [], "way_y": [], **told, **fields})


def a_board(*others: str) -> TeamBoard:
    return TeamBoard("robot1", ("robot1", *others), 0.03, lambda: DOCKS)


def test_ways_of_teammates_lead_beyond_the_docks_where_they_work() -> None:
    board, ear = a_board("robot2"), Ear()
    way = (TimedPoint(1.0, 0.5, 0.5), TimedPoint(20.0, 1.0, 0.27))
    ear.state("robot2", *way)
    (peer,) = board.peers(ear)
    assert (peer.way, peer.dock, peer.target, peer.idle) == (way, DOCKS["block1"], DOCKS["block1"], False)
    assert len(peer_ways(board.peers(ear))) == 2
    ear.state("robot2", way[1], activity="waiting", goal=[1.93, 1.1, 1.81, 1.1])
    (peer,) = board.peers(ear)
    assert (peer.dock, peer.goal) == (None, DOCKS["block2"])


def test_the_silent_stand_where_they_last_said_to_be_until_they_are_removed() -> None:
    board, ear = a_board("robot2"), Ear()
    ear.state("robot2", TimedPoint(0.0, 0.5, 0.5), TimedPoint(50.0, 2.0, 0.5), **{"pose/x": 0.6})
    ear.now = 5.0
    assert board.peers(ear)[0].way[-1].x == 2.0
    ear.now = 5.1
    (peer,) = board.peers(ear)
    assert (peer.way, peer.idle) == ((TimedPoint(0.0, 0.6, 0.5),), True)
    ear.now = 500.0
    assert board.peers(ear) == (peer,)
    ear.hear(REMOVALS.topic, {"data": "robot2"})
    assert board.peers(ear) == ()
    # Who speaks again is back.
    ear.now = 600.0
    ear.state("robot2", TimedPoint(600.0, 0.3, 0.3))
    assert len(board.peers(ear)) == 1


def test_two_who_are_removed_between_two_looks_are_both_gone() -> None:
    board, ear = a_board("robot2", "robot3", "robot4"), Ear()
    for robot in ("robot2", "robot3", "robot4"):
        ear.state(robot, TimedPoint(0.0, 0.5, 0.5))
    assert len(board.peers(ear)) == 3
    ear.hear(REMOVALS.topic, {"data": "robot2"})
    ear.hear(REMOVALS.topic, {"data": "robot2 robot3"})
    assert [peer.id for peer in board.peers(ear)] == ["robot4"]


def test_who_came_back_and_is_removed_again_is_gone_again() -> None:
    board, ear = a_board("robot2"), Ear()
    ear.hear(REMOVALS.topic, {"data": "robot2"})
    assert board.peers(ear) == ()
    ear.now = 10.0
    ear.state("robot2", TimedPoint(10.0, 0.3, 0.3))
    assert len(board.peers(ear)) == 1
    ear.now = 11.0
    ear.hear(REMOVALS.topic, {"data": "robot2"})
    assert board.peers(ear) == ()


def test_who_is_seen_off_its_way_stands_where_it_is_seen():
    """It reserved a way to x = 2 m at 0.03 m/s, and stops at 10 s, at x = 0.8 m; 3.1 s later that is seen."""
    board, ear = a_board("robot2"), Ear()
    way = (TimedPoint(0.0, 0.5, 0.5), TimedPoint(50.0, 2.0, 0.5))
    ear.now = 10.0
    ear.state("robot2", *way)
    for now in (10.0, 12.9):
        ear.now = now
        ear.hear("/robot2/pose", {"pose/position/x": 0.8, "pose/position/y": 0.5})
        assert board.peers(ear)[0].way == way
    ear.now = 13.1
    ear.hear("/robot2/pose", {"pose/position/x": 0.8, "pose/position/y": 0.5})
    (peer,) = board.peers(ear)
    assert (peer.way, peer.idle) == ((TimedPoint(10.0, 0.8, 0.5),), True)
    assert board.places(ear) == [(0.8, 0.5)]
    # It goes on: what it says holds again.
    ear.now = 14.0
    again = (TimedPoint(14.0, 0.8, 0.5), TimedPoint(54.0, 2.0, 0.5))
    ear.state("robot2", *again)
    assert board.peers(ear)[0].way == again


def test_who_works_at_a_dock_is_off_its_way_and_not_astray():
    board, ear = a_board("robot2"), Ear()
    ear.state("robot2", TimedPoint(0.0, 1.0, 0.27), activity="placing")
    ear.now = 1.0
    ear.hear("/robot2/pose", {"pose/position/x": 1.0, "pose/position/y": 0.38})
    assert board.peers(ear)[0].dock == DOCKS["block1"]


@pytest.mark.parametrize(
    ("other", "twist", "nearer"),
    [
        ((1.3, 1.0), Twist(vx=0.03), False),  # Heading along y: it drives up, and the other is beside it.
        ((1.3, 1.0), Twist(vy=-0.03), True),
        ((1.3, 1.0), Twist(vy=0.03), False),
        ((1.3, 1.0), Twist(wz=0.08), False),
        ((1.4, 1.0), Twist(vy=-0.03), False),  # 0.4 m apart is far enough.
        ((1.2, 1.2), Twist(vx=0.03), True),
    ],
)
def test_robot_does_not_drive_towards_who_is_near(other, twist, nearer):
    assert comes_nearer(Pose(1.0, 1.0, math.pi / 2), twist, [(0.1, 0.1), other], 0.37) is nearer


def test_who_has_not_spoken_is_where_its_localiser_says() -> None:
    board, ear = a_board("robot2", "robot3"), Ear()
    ear.hear("/robot3/pose", {"pose/position/x": 1.9, "pose/position/y": 1.1})
    (peer,) = board.peers(ear)
    assert (peer.id, peer.way[0][1:], peer.idle) == ("robot3", (1.9, 1.1), True)
    # It is noisy, and still it stands.
    ear.now = 1.0
    ear.hear("/robot3/pose", {"pose/position/x": 1.902, "pose/position/y": 1.099})
    assert board.peers(ear) == (peer,)


def test_blocks_found_missing_after_they_were_placed_are_not_placed() -> None:
    board, ear = a_board("robot2", "robot3"), Ear()
    ear.state("robot2", placed=[1, 2])
    assert board.placed(ear) == {1, 2}
    ear.now = 1.0
    ear.state("robot3", missing=[2])
    assert board.placed(ear) == {1}
    ear.now = 2.0
    ear.state("robot2", placed=[1, 2])
    assert board.placed(ear) == {1, 2}


TASKS = {
    "block1": Placement(1, (), DOCKS["block1"]),
    "block2": Placement(2, (), DOCKS["block2"]),
    "block3": Placement(3, (1, 2), DOCKS["block1"]),
}


def done(task: str, placed: List[int], *peers: Peer, is_aside: bool = True) -> bool:
    return is_done(("robot1", task, (1.0, 0.27)), TASKS, set(placed), peers, is_aside=is_aside)


@pytest.mark.parametrize("lingers", [True, False])
def test_a_task_is_done_once_there_is_more_to_do_or_a_block_waits_for_it(lingers: bool) -> None:
    far = Peer("robot2", (TimedPoint(0.0, 1.93, 1.1),), task="block2", lingers=lingers)
    # Block 3 waits for block 2 too, on which robot2 is still at work; if it only lingers there, block 2 is to be done.
    assert done("block1", [1], far) is False
    assert done("block1", [1, 2], far)
    assert done("block3", [1, 2, 3], far)


def test_who_may_be_left_without_a_task_goes_aside_before_it_is_done() -> None:
    """Once its task is done a robot stands; one that stands at the dock of the last block keeps others from it."""
    at_work = Peer("robot2", (TimedPoint(0.0, 1.93, 1.1),), task="block2")
    idle = at_work._replace(task="", idle=True)
    # Blocks 1 and 2 are placed: for block 3 there is nobody else, or there are two.
    assert done("block1", [1, 2], at_work, is_aside=False)
    assert not done("block1", [1, 2], idle, is_aside=False)
    assert done("block1", [1, 2], idle)
    # Nothing is left to keep anybody from.
    assert done("block3", [1, 2, 3], idle, is_aside=False)


def test_of_two_who_linger_the_nearer_is_done() -> None:
    near = Peer("robot2", (TimedPoint(0.0, 1.8, 1.1),), task="block3", lingers=True)
    assert not done("block1", [1, 3], near)
    assert done("block1", [1, 3], near._replace(way=(TimedPoint(0.0, 0.3, 1.9),)))
