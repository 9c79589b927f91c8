"""The hooks, as the host asks for them."""

from __future__ import annotations

import mrta_alliance.plugin
import pytest
from mrta_alliance.agent import AllianceAgent
from mrta_alliance.interpreter import AllianceInterpreter
from mrta_alliance.panel import MotivationPanel
from mrta_alliance.sensors import AnyMessage, Scan

from rqt_mrta_py.hooks.manager import PluginManager
from rqt_mrta_py.model import Task
from tests.plugins.mrta_alliance.team import behaviour_set, nested


@pytest.fixture
def manager() -> PluginManager:
    made = PluginManager()
    made.register(mrta_alliance.plugin, "mrta_alliance")
    return made


def test_plugin_registers_agent_interpreter_panel_and_sensors(manager: PluginManager) -> None:
    assert manager.registered("mrta_register_agents") == {"mrta_alliance": AllianceAgent}
    assert manager.registered("mrta_register_allocation_interpreters") == {"mrta_alliance": AllianceInterpreter}
    assert manager.registered("mrta_register_monitor_panels")["rqt_alliance/alliance_plugin"] is MotivationPanel
    assert manager.registered("mrta_register_robot_sensors") == {
        "mrta_alliance/any_message": AnyMessage,
        "mrta_alliance/scan": Scan,
    }


@pytest.mark.parametrize(("architecture", "paths"), [("mrta_alliance", ["spin_rate"]), ("another", [])])
def test_plugin_checks_parameters_of_its_own_architecture_only(
    manager: PluginManager, architecture: str, paths: list
) -> None:
    problems = manager.problems(
        "mrta_check_parameters",
        architecture=architecture,
        robot_id="robot1",
        parameters=nested(behaviour_set("patrol"), spin_rate=0.0),
        tasks=(Task("patrol", "anything"),),
    )
    assert [problem.path for problem in problems] == paths
