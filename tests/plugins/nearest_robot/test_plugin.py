"""The hooks, as the host asks for them, and the files of the package."""

from __future__ import annotations

import re
from argparse import ArgumentParser
from pathlib import Path
from typing import Any, Iterator, List, Mapping, Sequence

import nearest_robot.plugin
import pytest
from nearest_robot.agent import NearestRobotAgent
from nearest_robot.allocators import allocate_nearest, allocate_optimally
from nearest_robot.benchmark import allocators_benchmark
from nearest_robot.interpreter import NearestRobotInterpreter
from nearest_robot.panel import CostPanel
from nearest_robot.parameters import NearestRobotParameters, read_parameters

from rqt_mrta_py.config.discovery.search import discover
from rqt_mrta_py.config.mission import load_mission
from rqt_mrta_py.hooks import BenchmarkTable, Experiment, Trial
from rqt_mrta_py.hooks.manager import PluginManager
from rqt_mrta_py.model import ArchitectureSpec, Task
from tests.plugins.nearest_robot.team import own_bid, team_of

T = Task("t", "any")


class NoExperiments:
    """A laboratory that nobody may use."""

    def trials(self, experiments: Sequence[Experiment]) -> Iterator[Trial]:
        raise AssertionError(experiments)


@pytest.fixture
def manager() -> PluginManager:
    made = PluginManager()
    made.register(nearest_robot.plugin, "nearest_robot")
    return made


def test_plugin_registers_its_parts(manager: PluginManager) -> None:
    assert manager.registered("mrta_register_agents") == {"nearest_robot": NearestRobotAgent}
    assert manager.registered("mrta_register_allocation_interpreters") == {"nearest_robot": NearestRobotInterpreter}
    assert manager.registered("mrta_register_allocators") == {
        "nearest_robot/nearest": allocate_nearest,
        "nearest_robot/optimal": allocate_optimally,
    }
    assert manager.registered("mrta_register_monitor_panels") == {"nearest_robot/costs": CostPanel}
    assert list(manager.registered("mrta_register_benchmarks")) == ["allocators"]


@pytest.mark.parametrize(
    ("given", "problems"),
    [
        ({}, []),
        ({"rate": 1.0}, ["rate: must be from 2 to 100 Hz (got 1)"]),
        (
            {"rate": 4.0, "timeout": 0.4},
            ["timeout: must be at least two cycles, 0.5 s (got 0.4), or robots at work would be left out"],
        ),
        ({"keep": -1.0}, ["keep: must be a finite number, at least 0 m (got -1)"]),
        ({"keep": float("nan")}, ["keep: must be a finite number, at least 0 m (got nan)"]),
        (
            {"retry": "soon", "allocator": 3},
            ["retry: must be a number (got 'soon')", "allocator: must be a text (got 3)"],
        ),
        ({"allocator": ""}, ["allocator: must name an allocator, as package/name (got nothing)"]),
    ],
    ids=str,
)
def test_plugin_checks_parameters_of_its_own_architecture_only(
    manager: PluginManager, given: Mapping[str, Any], problems: List[str]
) -> None:
    def found(architecture: str) -> Sequence[str]:
        answers = manager.problems(
            "mrta_check_parameters", architecture=architecture, robot_id="a", parameters=given, tasks=(T,)
        )
        return [f"{problem.path}: {problem.message}" for problem in answers]

    assert found("nearest_robot") == problems
    assert found("another") == []


@pytest.fixture(scope="module")
def declared() -> ArchitectureSpec:
    registry = discover({})
    return load_mission(registry, "border_patrol", architecture="nearest_robot").architecture


def test_template_has_a_default_for_every_parameter_and_they_are_the_agents(declared: ArchitectureSpec) -> None:
    mission = load_mission(discover({}), "border_patrol", architecture="nearest_robot")
    assert set(mission.parameters) == {"robot1", "robot2", "robot3", "robot4", "robot5"}
    for given in mission.parameters.values():
        assert set(given) == set(NearestRobotParameters.__dataclass_fields__)
        assert read_parameters(given) == NearestRobotParameters()
    assert str(declared.taxonomy) == "ST-SR-IA"
    assert declared.widgets == ("nearest_robot/costs",)


def test_monitored_topics_name_fields_of_the_messages_that_agents_say(declared: ArchitectureSpec, root: Path) -> None:
    team = team_of({"a": {"t": 1.0}}, [T])
    team.step(2)
    said = {message.topic: message for message in team.decisions["a"].messages}
    topics = (*declared.busy_robots, *declared.idle_robots, *declared.allocated_tasks)
    assert {topic.name for topic in topics} == set(said)
    for topic in topics:
        assert topic.type == said[topic.name].type
        for path in filter(None, (topic.field, topic.robot_field, topic.task_field)):
            assert said[topic.name].fields[path] in ("a", "t")
    for message in said.values():
        name = message.type.partition("/")[2]
        text = (root / "plugins/messages/nearest_robot_msgs/msg" / f"{name}.msg").read_text(encoding="utf-8")
        assert re.findall(r"^[\w\[\]]+ +(\w+)", text, re.MULTILINE) == list(message.fields)


def test_bids_are_told_before_the_claim() -> None:
    """So that an interpreter knows why the old task went before the new one is taken."""
    team = team_of({"a": {"t": 1.0}}, [T])
    team.step(2)
    assert [message.topic for message in team.decisions["a"].messages] == [
        "/nearest_robot/bids",
        "/nearest_robot/claims",
    ]
    assert own_bid(team.decisions["a"])["holding"] == "t"


def test_benchmark_compares_both_allocators_on_equal_instances() -> None:
    ticks = iter(range(1000))
    benchmark = allocators_benchmark(lambda: float(next(ticks)))
    parser = ArgumentParser()
    benchmark.add_arguments(parser)
    options = parser.parse_args(["--robots", "6", "--tasks", "4", "--instances", "10", "--seed", "3"])
    table = benchmark.measure(options, NoExperiments())
    assert isinstance(table, BenchmarkTable)
    greedy, optimal = table.rows
    assert [row[0] for row in table.rows] == ["nearest_robot/nearest", "nearest_robot/optimal"]
    assert optimal[2:4] == (1.0, 1.0)
    assert 1.0 < greedy[2] <= greedy[3]
    assert greedy[4:] == optimal[4:] == (1000.0, 1000.0)
    assert all(len(row) == len(table.columns) for row in table.rows)
    assert benchmark.measure(options, NoExperiments()) == table


@pytest.mark.parametrize("arguments", [["--robots", "0"], ["--tasks", "x"], ["--seed", "-1"], ["--instances", "²"]])
def test_benchmark_refuses_numbers_that_make_no_sense(arguments: List[str]) -> None:
    parser = ArgumentParser()
    allocators_benchmark().add_arguments(parser)
    with pytest.raises(SystemExit):
        parser.parse_args(arguments)
