"""What keeps a scenario from being simulated, told at once and without building anything."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Callable, Dict, List

import numpy as np
import pytest

from rqt_mrta_py.errors import MissingDependencyError, SimError
from rqt_mrta_py.model import (
    Arena,
    LooseBody,
    Obstacle,
    Pose,
    RadioSetup,
    RobotSetup,
    ScenarioSpec,
    SensorSetup,
)
from rqt_mrta_py.sim import Simulation, plugin, scenario_problems

SCAN = SensorSetup("range_finder", "scan", 10.0, {"rays": 8})
SOUND = ScenarioSpec(
    arena=Arena(-3.0, -3.0, 3.0, 3.0),
    obstacles=(Obstacle("crate", Pose(2.0, 2.0), (1.0, 1.0, 0.5)),),
    robots=(
        RobotSetup("r1", "diff_drive", Pose(0.0, 0.0), (SCAN,)),
        RobotSetup("r2", "diff_drive", Pose(1.0, 0.0), (SCAN,)),
    ),
    world="planar",
)
CAN = LooseBody("can", Pose(-1.0, -1.0), (0.1, 0.1, 0.1))


class BareWorld:
    """Robots drive in it, and there is nothing else."""

    capabilities = frozenset({"drive:differential", "ranges"})

    def close(self) -> None:
        """Do nothing."""


PARTS: Dict[str, Any] = {
    "models": plugin.mrta_register_robot_models(),
    "sensors": plugin.mrta_register_sensors(),
    "team_sensors": plugin.mrta_register_team_sensors(),
    "worlds": {"bare": BareWorld, **plugin.mrta_register_worlds()},
    "links": plugin.mrta_register_links(),
    "link_random": lambda sender, receiver: np.random.default_rng(1),
}


def told(scenario: ScenarioSpec, **parts: Any) -> List[str]:
    generators = {robot.id: np.random.default_rng(1) for robot in scenario.robots}
    return list(scenario_problems(scenario, generators=generators, **{**PARTS, **parts}))


def first(**changes: Any) -> ScenarioSpec:
    """Change the first robot."""
    return replace(SOUND, robots=(replace(SOUND.robots[0], **changes), SOUND.robots[1]))


BROKEN: Dict[str, ScenarioSpec] = {
    "world": replace(SOUND, world="plane"),
    "model": first(model="diff_drives"),
    "kind of sensor": first(sensors=(replace(SCAN, kind="ranger"),)),
    "setting of a sensor": first(sensors=(replace(SCAN, parameters={"rays": 0}),)),
    "rate of a sensor": first(sensors=(replace(SCAN, rate=-1.0),)),
    "place": first(start=Pose(0.9, 0.0)),
    "radio": replace(SOUND, radio=RadioSetup("lousy")),
    "setting of the radio": replace(SOUND, radio=RadioSetup("lossy", {"range": -1.0})),
    "drive": replace(first(model="omni_drive"), world="bullet"),
    "place of a body": replace(SOUND, bodies=(replace(CAN, pose=Pose(2.0, 2.0)),)),
    "name of a body": replace(SOUND, bodies=(replace(CAN, id="r2"), replace(CAN, mass=-1.0))),
    "bodies": replace(first(model="carrier"), bodies=(CAN,), world="bare"),
}


def test_nothing_is_said_of_a_sound_scenario() -> None:
    assert told(SOUND) == []


@pytest.mark.parametrize("name", sorted(BROKEN))
def test_what_a_simulation_refuses_is_told_in_its_words(name: str) -> None:
    generators = {robot.id: np.random.default_rng(1) for robot in SOUND.robots}

    with pytest.raises(SimError) as caught:
        Simulation(scenario=BROKEN[name], generators=generators, **PARTS)

    assert told(BROKEN[name]) == str(caught.value).splitlines()


def test_world_must_know_bodies_and_where_robots_have_grippers_how_to_attach_them() -> None:
    lacks = "world bare lacks {}; it can do: drive:differential, ranges"

    assert told(BROKEN["bodies"]) == [f"body can: {lacks.format('bodies')}", f"robot r1: {lacks.format('attach')}"]
    assert told(replace(SOUND, bodies=(CAN,), world="bare")) == [f"body can: {lacks.format('bodies')}"]
    assert told(replace(first(model="carrier"), world="bare")) == []


def test_everything_is_told_at_once() -> None:
    broken = replace(
        first(model="diff_drives"),
        world="plane",
        radio=RadioSetup("lousy"),
        obstacles=(Obstacle("r2", Pose(1.1, 0.0), (0.2, 0.2, 0.5)),),
    )

    lines = told(broken)

    assert [line.split(": ")[0] for line in lines] == ["scenario", "robot r1", "scenario", "robot r2", "robot r2"]
    assert lines[-1] == "robot r2: the id is taken by a wall, an obstacle or another robot; give it its own"


def test_world_that_is_not_installed_is_no_fault_of_a_scenario() -> None:
    def absent() -> object:
        raise MissingDependencyError("install it")

    assert told(SOUND, worlds={"planar": absent}) == []


def test_no_world_is_built_and_each_is_closed() -> None:
    calls: List[str] = []

    class Watched:
        capabilities = frozenset({"drive:differential", "ranges"})

        def reset(self, setup: object) -> None:
            calls.append("reset")

        def close(self) -> None:
            calls.append("close")

    factory: Callable[[], object] = Watched

    assert told(SOUND, worlds={"planar": factory}) == []
    assert calls == ["close"]
