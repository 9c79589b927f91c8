"""Everything that keeps a scenario from being simulated, all at once; no world is built and nothing moves."""

from __future__ import annotations

import dataclasses
from functools import partial
from typing import TYPE_CHECKING, Callable, Iterator, List, Mapping, Optional, Sequence

from rqt_mrta_py.errors import MissingDependencyError, SimError
from rqt_mrta_py.hooks import (
    LinkFactory,
    PlacedRobot,
    RobotModel,
    SensorFactory,
    TeamSensorFactory,
    WorldFactory,
    WorldSetup,
)
from rqt_mrta_py.model import Pose, ScenarioSpec
from rqt_mrta_py.sim.body_placement import body_problems
from rqt_mrta_py.sim.placement import placement_problems
from rqt_mrta_py.sim.radio import LinkRandom, build_links
from rqt_mrta_py.sim.requirements import blind_sensors, missing_capabilities, missing_links, missing_names
from rqt_mrta_py.sim.scenario_events import in_order
from rqt_mrta_py.sim.sensing import Sensing
from rqt_mrta_py.sim.world_answers import capabilities_of
from rqt_mrta_py.sim.world_checks import check_ids

if TYPE_CHECKING:
    import numpy as np

__all__ = ["scenario_problems"]


def scenario_problems(
    scenario: ScenarioSpec,
    *,
    models: Mapping[str, RobotModel],
    sensors: Mapping[str, SensorFactory],
    team_sensors: Mapping[str, TeamSensorFactory],
    worlds: Mapping[str, WorldFactory],
    links: Mapping[str, LinkFactory],
    generators: Mapping[str, np.random.Generator],
    link_random: LinkRandom,
) -> Sequence[str]:
    """Find what a ``Simulation`` of a scenario would refuse, in the same words; what one thing hides is left out.

    Args:
        scenario: its events are sound.
        models: robot models by name.
        sensors: factories of sensors of one robot by kind.
        team_sensors: factories of sensors of many robots by kind.
        worlds: world factories by name.
        links: link factories by kind of radio.
        generators: one for each robot's sensors, by robot id.
        link_random: makes the generator of one sender and one receiver.

    Returns:
        One line for each problem, which begins with what it speaks of, such as ``robot robot1``.
    """
    kinds = {**team_sensors, **sensors}
    found = [*missing_names(scenario, models, kinds, worlds), *missing_links(scenario, links)]
    known = _known_part(scenario, models, kinds)
    placed = tuple(PlacedRobot(robot.id, models[robot.model], robot.start) for robot in known.robots)
    ground = (known.arena, known.obstacles, placed)
    found.extend(placement_problems(*ground) or body_problems(known.bodies, *ground, known.dispensers))
    found.extend(_raised(lambda: check_ids(WorldSetup(known.arena, known.obstacles, placed, 1.0))))
    mounted: List[Sensing] = []
    found.extend(_raised(lambda: mounted.append(Sensing(known, models, sensors, team_sensors, generators))))
    if not list(missing_links(scenario, links)):
        found.extend(_raised(partial(build_links, scenario, in_order(scenario), links, _nowhere, link_random)))
    if scenario.world in worlds:
        found.extend(_lacks_of_world(known, worlds[scenario.world], models, mounted))
    return tuple(dict.fromkeys(found))


def _known_part(scenario: ScenarioSpec, models: Mapping[str, RobotModel], kinds: Mapping[str, object]) -> ScenarioSpec:
    """Leave out robots of unknown models, and sensors of unknown kinds."""
    robots = tuple(
        dataclasses.replace(robot, sensors=tuple(sensor for sensor in robot.sensors if sensor.kind in kinds))
        for robot in scenario.robots
        if robot.model in models
    )
    return dataclasses.replace(scenario, robots=robots)


def _lacks_of_world(
    scenario: ScenarioSpec, factory: WorldFactory, models: Mapping[str, RobotModel], mounted: Sequence[Sensing]
) -> Iterator[str]:
    try:
        world = factory()
    except MissingDependencyError:
        # Not the scenario's fault, and told when it is run.
        return
    try:
        capabilities = capabilities_of(scenario.world, world)
    except SimError as error:
        yield str(error)
        return
    finally:
        world.close()
    yield from missing_capabilities(scenario, models, capabilities)
    for sensing in mounted:
        yield from blind_sensors(scenario, sensing.mounts, capabilities)


def _raised(step: Callable[[], object]) -> List[str]:
    """Take a step; give the lines of what it raises."""
    try:
        step()
    except SimError as error:
        return str(error).splitlines()
    return []


def _nowhere(_robot: str) -> Optional[Pose]:
    return None
