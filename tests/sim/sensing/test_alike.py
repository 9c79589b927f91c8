from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.model import Pose, RobotSetup, SensorSetup
from rqt_mrta_py.sim.sensing.alike import alike_sensors

SETUPS = [
    SensorSetup(kind, topic, rate, parameters)
    for kind in ("localiser", "odometry")
    for topic in ("a", "b")
    for rate in (5.0, 10.0)
    for parameters in ({}, {"noise": 0.1}, {"noise": 0.1, "bias": [1, 2]}, {"bias": [1, 2], "noise": 0.1})
]
TEAMS = st.lists(st.lists(st.sampled_from(SETUPS), max_size=4).map(tuple), max_size=5)


def robots(team):
    return [RobotSetup(f"robot{number}", "diff_drive", Pose(0.0, 0.0), setups) for number, setups in enumerate(team)]


def carried(groups, place):
    """List what one robot carries, in the order of groups."""
    return [group.setup for group in groups if place in group.robots]


@given(TEAMS)
def test_alike_sensors_are_all_there_in_groups_of_equal_setups_with_each_robot_once(team):
    groups = alike_sensors(robots(team))
    for group in groups:
        assert list(group.robots) == sorted(set(group.robots))
        assert all(group.setup in team[place] for place in group.robots)
    for place, setups in enumerate(team):
        assert sorted(map(repr, map(canonical, carried(groups, place)))) == sorted(map(repr, map(canonical, setups)))


@given(TEAMS)
def test_order_of_a_robots_sensors_does_not_depend_on_the_other_robots(team):
    groups = alike_sensors(robots(team))
    for place, setups in enumerate(team):
        assert carried(groups, place) == carried(alike_sensors(robots([setups])), 0)


def test_sensors_that_are_set_up_alike_by_several_robots_make_one_group():
    one = SensorSetup("localiser", "pose", 10.0, {"a": 1, "b": 2})
    same = SensorSetup("localiser", "pose", 10.0, {"b": 2, "a": 1})
    (group,) = alike_sensors(robots([(one,), (), (same,)]))
    assert list(group.robots) == [0, 2]


def canonical(setup):
    return setup.kind, setup.topic, setup.rate, sorted(setup.parameters.items())
