"""Missions of target_visiting: all targets that can be reached are visited, and of the other one all are told."""

from __future__ import annotations

from typing import List, Sequence, Set

import pytest

from rqt_mrta_py.app.bench.laboratory import EmbeddedLaboratory
from rqt_mrta_py.app.compose import compose
from rqt_mrta_py.config.mission import load_mission
from rqt_mrta_py.hooks import Experiment, Trial
from rqt_mrta_py.model import MapKnowledge, Mission, TaskState
from rqt_mrta_py.robot import GridNavigator
from rqt_mrta_py.sim.robot_models import SMALL_DIFF_DRIVE

REACHABLE = {f"target{number}" for number in range(1, 10)}
UNREACHABLE = "target10"
TOLD = "demir_cf_msgs/Unachievability"
MAPS = list(MapKnowledge)


@pytest.fixture(scope="module")
def mission() -> Mission:
    return load_mission(compose().registry, "target_visiting")


def carried_out(experiments: Sequence[Experiment]) -> List[Trial]:
    return list(EmbeddedLaboratory(compose()).trials(experiments))


def visited(trial: Trial) -> Set[str]:
    return {task.id for task in trial.record.tasks if task.history[-1].state is TaskState.DONE}


def test_one_target_cannot_be_reached_and_each_other_one_from_everywhere(mission: Mission) -> None:
    scenario = mission.scenario
    assert scenario is not None
    navigator = GridNavigator(scenario.arena, scenario.obstacles, radius=SMALL_DIFF_DRIVE.radius)
    for task in mission.tasks:
        assert task.place is not None
        costs = [navigator.cost_field(task.place).at(robot.start) for robot in scenario.robots]
        assert [cost is None for cost in costs] == [task.id == UNREACHABLE] * 5, task.id
        if task.id != UNREACHABLE:
            way = navigator.path(scenario.robots[0].start, task.place)
            assert way is not None
            assert way[-1].distance(task.place) <= task.data["tolerance"]


def test_three_robots_that_know_the_map_visit_what_can_be_reached_and_tell_of_the_rest() -> None:
    (trial,) = carried_out([Experiment("target_visiting", 1, world="planar", robots=3, duration=45.0)])
    assert visited(trial) == REACHABLE
    assert trial.messages[TOLD] == 1
    assert trial.record.incidents == ()


def test_three_robots_that_map_find_out_that_a_target_cannot_be_reached() -> None:
    """They first go there: nobody tells before a robot has tried."""
    tasks = ("target5", "target6", UNREACHABLE)
    experiment = Experiment(
        "target_visiting", 1, world="planar", robots=3, map=MapKnowledge.UNKNOWN, duration=40.0, tasks=tasks
    )
    (trial,) = carried_out([experiment])
    assert visited(trial) == {"target5", "target6"}
    assert trial.messages[TOLD] >= 1
    tried = [allocation for allocation in trial.record.allocations if allocation.task == UNREACHABLE]
    assert tried
    assert tried[0].end is not None
    assert tried[0].end - tried[0].start > 2.0


def test_equal_missions_on_unknown_maps_are_equal() -> None:
    experiment = Experiment(
        "target_visiting",
        3,
        world="planar",
        robots=2,
        map=MapKnowledge.UNKNOWN,
        duration=8.0,
        architecture="nearest_robot",
    )
    first, second = carried_out([experiment, experiment])
    assert first.record == second.record
    assert first.messages == second.messages


@pytest.mark.parametrize("knowledge", MAPS, ids=lambda each: each.value)
def test_an_architecture_that_goes_by_costs_visits_them_too(knowledge: MapKnowledge) -> None:
    (trial,) = carried_out(
        [
            Experiment(
                "target_visiting",
                0,
                architecture="nearest_robot",
                world="planar",
                robots=2,
                map=knowledge,
                duration=30.0,
                tasks=("target6", "target8", "target9"),
            )
        ]
    )
    assert visited(trial) == {"target6", "target8", "target9"}


@pytest.mark.long
@pytest.mark.parametrize("architecture", ["mrta_alliance", "mrta_l_alliance", "mrta_baselines", "nearest_robot"])
@pytest.mark.parametrize("knowledge", MAPS, ids=lambda each: each.value)
def test_every_architecture_visits_what_can_be_reached(architecture: str, knowledge: MapKnowledge) -> None:
    (trial,) = carried_out([Experiment("target_visiting", 0, architecture=architecture, world="planar", map=knowledge)])
    assert visited(trial) == REACHABLE


@pytest.mark.long
@pytest.mark.parametrize("world", ["planar", "bullet"])
@pytest.mark.parametrize("knowledge", MAPS, ids=lambda each: each.value)
def test_every_seed_visits_what_can_be_reached_and_tells_of_the_rest(world: str, knowledge: MapKnowledge) -> None:
    seeds = range(6) if world == "planar" else range(2)
    trials = carried_out(
        [
            Experiment("target_visiting", seed, world=world, robots=robots, map=knowledge)
            for seed in seeds
            for robots in (3, 5)
        ]
    )
    assert [trial.experiment for trial in trials if visited(trial) != REACHABLE] == []
    assert [trial.experiment for trial in trials if trial.messages.get(TOLD, 0) == 0] == []
