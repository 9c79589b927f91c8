"""Who is lost when: robots stopped for good at random moments, from a seed."""

from __future__ import annotations

import random
from typing import Sequence, Tuple

from rqt_mrta_py.model import ScenarioEvent, ScenarioEventKind

__all__ = ["alone", "random_stops"]


def random_stops(robots: Sequence[str], number: int, latest: float, seed: int) -> Tuple[ScenarioEvent, ...]:
    """Stop some of a team, each at a moment of its own.

    Args:
        robots: ids of the team.
        number: how many are stopped; those stopped for a smaller number and the same seed are among them.
        latest: moments are evenly distributed from 0 to this one [s].
        seed: of the choice.
    """
    chance = random.Random(f"stops {seed}")
    order = list(robots)
    chance.shuffle(order)
    moments = [round(chance.uniform(0.0, latest), 3) for _ in order]
    stops = [
        ScenarioEvent(moment, ScenarioEventKind.ROBOT_STOPS, robot)
        for robot, moment in list(zip(order, moments))[:number]
    ]
    return tuple(sorted(stops, key=lambda event: (event.time, event.robot or "")))


def alone(robots: Sequence[str], robot: str) -> Tuple[ScenarioEvent, ...]:
    """Stop everybody but one robot before anything begins."""
    return tuple(ScenarioEvent(0.0, ScenarioEventKind.ROBOT_STOPS, other) for other in robots if other != robot)
