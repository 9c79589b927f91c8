"""Sensors of several robots that are set up alike, so that they can measure in one go."""

from __future__ import annotations

from collections import Counter
from operator import itemgetter
from typing import Dict, List, NamedTuple, Sequence, Tuple

from rqt_mrta_py.model import RobotSetup, SensorSetup

__all__ = ["Alike", "alike_sensors"]

_Key = Tuple[str, str, str, str]


class Alike(NamedTuple):
    """Sensors that are set up alike, one a robot.

    Attributes:
        setup: of each of them.
        robots: places of their robots in the scenario, rising.
    """

    setup: SensorSetup
    robots: Sequence[int]


def alike_sensors(robots: Sequence[RobotSetup]) -> List[Alike]:
    """Group the sensors of a team by kind, topic, rate and parameters.

    The order of groups depends on nothing but these, so that of one robot the sensors measure, and draw their chance,
    in the same order whatever other robots there are. A robot that carries two alike has them in two groups.

    Args:
        robots: of the scenario, in its order.

    Returns:
        The groups, sorted.
    """
    groups: Dict[Tuple[_Key, int], Tuple[SensorSetup, List[int]]] = {}
    for place, robot in enumerate(robots):
        seen: Counter[_Key] = Counter()
        for setup in robot.sensors:
            key = _key_of(setup)
            groups.setdefault((key, seen[key]), (setup, []))[1].append(place)
            seen[key] += 1
    return [Alike(*group) for _, group in sorted(groups.items(), key=itemgetter(0))]


def _key_of(setup: SensorSetup) -> _Key:
    parameters = sorted(f"{name!r}: {value!r}" for name, value in setup.parameters.items())
    return setup.kind, setup.topic, repr(setup.rate), ", ".join(parameters)
