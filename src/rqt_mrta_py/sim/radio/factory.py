"""Builds all links of a scenario before anything happens, so that wrong parameters are told in time."""

from __future__ import annotations

from typing import TYPE_CHECKING, Callable, Dict, List, Mapping, NamedTuple, Optional, Sequence, Tuple

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.hooks import Link, LinkFactory, LinkSetup
from rqt_mrta_py.model import Pose, RadioSetup, ScenarioEvent, ScenarioEventKind, ScenarioSpec

if TYPE_CHECKING:
    import numpy as np

__all__ = ["LinkRandom", "Links", "build_links", "radio_of"]

LinkRandom = Callable[[str, str], "np.random.Generator"]
"""From the ids of a sender and a receiver to a new generator, equal for equal ids."""


class Links(NamedTuple):
    """The links of a scenario.

    Attributes:
        first: at the start.
        later: one for each change, in the order in which they come.
    """

    first: Link
    later: Tuple[Link, ...]


def build_links(
    scenario: ScenarioSpec,
    events: Sequence[ScenarioEvent],
    factories: Mapping[str, LinkFactory],
    pose: Callable[[str], Optional[Pose]],
    random: LinkRandom,
) -> Links:
    """Make the links that a scenario names.

    Args:
        scenario: all kinds of radio that it names are among the factories.
        events: those of the scenario, in the order in which they happen.
        factories: by kind.
        pose: true pose of a robot now; asked from the first delivery on.
        random: asked once for each pair that needs chance; a later link goes on where an earlier one stopped.

    Raises:
        SimError: a link cannot work with its parameters; one line for each problem.
    """
    robots = tuple(robot.id for robot in scenario.robots)
    generators: Dict[Tuple[str, str], np.random.Generator] = {}

    def remembered(sender: str, receiver: str) -> np.random.Generator:
        pair = (sender, receiver)
        if pair not in generators:
            generators[pair] = random(sender, receiver)
        return generators[pair]

    problems: List[str] = []

    def build(radio: RadioSetup, where: str) -> Optional[Link]:
        try:
            return factories[radio.kind](LinkSetup(robots, radio.parameters, pose, remembered))
        except SimError as error:
            problems.extend(f"{where}: {line}" for line in str(error).splitlines())
            return None

    first = build(scenario.radio, f"radio {scenario.radio.kind}")
    changes = [event for event in events if event.kind is ScenarioEventKind.RADIO_CHANGES]
    later = [build(radio_of(event), f"event {event.kind.value} at {event.time:g} s") for event in changes]
    if first is None or problems:
        raise SimError("\n".join(problems))
    return Links(first, tuple(link for link in later if link is not None))


def radio_of(event: ScenarioEvent) -> RadioSetup:
    """Read the radio that a change asks for."""
    further = {name: value for name, value in event.parameters.items() if name != "kind"}
    return RadioSetup(event.parameters["kind"], further)
