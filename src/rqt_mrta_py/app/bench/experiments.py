"""From an experiment to its mission: the application as ``mrta run`` loads it, with what the experiment changes."""

from __future__ import annotations

import dataclasses
from typing import Dict, List, Optional, Sequence, Tuple

from rqt_mrta_py.app.compose import Host
from rqt_mrta_py.app.making import making_of
from rqt_mrta_py.app.selection import first_robots, in_world, with_map
from rqt_mrta_py.config.loading import load_team
from rqt_mrta_py.config.mission import load_mission
from rqt_mrta_py.config.scenario.event_order import appearing_tasks
from rqt_mrta_py.errors import UsageError
from rqt_mrta_py.hooks import Experiment
from rqt_mrta_py.model import Mission, ScenarioSpec, Task
from rqt_mrta_py.wording import accepted

__all__ = ["ExperimentMissions", "settings_for"]

_MOST_MISSIONS = 16
"""How many loaded missions are remembered; experiments that differ by their seed alone share one."""

_Files = Tuple[str, Optional[str], Tuple[str, ...], Optional[int]]


class ExperimentMissions:
    """Makes missions of experiments.

    Args:
        host: registry and plugins.

    Attributes:
        host: see above.
    """

    def __init__(self, host: Host) -> None:
        self.host = host
        self._loaded: Dict[_Files, Tuple[Mission, Tuple[str, ...], Optional[int]]] = {}

    def prepare(self, experiment: Experiment) -> Tuple[Mission, float]:
        """Make the mission of an experiment.

        Returns:
            It, and how long it lasts at most [s].

        Raises:
            MrtaError: something is wrong with the application's files, or the experiment does not fit them.
        """
        whole, order, robots = self._load(experiment)
        if whole.scenario is None:
            raise UsageError("has no scenario, so there is nothing to simulate")
        scenario = whole.scenario
        if experiment.events is not None:
            events = tuple(sorted(experiment.events, key=lambda event: event.time))
            scenario = dataclasses.replace(scenario, events=events)
        if experiment.radio is not None:
            scenario = dataclasses.replace(scenario, radio=experiment.radio)
        mission = dataclasses.replace(whole, seed=experiment.seed)
        mission = _with_tasks(mission, scenario, order, experiment.tasks)
        worlds = self.host.manager.registered("mrta_register_worlds")
        mission = in_world(first_robots(mission, robots), experiment.world, worlds)
        mission = with_map(mission, experiment.map)
        return mission, scenario.duration if experiment.duration is None else experiment.duration

    def _load(self, experiment: Experiment) -> Tuple[Mission, Tuple[str, ...], Optional[int]]:
        """Give the application's mission, the ids of all its tasks in file order, and how many robots take part."""
        key = (experiment.application, experiment.architecture, experiment.settings, experiment.robots)
        found = self._loaded.get(key)
        if found is None:
            registry = self.host.registry
            making = making_of(self.host, experiment.application, experiment.settings, experiment.robots, strict=False)
            team = load_team(registry, experiment.application, experiment.architecture, rewrite=making.rewrite).team
            mission = load_mission(
                registry,
                experiment.application,
                architecture=experiment.architecture,
                overrides=settings_for([robot.id for robot in team.application.robots], making.overrides),
                checks=self.host.manager,
                kinds=self.host.manager.registered("mrta_register_behaviours"),
                rewrite=making.rewrite,
            )
            while len(self._loaded) >= _MOST_MISSIONS:
                del self._loaded[next(iter(self._loaded))]
            found = self._loaded[key] = mission, tuple(task.id for task in team.tasks), making.robots
        return found


def settings_for(robots: Sequence[str], settings: Sequence[str]) -> List[str]:
    """Spell settings out robot by robot, as ``--set`` takes them.

    Args:
        robots: ids of the team.
        settings: each ``<robot>/<path>=<value>``, or ``<path>=<value>`` for all robots.

    Returns:
        Those of single robots after those for all, whose place they take.
    """
    of_one = [setting for setting in settings if setting.lstrip("/").partition("/")[0] in robots]
    of_all = [setting for setting in settings if setting not in of_one]
    return [f"{robot}/{setting.lstrip('/')}" for setting in of_all for robot in robots] + of_one


def _with_tasks(
    mission: Mission, scenario: ScenarioSpec, order: Sequence[str], wanted: Optional[Sequence[str]]
) -> Mission:
    """Sort tasks anew into those that are there from the start and those that appear, and leave some out.

    Those left out stay among the ones that could appear, for parameters may speak of them; but they never do.
    """
    by_id: Dict[str, Task] = {task.id: task for task in mission.every_task}
    kept = frozenset(order if wanted is None else wanted)
    for task in sorted(kept.difference(by_id)):
        raise UsageError(f"task {task!r}: the application has no such task; {accepted(task, order)}")
    for event in scenario.events:
        if event.task is not None and event.task not in by_id:
            raise UsageError(f"task {event.task!r} of an event: there is no such task; {accepted(event.task, order)}")
    events = tuple(event for event in scenario.events if event.task is None or event.task in kept)
    appearing = appearing_tasks(events)
    first = tuple(by_id[task] for task in order if task in kept and task not in appearing)
    later = tuple(by_id[task] for task in order if task not in kept or task in appearing)
    scenario = dataclasses.replace(scenario, events=events)
    return dataclasses.replace(mission, tasks=first, later_tasks=later, scenario=scenario)
