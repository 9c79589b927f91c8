"""What drivers hear, and whom the world is told to drive otherwise."""

from __future__ import annotations

import math

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.hooks import TeamHeard
from rqt_mrta_py.model import Twist
from rqt_mrta_py.sim.drivers import Drivers
from rqt_mrta_py.sim.robot_models import DIFF_DRIVE
from rqt_mrta_py.sim.simulated_robot import SimulatedRobot


class Team:
    """Drivers of some robots, and what the world was told so far."""

    def __init__(self, size=1):
        self.names = [f"robot{number + 1}" for number in range(size)]
        news = set()
        self.robots = {name: SimulatedRobot(name, DIFF_DRIVE, news) for name in self.names}
        self.drivers = Drivers(self.robots, news)
        self.driven = {}

    def hear(self, *told):
        """Hear commands of (row, receipt, fields)."""
        self.drivers.listener(self.names)[1](TeamHeard(*zip(*told)))

    def ask(self, *times):
        """Give who is to drive otherwise, in order."""
        news = list(self.drivers.commands(np.array(times)))
        self.driven.update(news)
        return news


def ahead(vx):
    return {"linear/x": vx, "linear/y": 0.0, "angular/z": 0.0}


def test_drivers_hear_cmd_vel_in_their_own_namespaces():
    subscription, _ = Team().drivers.listener(["robot1"])
    assert (subscription.topic, subscription.type) == ("cmd_vel", "geometry_msgs/Twist")
    assert set(subscription.fields) == {"linear/x", "linear/y", "angular/z"}


def test_robots_obey_their_newest_commands_for_half_a_second():
    team = Team()
    team.hear((0, 2.0, ahead(0.2)))
    assert team.ask(2.0) == [("robot1", Twist(0.2))]
    team.hear((0, 2.1, ahead(0.3)))
    assert team.ask(2.6) == [("robot1", Twist(0.3))]
    assert team.ask(2.65) == [("robot1", Twist())]
    team.hear((0, 3.0, ahead(0.3)))
    assert team.ask(3.0) == [("robot1", Twist(0.3))]


def test_only_robots_that_drive_otherwise_are_told_and_in_their_order():
    team = Team(3)
    assert team.ask(1.0, 1.0, 1.0) == [("robot1", Twist()), ("robot2", Twist()), ("robot3", Twist())]
    team.hear((2, 1.0, ahead(0.1)), (0, 1.0, ahead(0.2)))
    assert team.ask(1.0, 1.0, 1.0) == [("robot1", Twist(0.2)), ("robot3", Twist(0.1))]
    team.hear((0, 1.3, ahead(0.2)))
    assert team.ask(1.3, 1.3, 1.3) == []
    assert team.ask(1.6, 1.6, 1.6) == [("robot3", Twist())]


def test_each_robot_goes_by_its_own_clock():
    team = Team(2)
    team.hear((0, 1.0, ahead(0.1)), (1, 6.0, ahead(0.2)))
    assert team.ask(1.0, 6.0) == [("robot1", Twist(0.1)), ("robot2", Twist(0.2))]
    assert team.ask(1.55, 6.5) == [("robot1", Twist())]


def test_the_last_of_several_commands_of_one_round_counts():
    team = Team()
    team.hear((0, 1.0, ahead(0.1)), (0, 1.25, ahead(0.3)), (0, 1.5, ahead(0.2)))
    assert team.ask(2.0) == [("robot1", Twist(0.2))]
    assert team.ask(2.05) == [("robot1", Twist())]


def test_rows_are_those_of_the_robots_that_were_named():
    team = Team(3)
    _, hear = team.drivers.listener(["robot3", "robot1"])
    hear(TeamHeard([0, 1], [1.0, 1.0], [ahead(0.3), ahead(0.1)]))
    team.ask(1.0, 1.0, 1.0)
    assert team.driven == {"robot1": Twist(0.1), "robot2": Twist(), "robot3": Twist(0.3)}


HELD = [ahead(speed) for speed in (0.0, 0.1, 0.3, math.nan)]
HAPPENINGS = st.one_of(
    st.tuples(st.just("hear"), st.sampled_from(HELD)),
    st.tuples(st.sampled_from(["stop", "resume"]), st.none()),
    st.tuples(st.just("slow"), st.sampled_from([0.0, 0.5, 1.0])),
    st.tuples(st.just("wait"), st.sampled_from([0.05, 0.1, 0.45, 0.5, 0.55, 3.0])),
)


@given(st.lists(st.tuples(HAPPENINGS, st.booleans()), max_size=30))
def test_a_robot_drives_what_befell_it_last_asks_for(happenings):
    """Commands that are held are the same objects again and again; stops forget them all the same."""
    team = Team()
    robot, now = team.robots["robot1"], 1.0
    speed, heard_at, factor = 0.0, -math.inf, 1.0
    for (what, value), looks in happenings:
        if what == "hear":
            team.hear((0, now, value))
            if not robot.is_stopped:
                speed, heard_at = value["linear/x"], now
        elif what == "stop":
            robot.stop()
            speed = 0.0
        elif what == "resume":
            robot.resume()
        elif what == "slow":
            robot.speed_factor = factor = value
        else:
            now += value
        if looks:
            team.ask(now)
            obeys = now - heard_at <= 0.5 + 1e-9 and not math.isnan(speed)
            assert team.driven["robot1"] == Twist(speed * factor if obeys else 0.0)
