"""What a fault is, and what it is to strike."""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import Enum
from typing import Callable, NamedTuple, Optional, Tuple

import numpy as np

from rqt_mrta_py.app.bench.incidents.calm import CalmMission
from rqt_mrta_py.app.bench.incidents.label import Allowance, Label
from rqt_mrta_py.app.bench.incidents.yards import YardKind
from rqt_mrta_py.hooks import AgentChange, Experiment
from rqt_mrta_py.model import ScenarioEvent, ScenarioEventKind

__all__ = ["Fault", "Place", "Strike", "event", "pick"]


class Place(Enum):
    """Where something goes wrong: in the world, on the radio, with the clocks, or in what robots say."""

    WORLD = "world"
    RADIO = "radio"
    CLOCKS = "clocks"
    WIRE = "wire"


@dataclass(frozen=True)
class Strike:
    """What a fault does to one mission.

    Attributes:
        labels: what must be found of it.
        events: that happen besides the scenario's.
        agents: what becomes of agents.
        allowances: what may be found of it besides.
    """

    labels: Tuple[Label, ...]
    events: Tuple[ScenarioEvent, ...] = ()
    agents: Optional[AgentChange] = None
    allowances: Tuple[Allowance, ...] = ()

    def applied(self, experiment: Experiment) -> Experiment:
        """Make the mission with the fault from the one without."""
        return replace(experiment, events=(*(experiment.events or ()), *self.events), agents=self.agents)


Striking = Callable[[CalmMission, np.random.Generator], Optional[Strike]]
"""From a mission and chance to what happens in it; None where the mission offers nothing that it could happen to."""


class Fault(NamedTuple):
    """Something that can go wrong.

    Attributes:
        name: of it.
        place: where.
        rules: that must find it.
        text: what happens, in a few words.
        kind: of the yards where it strikes.
        architectures: of the missions in which it strikes.
        strike: decides when, whom and how much.
    """

    name: str
    place: Place
    rules: Tuple[str, ...]
    text: str
    kind: YardKind
    architectures: Tuple[str, ...]
    strike: Striking


def event(stamp: float, kind: ScenarioEventKind, robot: Optional[str] = None, **parameters: object) -> ScenarioEvent:
    """Make something that happens to a robot, or to nobody in particular, at a stamp [s]."""
    return ScenarioEvent(stamp - 1.0, kind, robot=robot, parameters=parameters)


def pick(random: np.random.Generator, low: float, high: float) -> float:
    """Draw a time or amount, in steps of 0.01."""
    return round(float(random.uniform(low, high)), 2)
