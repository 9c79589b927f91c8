"""The hooks, as the host asks for them, the parameters, and the files of the package."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any, List, Mapping, Sequence

import mrta_demir_cf.plugin
import pytest
from mrta_demir_cf.agent import DemirCfAgent
from mrta_demir_cf.interpreter import DemirCfInterpreter
from mrta_demir_cf.panel import CostPanel
from mrta_demir_cf.parameters import DemirCfParameters, read_parameters
from mrta_demir_cf.planning.costs import eyh_cost, uem_cost

from rqt_mrta_py.config.discovery.search import discover
from rqt_mrta_py.config.mission import load_mission
from rqt_mrta_py.hooks import Outgoing
from rqt_mrta_py.hooks.manager import PluginManager
from rqt_mrta_py.model import ArchitectureSpec, Mission, Task
from tests.plugins.mrta_demir_cf.script import Script


@pytest.fixture
def manager() -> PluginManager:
    made = PluginManager()
    made.register(mrta_demir_cf.plugin, "mrta_demir_cf")
    return made


def test_plugin_registers_its_parts(manager: PluginManager) -> None:
    assert manager.registered("mrta_register_agents") == {"mrta_demir_cf": DemirCfAgent}
    assert manager.registered("mrta_register_allocation_interpreters") == {"mrta_demir_cf": DemirCfInterpreter}
    assert manager.registered("mrta_register_monitor_panels") == {"mrta_demir_cf/costs": CostPanel}


@pytest.mark.parametrize(
    ("given", "problems"),
    [
        ({}, []),
        ({"rate": 1}, ["rate: must be from 2 to 100 Hz (got 1)"]),
        ({"objective": "profit"}, ["objective: must be path or time (got 'profit')"]),
        (
            {"cost": "prim", "alpha": 1.1},
            [
                "cost: must be eyh, uem, rollout, greedy or balanced under the objective time (got 'prim')",
                "alpha: must be from 0 to 1 (got 1.1)",
            ],
        ),
        (
            {"cost": "balanced", "objective": "path"},
            ["cost: must be eyh, uem, rollout or greedy under the objective path (got 'balanced')"],
        ),
        ({"reply_timeout": 0.1}, ["reply_timeout: must be at least two cycles, 0.2 s (got 0.1)"]),
        ({"heartbeat": 3.0}, ["heartbeat: must be above 0 and at most 2.5 s (got 3)"]),
        (
            {"execution_timeout": 5.0},
            [
                "execution_timeout: must be at least three heartbeats, 6 s (got 5)",
                "request_timeout: must be from reply_timeout + heartbeat = 3 s to execution_timeout = 5 s (got 7)",
            ],
        ),
        (
            {"request_timeout": 2.0},
            ["request_timeout: must be from reply_timeout + heartbeat = 3 s to execution_timeout = 7 s (got 2)"],
        ),
        (
            {"margin": 1.0, "overdue": 1.0},
            ["overdue: must be above 1 (got 1)", "margin: must be at least 0 and below 1 (got 1)"],
        ),
        ({"retry": float("nan")}, ["retry: must be a finite number, at least 0 s (got nan)"]),
        ({"unknown_cost": float("inf")}, ["unknown_cost: must be a finite number, at least 0 m (got inf)"]),
        ({"speed": 0.0}, ["speed: must be a finite number, above 0 m/s (got 0)"]),
        ({"handling": "yes"}, ["handling: must be true or false (got 'yes')"]),
        ({"rate": True, "cost": 3}, ["rate: must be a number (got True)", "cost: must be a text (got 3)"]),
    ],
    ids=str,
)
def test_plugin_checks_parameters_of_its_own_architecture_only(
    manager: PluginManager, given: Mapping[str, Any], problems: List[str]
) -> None:
    def found(architecture: str) -> Sequence[str]:
        answers = manager.problems(
            "mrta_check_parameters",
            architecture=architecture,
            robot_id="a",
            parameters=given,
            tasks=(Task("t", "any"),),
        )
        return [f"{problem.path}: {problem.message}" for problem in answers]

    assert found("mrta_demir_cf") == problems
    assert found("another") == []


def test_cost_functions_are_those_of_the_paper() -> None:
    assert read_parameters({"cost": "eyh"}).cost_function() is eyh_cost
    assert read_parameters({"alpha": 0.7}).cost_function() == uem_cost(0.7)


@pytest.fixture(scope="module")
def mission() -> Mission:
    return load_mission(discover({}), "border_patrol", architecture="mrta_demir_cf")


def test_template_has_a_default_for_every_parameter_and_they_are_the_agents(mission: Mission) -> None:
    for given in mission.parameters.values():
        assert list(given) == list(DemirCfParameters.__dataclass_fields__)
        assert read_parameters(given) == DemirCfParameters()
    assert str(mission.architecture.taxonomy) == "ST-SR-IA"
    assert mission.architecture.widgets == ("mrta_demir_cf/costs",)


def test_monitored_topics_name_fields_of_the_messages_that_agents_say(mission: Mission, root: Path) -> None:
    declared: ArchitectureSpec = mission.architecture
    topics = [*declared.busy_robots, *declared.idle_robots, *declared.allocated_tasks, *declared.completed_tasks]
    for topic in topics:
        name = topic.type.partition("/")[2]
        text = (root / "plugins/messages/demir_cf_msgs/msg" / f"{name}.msg").read_text(encoding="utf-8")
        fields = re.findall(r"^[\w/\[\]]+ +(\w+)", text, re.MULTILINE)
        assert {path for path in (topic.field, topic.robot_field, topic.task_field) if path} <= set(fields)
        assert topic.timeout is not None
        assert topic.timeout > 2.5


def test_beliefs_are_told_when_they_change_and_from_time_to_time(root: Path) -> None:
    script = Script({"t": (4.0, 0.0)})
    said: List[Outgoing] = []
    agent_step = script.agent.step

    def listen(situation: Any) -> Any:
        decision = agent_step(situation)
        said.extend(message for message in decision.messages if message.type == "demir_cf_msgs/Beliefs")
        return decision

    script.agent.step = listen  # type: ignore[method-assign]
    script.executing()
    text = (root / "plugins/messages/demir_cf_msgs/msg/Beliefs.msg").read_text(encoding="utf-8")
    assert list(said[-1].fields) == re.findall(r"^[\w/\[\]]+ +(\w+)", text, re.MULTILINE)
    assert [message.fields["states"] for message in said] == [["initial"], ["requested"], ["executing"]]
    assert (said[-1].fields["task_id"], said[-1].fields["holders"]) == ("t", ["b"])
    script.wait(4.0)
    assert len(said) == 3 + 4
