"""Scenarios of two robots in a world that stands still, for tests of what befalls them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from rqt_mrta_py.hooks import TeamHeard
from rqt_mrta_py.model import Arena, Pose, RobotSetup, ScenarioEventKind, ScenarioSpec, SensorSetup
from rqt_mrta_py.sim import Simulation
from rqt_mrta_py.sim.plugin import (
    mrta_register_links,
    mrta_register_robot_models,
    mrta_register_sensors,
    mrta_register_team_sensors,
    mrta_register_worlds,
)
from tests.sim.doubles import StillWorld
from tests.sim.expanding import by_robot

STOPS, RETURNS = ScenarioEventKind.ROBOT_STOPS, ScenarioEventKind.ROBOT_RETURNS
RATE = 20
SENSORS = (SensorSetup("odometry", "odom", 10.0), SensorSetup("localiser", "pose", 10.0))


def scenario(*events, **changes):
    robots = tuple(RobotSetup(f"robot{i}", "diff_drive", Pose(float(i), 0.0), SENSORS) for i in (1, 2))
    spec = ScenarioSpec(Arena(-5.0, -5.0, 5.0, 5.0), (), robots, tuple(events), world="still", control_rate=RATE)
    return replace(spec, **changes)


def simulation(spec, world=None, **changes):
    known = {
        "models": mrta_register_robot_models(),
        "sensors": mrta_register_sensors(),
        "team_sensors": mrta_register_team_sensors(),
        "worlds": {"still": lambda: StillWorld() if world is None else world, **mrta_register_worlds()},
        "links": mrta_register_links(),
        "link_random": lambda sender, receiver: np.random.default_rng([*f"{sender} {receiver}".encode()]),
        "generators": {robot.id: np.random.default_rng(index) for index, robot in enumerate(spec.robots)},
    }
    return Simulation(scenario=spec, **{**known, **changes})


def play(simulated, ticks):
    """Give for each tick the events that happened and who spoke."""
    played = []
    for tick in range(ticks):
        now = tick / RATE + 1
        happened = simulated.begin_tick(tick, now)
        speakers = list(by_robot(simulated.sense(tick, now)))
        simulated.act(now)
        simulated.step()
        played.append((list(happened), speakers))
    return played


def tell(simulated, robot, receipt, vx, wz=0.0):
    """Let a robot hear a command."""
    _, hear = simulated.drivers.listener([robot])
    hear(TeamHeard([0], [receipt], [{"linear/x": vx, "linear/y": 0.0, "angular/z": wz}]))
