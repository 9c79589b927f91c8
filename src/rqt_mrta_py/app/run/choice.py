"""Which mission the user asks for, and loading it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Mapping, Optional, Tuple

from rqt_mrta_py.app.compose import Host
from rqt_mrta_py.app.making import making_of
from rqt_mrta_py.app.selection import first_robots, in_world, with_map
from rqt_mrta_py.config.mission import load_mission
from rqt_mrta_py.config.parameters.layers import Layer
from rqt_mrta_py.errors import UsageError
from rqt_mrta_py.model import MapKnowledge, Mission, ScenarioSpec

__all__ = ["MissionChoice", "chosen_mission"]


@dataclass(frozen=True)
class MissionChoice:
    """Which mission the user asks for.

    Attributes:
        application: a registered name, or the path of a package or rqt_mrta.xml.
        architecture: a registered name; None for the application's own.
        seed: of every random generator.
        robots: how many of the application's robots; None for as many as its files are made for, mostly all.
        world: where to simulate; None for the scenario's.
        map: whether robots know it from the start; None for what the scenario says of each.
        overrides: ``path=value`` of parameters, each path beginning with a robot's id; ``name=value`` of settings that
            the application's maker of missions has.
    """

    application: str
    architecture: Optional[str] = None
    seed: int = 0
    robots: Optional[int] = None
    world: Optional[str] = None
    map: Optional[MapKnowledge] = None
    overrides: Tuple[str, ...] = ()


def chosen_mission(
    host: Host, choice: MissionChoice, served: Optional[Mapping[str, Layer]] = None
) -> Tuple[Mission, ScenarioSpec]:
    """Load the mission that the user asks for.

    Args:
        host: registry and plugins.
        choice: of the user.
        served: parameters by robot that cover those of files, as a parameter server gives them.

    Returns:
        The mission and its scenario.

    Raises:
        MrtaError: of whatever is wrong.
    """
    making = making_of(host, choice.application, choice.overrides, choice.robots)
    mission = load_mission(
        host.registry,
        choice.application,
        architecture=choice.architecture,
        seed=choice.seed,
        overrides=making.overrides,
        served=served,
        checks=host.manager,
        kinds=host.manager.registered("mrta_register_behaviours"),
        rewrite=making.rewrite,
    )
    worlds = host.manager.registered("mrta_register_worlds")
    mission = with_map(in_world(first_robots(mission, making.robots), choice.world, worlds), choice.map)
    if mission.scenario is None:
        raise UsageError(
            f"{mission.application.package}: has no scenario, so there is nothing to simulate; "
            'name one in its package.xml: <rqt_mrta_py scenario="${prefix}/scenario.yaml"/>'
        )
    return mission, mission.scenario
