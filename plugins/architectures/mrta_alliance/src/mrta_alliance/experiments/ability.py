"""Who can carry out what: what each robot carries out when it is left alone."""

from __future__ import annotations

from dataclasses import replace
from typing import Dict, FrozenSet, Iterable, Sequence

from mrta_alliance.experiments.measures import done_tasks
from mrta_alliance.experiments.stops import alone
from rqt_mrta_py.hooks import Experiment, Laboratory

__all__ = ["abilities", "within_reach"]


def abilities(laboratory: Laboratory, base: Experiment, robots: Sequence[str]) -> Dict[str, FrozenSet[str]]:
    """Find out which tasks each robot carries out alone, without knowing what tasks ask for.

    Args:
        laboratory: carries the missions out, one for each robot.
        base: the mission with the whole team.
        robots: ids of the team.
    """
    trials = laboratory.trials([replace(base, events=alone(robots, robot)) for robot in robots])
    return {robot: done_tasks(trial.record) for robot, trial in zip(robots, trials)}


def within_reach(able: Dict[str, FrozenSet[str]], survivors: Iterable[str]) -> FrozenSet[str]:
    """List the tasks that at least one of those left alive carries out alone: these must be carried out."""
    return frozenset().union(*(able[robot] for robot in survivors))
