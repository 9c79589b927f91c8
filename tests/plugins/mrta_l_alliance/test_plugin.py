"""The hooks, and the template beside ALLIANCE's."""

from __future__ import annotations

from pathlib import Path
from typing import Dict, List
from xml.etree import ElementTree

import mrta_l_alliance.plugin
import pytest
from mrta_alliance.interpreter import AllianceInterpreter
from mrta_l_alliance.agent import LAllianceAgent
from mrta_l_alliance.exporter import MemoryExporter
from mrta_l_alliance.parameters import LearningParameters, read_learning

from rqt_mrta_py.hooks.manager import PluginManager
from rqt_mrta_py.model import Task
from tests.plugins.mrta_alliance.team import behaviour_set, nested


@pytest.fixture
def manager() -> PluginManager:
    made = PluginManager()
    made.register(mrta_l_alliance.plugin, "mrta_l_alliance")
    return made


def test_plugin_registers_agent_interpreter_and_exporter(manager: PluginManager) -> None:
    assert manager.registered("mrta_register_agents") == {"mrta_l_alliance": LAllianceAgent}
    assert manager.registered("mrta_register_allocation_interpreters") == {"mrta_l_alliance": AllianceInterpreter}
    assert manager.registered("mrta_register_exporters") == {"l_alliance_memory": MemoryExporter}


@pytest.mark.parametrize(
    ("architecture", "paths"), [("mrta_l_alliance", ["spin_rate", "learning/window"]), ("mrta_alliance", [])]
)
def test_plugin_checks_parameters_of_alliance_and_of_learning(
    manager: PluginManager, architecture: str, paths: List[str]
) -> None:
    problems = manager.problems(
        "mrta_check_parameters",
        architecture=architecture,
        robot_id="robot1",
        parameters={**nested(behaviour_set("patrol"), spin_rate=0.0), "learning": {"window": 0}},
        tasks=(Task("patrol", "anything"),),
    )
    assert [problem.path for problem in problems] == paths


def template(root: Path, package: str) -> Dict[str, str]:
    """Give the defaults of the robots' template by path."""
    found: Dict[str, str] = {}

    def walk(element: ElementTree.Element, path: str) -> None:
        for child in element:
            name = child.findtext("name", "")
            if child.tag.startswith("param_"):
                found[f"{path}{name}"] = child.findtext("default", "")
            elif child.tag.startswith(("params_", "array_")):
                walk(child, f"{path}{name}/")

    document = ElementTree.parse(root / "plugins" / "architectures" / package / "rqt_mrta.xml")
    wanted = document.findtext("architecture/robots/config_id")
    for config in document.findall("configs/*"):
        if config.findtext("id") == wanted:
            walk(config, "")
    assert found
    return found


def test_the_template_is_alliances_and_learning(root: Path) -> None:
    """Without a memory, robots under either are told the same."""
    ours, theirs = template(root, "mrta_l_alliance"), template(root, "mrta_alliance")
    assert {path: default for path, default in ours.items() if not path.startswith("learning/")} == theirs


def test_defaults_of_the_template_are_those_of_the_parameters(root: Path) -> None:
    texts = {path[9:]: text for path, text in template(root, "mrta_l_alliance").items() if path.startswith("learning/")}
    numbers = {name: float(text) for name, text in texts.items() if name not in ("phase", "memory", "window")}
    assert read_learning({"learning": {**texts, **numbers, "window": int(texts["window"])}}) == LearningParameters()
    assert sorted(texts) == sorted(vars(LearningParameters()))
