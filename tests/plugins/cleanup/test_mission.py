"""Missions of cleanup: every task that can end is carried out, whoever is lost, and the hall is clean."""

from __future__ import annotations

from typing import Dict, List, Sequence

import numpy as np
import pytest

from rqt_mrta_py.app.bench.laboratory import EmbeddedLaboratory
from rqt_mrta_py.app.cli.main import main
from rqt_mrta_py.app.compose import compose
from rqt_mrta_py.config.mission import load_mission
from rqt_mrta_py.hooks import Experiment, Trial
from rqt_mrta_py.model import Mission, Pose, ScenarioEvent, ScenarioEventKind, TaskState
from rqt_mrta_py.transport import read_bag
from tests.app.outputs import Outputs
from tests.sampling import every

TEAM = ("robot1", "robot2", "robot3", "robot4", "robot5")
TASKS = ["bottles", "cans", "crates", "barrels", "report"]
CAPABLE = ("robot1", "robot3")
"""Robots that can carry out every task."""


@pytest.fixture(scope="module")
def mission() -> Mission:
    return load_mission(compose().registry, "cleanup")


@pytest.fixture(scope="module")
def outputs(tmp_path_factory: pytest.TempPathFactory) -> Outputs:
    """Run cleanup from above for as long as a team of five needs, and a little longer."""
    folder = tmp_path_factory.mktemp("cleanup") / "run"
    arguments = ["--world", "planar", "--duration", "130", "--pictures", "0", "--out", str(folder), "-q"]
    assert main(["run", "cleanup", *arguments]) == 0
    return Outputs(folder)


def carried_out(experiments: Sequence[Experiment]) -> List[Trial]:
    return list(EmbeddedLaboratory(compose()).trials(experiments))


def not_done(trial: Trial) -> List[str]:
    return [task.id for task in trial.record.tasks if task.history[-1].state is not TaskState.DONE]


def losses(seed: int, survivor: str, team: Sequence[str], latest: float) -> List[ScenarioEvent]:
    """Stop everybody but one robot, each at a time of its own."""
    draw = np.random.default_rng(seed)
    lost = [
        ScenarioEvent(float(np.round(draw.uniform(0.0, latest), 1)), ScenarioEventKind.ROBOT_STOPS, robot)
        for robot in team
        if robot != survivor
    ]
    return sorted(lost, key=lambda event: event.time)


def test_all_tasks_end_by_those_who_are_good_at_them(outputs: Outputs) -> None:
    done = {
        allocation["task"]: allocation["robot"]
        for allocation in outputs.summary["allocations"]
        if allocation["outcome"] == "done"
    }
    assert done == {
        "bottles": "robot2",
        "cans": "robot4",
        "crates": "robot1",
        "barrels": "robot3",
        "report": "robot5",
    }
    assert outputs.summary["incidents"] == []


def test_in_the_end_all_things_lie_where_they_belong(outputs: Outputs, mission: Mission) -> None:
    codec = compose().codec()
    truth: Dict[str, Pose] = {}
    for connection, _, raw in read_bag(outputs.bag, topics=["/simulation/bodies"]):
        for body in codec.decode(connection, raw)["detections"]:
            truth[body["id"]] = Pose(body["position"]["x"], body["position"]["y"])
    assert mission.scenario is not None
    assert len(truth) == len(mission.scenario.bodies) == 14
    zones = {task.data["thing"]: task for task in mission.tasks if task.kind == "collect"}
    for body in mission.scenario.bodies:
        task = zones[body.kind]
        assert task.place is not None
        assert truth[body.id].distance(task.place) <= task.data["zone"] + 0.15, body.id


def test_all_tasks_end_under_an_architecture_that_goes_by_costs() -> None:
    (trial,) = carried_out(
        [
            Experiment(
                "cleanup",
                0,
                architecture="nearest_robot",
                duration=180.0,
                world="planar",
                robots=2,
                tasks=("bottles", "crates"),
            )
        ]
    )
    assert not_done(trial) == []
    assert trial.record.incidents == ()


def test_a_task_ends_under_an_architecture_that_negotiates() -> None:
    (trial,) = carried_out(
        [
            Experiment(
                "cleanup",
                0,
                architecture="mrta_demir_cf",
                duration=180.0,
                world="planar",
                robots=2,
                tasks=("bottles",),
            )
        ]
    )
    assert not_done(trial) == []


@pytest.mark.parametrize("robots", [1, 2, 3, 4])
def test_the_first_robots_can_do_everything_together(mission: Mission, robots: int) -> None:
    able = {task for robot in mission.application.robots[:robots] for task in robot.tasks}
    assert able == set(TASKS)


@pytest.mark.parametrize("seed", every(3, range(5)))
def test_with_one_capable_robot_left_alive_a_task_that_ends_is_carried_out(seed: int) -> None:
    """The slow robot clears the area of the bottles, whenever the fast one has stopped."""
    (trial,) = carried_out(
        [
            Experiment(
                "cleanup",
                seed,
                duration=500.0,
                world="planar",
                robots=2,
                events=tuple(losses(seed, "robot1", TEAM[:2], 60.0)),
                tasks=("bottles",),
            )
        ]
    )
    assert not_done(trial) == []


@pytest.mark.long
def test_with_one_capable_robot_left_alive_every_task_is_carried_out_in_every_seed() -> None:
    trials = carried_out(
        [
            Experiment(
                "cleanup",
                seed,
                duration=1500.0,
                world="planar",
                events=tuple(losses(seed, CAPABLE[seed % 2], TEAM, 120.0)),
            )
            for seed in range(50)
        ]
    )
    assert {trial.experiment.seed: not_done(trial) for trial in trials if not_done(trial)} == {}
    assert len(trials) == 50
