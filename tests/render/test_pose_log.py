from __future__ import annotations

import math

import pytest

from rqt_mrta_py.render.pose_log import PoseLog


def fed(log: PoseLog, count: int, every: float) -> PoseLog:
    for step in range(count):
        time = step * every
        if time >= log.due:
            log.add(time, time, 2.0 * time, (0.0, 0.0, math.sin(time / 2.0), math.cos(time / 2.0)))
    return log


def test_a_pose_a_period_is_kept_with_its_heading() -> None:
    track = fed(PoseLog(1.0, 100), 21, 0.25).track("robot1", 0.3)
    assert (track.robot, track.radius, track.period) == ("robot1", 0.3, 1.0)
    assert track.times == (0.0, 1.0, 2.0, 3.0, 4.0, 5.0)
    assert track.ys == (0.0, 2.0, 4.0, 6.0, 8.0, 10.0)
    assert track.yaws[:3] == pytest.approx((0.0, 1.0, 2.0))


def test_too_many_poses_are_halved_and_come_half_as_often_from_then_on() -> None:
    track = fed(PoseLog(1.0, 8), 31, 0.5).track("robot1", 0.3)
    assert track.period == 2.0
    assert track.times == (0.0, 2.0, 4.0, 6.0, 8.0, 10.0, 12.0, 14.0)
