"""Where all bodies are, as people are told."""

from __future__ import annotations

import pytest

from rqt_mrta_py.hooks import TeamHeard
from rqt_mrta_py.model import LooseBody, Pose, RobotSetup
from tests.sim.scenarios import RATE, scenario, simulation

BODIES = (
    LooseBody("tin", Pose(2.0, 1.0), (0.1, 0.1, 0.1), kind="metal"),
    LooseBody("cup", Pose(0.3, 0.0), (0.1, 0.1, 0.2), kind="paper"),
)


def labels(ticks, **changes):
    """Give the labels by tick of a scenario in which nothing is commanded."""
    robots = (RobotSetup("r1", "carrier", Pose(0.0, 0.0)),)
    simulated = simulation(scenario(robots=robots, world="planar", **changes))
    try:
        return {tick: list(simulated.labels(tick, 1.0 + tick / RATE)) for tick in range(ticks)}
    finally:
        simulated.close()


def test_people_are_told_twice_a_second_where_bodies_are():
    told = labels(31, bodies=BODIES)
    assert [tick for tick, said in told.items() if said] == [0, 10, 20, 30]
    (label,) = told[10]
    assert (label.topic, label.type) == ("/simulation/bodies", "rqt_mrta_py/Detections")
    assert label.fields["header"] == {"stamp": 1.5, "frame_id": "map"}
    cup, tin = label.fields["detections"]
    assert (cup["id"], cup["kind"], cup["held"]) == ("cup", "paper", False)
    assert cup["position"] == pytest.approx({"x": 0.3, "y": 0.0, "z": 0.1})
    assert (tin["id"], tin["kind"], tin["held"]) == ("tin", "metal", False)
    assert tin["position"] == pytest.approx({"x": 2.0, "y": 1.0, "z": 0.05})


def test_people_are_told_who_is_held():
    robots = (RobotSetup("r1", "carrier", Pose(0.0, 0.0)),)
    simulated = simulation(scenario(robots=robots, world="planar", bodies=BODIES))
    try:
        simulated.grippers.listener(["r1"])[1](TeamHeard([0], [1.0], [{"data": 1.0}]))
        simulated.act(1.0)
        (label,) = simulated.labels(0, 1.0)
        assert {each["id"]: each["held"] for each in label.fields["detections"]} == {"cup": True, "tin": False}
    finally:
        simulated.close()


def test_scenario_without_bodies_tells_nothing_of_any():
    assert not any(labels(21).values())
