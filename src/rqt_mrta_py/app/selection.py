"""A mission with part of its team, in another world, or with a map that is known or not."""

from __future__ import annotations

import dataclasses
from typing import Collection, FrozenSet, Optional, Sequence

from rqt_mrta_py.errors import UsageError
from rqt_mrta_py.model import (
    MAPPED_TOPICS,
    ApplicationSpec,
    MapKnowledge,
    Mission,
    ScenarioEvent,
    ScenarioEventKind,
)

__all__ = ["check_number", "first_robots", "in_world", "with_map", "with_robots"]


def with_robots(mission: Mission, robot_ids: Sequence[str]) -> Mission:
    """Keep only some robots of a mission, with what is simulated of them and what happens to them.

    Orders to hand a task to a robot that is left out are left out too; what happens to tasks and to the radio stays.

    Args:
        mission: the whole.
        robot_ids: whom to keep; order and unknown ids do not matter.

    Returns:
        The part, or the mission itself if nobody is left out.
    """
    kept = frozenset(robot_ids)
    if all(robot.id in kept for robot in mission.application.robots):
        return mission
    application = dataclasses.replace(
        mission.application, robots=tuple(robot for robot in mission.application.robots if robot.id in kept)
    )
    scenario = mission.scenario
    if scenario is not None:
        scenario = dataclasses.replace(
            scenario,
            robots=tuple(robot for robot in scenario.robots if robot.id in kept),
            events=tuple(
                _without_strangers(event, kept)
                for event in scenario.events
                if event.robot is None or event.robot in kept
            ),
        )
    parameters = {robot_id: values for robot_id, values in mission.parameters.items() if robot_id in kept}
    return dataclasses.replace(mission, application=application, scenario=scenario, parameters=parameters)


def first_robots(mission: Mission, number: Optional[int]) -> Mission:
    """Keep the first robots of the application.

    Args:
        mission: the whole.
        number: how many; None for all.

    Raises:
        UsageError: fewer than one, or more than the application has.
    """
    if number is None:
        return mission
    check_number(mission.application, number)
    return with_robots(mission, [robot.id for robot in mission.application.robots[:number]])


def check_number(application: ApplicationSpec, number: Optional[int]) -> None:
    """Make sure that an application has so many robots.

    Args:
        application: as registered.
        number: how many are wanted; None for all.

    Raises:
        UsageError: fewer than one, or more than there are.
    """
    there = len(application.robots)
    if number is not None and not 1 <= number <= there:
        raise UsageError(f"--robots {number}: {application.package} has {there} robots; give 1 to {there}")


def in_world(mission: Mission, world: Optional[str], worlds: Collection[str]) -> Mission:
    """Simulate a mission in another world than its scenario names.

    Args:
        mission: the whole.
        world: its name; None for the scenario's.
        worlds: names of those that there are.

    Raises:
        UsageError: there is no such world.
    """
    if world is None or mission.scenario is None:
        return mission
    if world not in worlds:
        raise UsageError(f"--world {world}: there is no such world; there are: {', '.join(sorted(worlds))}")
    return dataclasses.replace(mission, scenario=dataclasses.replace(mission.scenario, world=world))


def with_map(mission: Mission, knowledge: Optional[MapKnowledge]) -> Mission:
    """Let all robots know the map from the start, or none.

    Args:
        mission: the whole.
        knowledge: of the map; None for what the scenario says of each robot.

    Raises:
        UsageError: a robot that shall map has not the sensors for it.
    """
    if knowledge is None or mission.scenario is None:
        return mission
    for robot in mission.scenario.robots if knowledge is MapKnowledge.UNKNOWN else ():
        missing = [topic for topic in MAPPED_TOPICS if all(sensor.topic != topic for sensor in robot.sensors)]
        if missing:
            raise UsageError(
                f"--map {knowledge.value}: {robot.id} has no sensor on the topic {' nor on '.join(missing)}, by which "
                f"it could map; give it sensors on {' and '.join(MAPPED_TOPICS)}, or let the map be "
                f"{MapKnowledge.KNOWN.value}"
            )
    robots = tuple(dataclasses.replace(robot, map=knowledge) for robot in mission.scenario.robots)
    return dataclasses.replace(mission, scenario=dataclasses.replace(mission.scenario, robots=robots))


def _without_strangers(event: ScenarioEvent, kept: FrozenSet[str]) -> ScenarioEvent:
    """Take robots that are left out from the groups of a partition."""
    if event.kind is not ScenarioEventKind.RADIO_PARTITIONS:
        return event
    groups = [[name for name in group if name in kept] for group in event.parameters["groups"]]
    return dataclasses.replace(event, parameters={**event.parameters, "groups": [group for group in groups if group]})
