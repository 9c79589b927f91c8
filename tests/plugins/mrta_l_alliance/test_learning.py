"""Ten training missions, and what they are worth; missions without a world."""

from __future__ import annotations

import statistics
from typing import Dict, List

import pytest
from mrta_l_alliance.memory import Memory

from tests.plugins.mrta_l_alliance.errands import (
    ErrandMission,
    Errands,
    behaviour_sets,
    heterogeneous,
    learning,
    trained,
)


def by_hand(errands: Errands, robot: str) -> Dict[str, float]:
    """Give fast rates as somebody would who knows: 1 s for what the robot is best at, 24 s for the rest."""
    best = {task: min(errands.starts, key=lambda each: errands.work[each, task]) for task in errands.places}
    return {task: 6.0 if best[task] == robot else 0.25 for task in errands.places}


def times(errands: Errands, memory: Memory, seed: int) -> List[float]:
    """Give how long a mission takes under untuned ALLIANCE, ALLIANCE tuned by hand, and L-ALLIANCE [s]."""
    names = list(errands.places)
    teams = [
        {robot: behaviour_sets(names) for robot in errands.starts},
        {robot: behaviour_sets(names, by_hand(errands, robot)) for robot in errands.starts},
        {robot: {**behaviour_sets(names), **learning("adaptive", memory)} for robot in errands.starts},
    ]
    return [ErrandMission(errands, team, seed).run() for team in teams]


@pytest.fixture(scope="module")
def errands() -> Errands:
    return heterogeneous(2, 4, 3.0)


@pytest.fixture(scope="module")
def memory(errands: Errands) -> Memory:
    return trained(errands, 5, 1)


def test_every_robot_tries_every_task_in_training(errands: Errands, memory: Memory) -> None:
    """Each mission teaches one time of each task."""
    attempts = [memory.of(robot, task).attempts for robot in errands.starts for task in errands.places]
    assert min(attempts) >= 1
    assert sum(attempts) == 5 * 4


def test_training_pays(errands: Errands, memory: Memory) -> None:
    """A tenth faster than untuned, and no more than a twentieth slower than by hand."""
    untuned, tuned, learned = times(errands, memory, 1)
    assert learned <= 0.9 * untuned
    assert learned <= 1.05 * tuned


@pytest.mark.long
@pytest.mark.parametrize("clumsiness", [1.5, 2.0, 4.0])
def test_ten_training_missions_pay_on_average(clumsiness: float) -> None:
    errands = heterogeneous(3, 9, clumsiness)
    rows = [times(errands, trained(errands, 10, seed), seed) for seed in range(10)]
    untuned, tuned, learned = (statistics.mean(column) for column in zip(*rows))
    assert learned <= 0.9 * untuned
    assert learned <= 1.05 * tuned
