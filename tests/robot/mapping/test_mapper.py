"""From what a robot hears to its map; the arena is 4 m x 4 m, in cells of 0.05 m."""

from __future__ import annotations

import math
from typing import Any, Dict, List, Sequence

import numpy as np
import pytest

from rqt_mrta_py.hooks import Heard
from rqt_mrta_py.model import Arena
from rqt_mrta_py.robot import Mapper

ARENA = Arena(0.0, 0.0, 4.0, 4.0)


class Ears:
    """Tells a mapper of poses and scans."""

    def __init__(self) -> None:
        self.mapper = Mapper(ARENA)
        self._hear = {wish.topic: (wish, hear) for wish, hear in self.mapper.listeners()}

    def pose(self, stamp: float, x: float, y: float, yaw: float = 0.0) -> None:
        turn = {"pose/orientation/x": 0.0, "pose/orientation/y": 0.0}
        turn.update({"pose/orientation/z": math.sin(yaw / 2), "pose/orientation/w": math.cos(yaw / 2)})
        self._tell("pose", {"header/stamp": stamp, "pose/position/x": x, "pose/position/y": y, **turn})

    def scan(self, stamp: float, *ranges: float, first: float = 0.0, increment: float = math.pi / 2) -> None:
        fields = {"angle_min": first, "angle_increment": increment, "range_min": 0.05, "range_max": 3.5}
        self._tell("scan", {"header/stamp": stamp, **fields, "ranges": list(ranges)})

    def occupied(self) -> List[Sequence[int]]:
        """Give row and column of each occupied cell."""
        return np.argwhere(self.mapper.map.occupied).tolist()

    def _tell(self, topic: str, fields: Dict[str, Any]) -> None:
        wish, hear = self._hear[topic]
        hear(Heard(f"/robot1/{topic}", wish.type, 99.0, {path: fields[path] for path in wish.fields}))


@pytest.mark.parametrize("pose_first", [True, False])
def test_a_scan_is_put_where_the_robot_was_when_it_was_made(pose_first: bool) -> None:
    """1.01 m ahead of x = 1.02 m and to the left of y = 1.02 m: cells 40 and 20."""
    ears = Ears()
    if pose_first:
        ears.pose(1.0, 1.02, 1.02)
    ears.scan(1.0, 1.01, 1.01)
    if not pose_first:
        ears.pose(1.0, 1.02, 1.02)
    assert ears.occupied() == [[20, 40], [40, 20]]
    assert ears.mapper.now == 1.0


def test_between_two_poses_the_robot_has_moved_evenly() -> None:
    """At 1.05 s it is half way from 1.0 m to 1.1 m and has turned by half of 180 degrees, across the cut at pi."""
    ears = Ears()
    ears.pose(1.0, 1.0, 2.02, yaw=math.pi / 2)
    ears.scan(1.05, 0.52)
    assert ears.occupied() == []
    ears.pose(1.1, 1.1, 2.02, yaw=-math.pi / 2 - 1e-9)
    assert ears.occupied() == [[40, 10]]


def test_scans_that_cannot_be_placed_are_left_out() -> None:
    """One from before any pose, one from within a gap of more than half a second."""
    ears = Ears()
    ears.pose(1.0, 1.02, 1.02)
    ears.scan(0.9, 1.01)
    ears.scan(1.3, 1.01)
    ears.pose(1.6, 1.02, 1.02)
    assert ears.occupied() == []


def test_of_scans_that_follow_quickly_one_in_a_fifth_of_a_second_counts() -> None:
    """Three in 0.2 s are two looks: log-odds of 0.85 each."""
    ears = Ears()
    for stamp in (1.0, 1.1, 1.2):
        ears.pose(stamp, 1.02, 1.02)
        ears.scan(stamp, 1.01)
    assert ears.mapper.map.odds[20, 40] == pytest.approx(1.7)


@pytest.mark.parametrize("told", [math.nan, -math.inf, 0.01, 3.6])
def test_a_range_that_says_nothing_is_passed_over(told: float) -> None:
    ears = Ears()
    ears.pose(1.0, 1.02, 1.02)
    ears.scan(1.0, told)
    assert not ears.mapper.map.odds.any()


def test_infinity_says_that_the_way_is_free_up_to_3_m() -> None:
    """From x = 0.52 m to 3.52 m, cells 10 to 70."""
    ears = Ears()
    ears.pose(1.0, 0.52, 1.02)
    ears.scan(1.0, math.inf)
    assert np.flatnonzero(ears.mapper.map.odds[20]).tolist() == list(range(10, 71))


@pytest.mark.parametrize("bad", [{"x": math.nan}, {"yaw": math.inf}])
def test_a_pose_that_is_not_finite_is_not_believed(bad: Dict[str, float]) -> None:
    ears = Ears()
    with np.errstate(invalid="ignore"):
        fields = {"pose/position/x": bad.get("x", 1.0), "pose/orientation/z": bad.get("yaw", 0.0)}
        wish, hear = ears.mapper.listeners()[0]
        hear(Heard("/robot1/pose", wish.type, 1.0, {path: fields.get(path, 1.0) for path in wish.fields}))
    assert ears.mapper.now == 0.0


def test_rays_that_are_not_finite_tell_nothing() -> None:
    ears = Ears()
    ears.pose(1.0, 1.02, 1.02)
    ears.scan(1.0, 1.0, increment=math.nan)
    assert not ears.mapper.map.odds.any()
