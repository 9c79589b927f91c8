"""Whether a scenario can be simulated: what the simulation would refuse, found without simulating anything."""

from __future__ import annotations

from functools import partial
from typing import Iterator

from rqt_mrta_py.app.doctor.scenario_places import Told, located
from rqt_mrta_py.app.doctor.subject import Subject
from rqt_mrta_py.app.guard import makers
from rqt_mrta_py.app.run.chance import Purpose, generator, link_generator
from rqt_mrta_py.app.run.missing import missing_planner
from rqt_mrta_py.config.loading import yaml_text
from rqt_mrta_py.config.yaml.lines import YamlLines
from rqt_mrta_py.errors import Problem
from rqt_mrta_py.hooks.manager import PluginManager
from rqt_mrta_py.model import ScenarioSpec
from rqt_mrta_py.sim import scenario_problems

__all__ = ["check_scenario"]


def check_scenario(subject: Subject) -> Iterator[Problem]:
    """Find worlds, models, sensors, radios and planners that nobody registers, wrong settings, and robots misplaced."""
    for application in subject.applications:
        path, scenario = application.registration.scenario, application.scenario
        if path is None or scenario is None:
            continue
        lines = YamlLines(yaml_text(path) or "")
        for element, message in _told(scenario, subject.host.manager, lines):
            yield Problem(str(path), lines.of(element), element, message)


def _told(scenario: ScenarioSpec, manager: PluginManager, lines: YamlLines) -> Iterator[Told]:
    planner = missing_planner(scenario.planner, manager.registered("mrta_register_planners"))
    if planner is not None:
        yield Told("planner", planner)
    found = scenario_problems(
        scenario,
        models=manager.registered("mrta_register_robot_models"),
        sensors=makers("sensor", manager.registered("mrta_register_sensors"), "rays", "sense"),
        team_sensors=makers("team sensor", manager.registered("mrta_register_team_sensors"), "rays", "sense"),
        worlds=makers("world", manager.registered("mrta_register_worlds"), "capabilities", "close"),
        links=makers("link", manager.registered("mrta_register_links"), "deliveries"),
        generators={robot.id: generator(0, robot.id, Purpose.SENSORS) for robot in scenario.robots},
        link_random=partial(link_generator, 0),
    )
    for line in found:
        yield located(line, lines)
