"""Teams of agents in lockstep: what is said in one cycle is heard in the next."""

from __future__ import annotations

from collections import Counter
from typing import Any, Dict, List, Sequence

import mrta_baselines.plugin
import numpy as np
import pytest
from mrta_baselines.agent import BaselineAgent
from mrta_baselines.parameters import BaselineParameters, find_problems
from nearest_robot.interpreter import NearestRobotInterpreter

from rqt_mrta_py.hooks import AgentSetup, TaskReport
from rqt_mrta_py.hooks.manager import PluginManager
from rqt_mrta_py.model import Progress, Task
from tests.plugins.nearest_robot.team import Team

TASKS = tuple(Task(f"task{number}", "errand") for number in range(6))
ROBOTS = ("r1", "r2", "r3")


def team_of(rule: str, tasks: Sequence[Task] = TASKS, seed: int = 0, **told: Any) -> Team:
    """Make a team of three whose members can all do everything."""
    agents = {
        robot: BaselineAgent(
            AgentSetup(robot, ROBOTS, tuple(tasks), {"rule": rule, **told}, np.random.default_rng([seed, place]))
        )
        for place, robot in enumerate(ROBOTS)
    }
    return Team(agents, {robot: dict.fromkeys((task.id for task in tasks), 1.0) for robot in ROBOTS})


def finish(team: Team, *robots: str) -> None:
    """Let robots have done what they are on."""
    for robot in robots:
        task = team.decisions[robot].task
        assert task is not None
        team.tell(TaskReport(task, Progress.DONE, "", robot))
        for costs in team.costs.values():
            costs.pop(task, None)


def test_fixed_robots_work_off_their_share() -> None:
    """Offers heard at 1.4 s are dealt at 2.4 s; the first round goes r1, r2, r3, and so does the second."""
    team = team_of("fixed")
    assert set(team.step(6).values()) == {None}
    assert list(team.step().values()) == ["task0", "task1", "task2"]
    finish(team, "r2")
    assert list(team.step().values()) == ["task0", "task4", "task2"]


def test_what_a_fixed_robot_leaves_nobody_does() -> None:
    team = team_of("fixed")
    team.step(7)
    team.stopped.append("r3")
    finish(team, "r1", "r2")
    team.step()
    finish(team, "r1", "r2")
    assert list(team.step(100).values()) == [None, None]


def test_random_robots_hold_different_tasks_after_as_many_cycles_as_there_are_robots() -> None:
    for seed in range(20):
        team = team_of("random", seed=seed)
        held = team.step(4)
        assert len(set(held.values())) == 3
        assert None not in held.values()
        assert team.step(50) == held


def test_random_robots_take_over_what_a_lost_one_leaves() -> None:
    team = team_of("random", TASKS[:3])
    left = team.step(5)["r3"]
    team.stopped.append("r3")
    finish(team, "r1")
    assert team.step(5)["r1"] is None
    assert team.step(10)["r1"] == left


def test_random_teams_differ_by_their_seed_only() -> None:
    held = [tuple(team_of("random", seed=seed).step(4).values()) for seed in (0, 0, 1, 2, 3)]
    assert held[0] == held[1]
    assert len(set(held)) > 1


@pytest.mark.parametrize("rule", ["fixed", "random"])
def test_an_order_is_obeyed_at_once_and_by_everybody(rule: str) -> None:
    team = team_of(rule)
    team.step(7)
    wanted = team.decisions["r1"].task
    assert wanted is not None
    team.tell(TaskReport(wanted, Progress.REASSIGNED, "", "r2"))
    held = team.step()
    assert held["r2"] == wanted
    assert Counter(held.values())[wanted] == 1
    assert team.step(20)["r2"] == wanted


@pytest.mark.parametrize("rule", ["fixed", "random"])
def test_an_unreachable_task_is_left_alone_for_a_while(rule: str) -> None:
    """Told at 2.6 s, so barred up to 12.6 s, 50 cycles."""
    team = team_of(rule, TASKS[:1])
    held = team.step(7)
    (holder,) = (robot for robot, task in held.items() if task)
    team.reports[holder].append(TaskReport("task0", Progress.UNREACHABLE, "", holder))
    after: List[Dict[str, Any]] = [dict(team.step()) for _ in range(51)]
    assert [each[holder] for each in after[:50]] == [None] * 50
    if rule == "fixed":
        assert after[50][holder] == "task0"
    else:
        assert sum(task == "task0" for task in after[50].values()) == 1


@pytest.mark.parametrize("rule", ["fixed", "random"])
def test_a_task_that_appears_is_done_by_somebody(rule: str) -> None:
    team = team_of(rule, TASKS[:1])
    team.step(7)
    new = Task("late", "errand")
    team.tell(TaskReport("late", Progress.APPEARED, "", None, new))
    for costs in team.costs.values():
        costs["late"] = 1.0
    assert sorted(task or "" for task in team.step(10).values()) == ["", "late", "task0"]


@pytest.mark.parametrize(
    ("given", "problems"),
    [
        ({}, []),
        ({"rule": "best"}, ["rule: must be one of fixed, random (got 'best')"]),
        ({"rule": 1}, ["rule: must be a text (got 1)"]),
        ({"rate": 1}, ["rate: must be from 2 to 100 Hz (got 1)"]),
        ({"rate": "often"}, ["rate: must be a number (got 'often')"]),
        (
            {"timeout": 0.3},
            ["timeout: must be at least two cycles, 0.4 s (got 0.3), or robots at work would be left out"],
        ),
        ({"settle": -1}, ["settle: must be a finite number, at least 0 s (got -1)"]),
    ],
)
def test_parameters_that_make_no_sense_are_told(given: Dict[str, Any], problems: List[str]) -> None:
    assert [f"{problem.path}: {problem.message}" for problem in find_problems(given)] == problems


def test_the_plugin_registers_agent_and_interpreter() -> None:
    manager = PluginManager()
    manager.register(mrta_baselines.plugin, "mrta_baselines")
    assert manager.registered("mrta_register_agents") == {"mrta_baselines": BaselineAgent}
    assert manager.registered("mrta_register_allocation_interpreters") == {"mrta_baselines": NearestRobotInterpreter}
    asked = {"robot_id": "r1", "parameters": {"rate": 1}, "tasks": ()}
    assert len(manager.problems("mrta_check_parameters", architecture="mrta_baselines", **asked)) == 1
    assert not manager.problems("mrta_check_parameters", architecture="nearest_robot", **asked)
    assert BaselineParameters() == BaselineParameters("fixed", 5.0, 2.0, 1.0, 10.0)
