"""How fast ALLIANCE shares out tasks when all is well, from the parameters of its robots."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Iterator, Mapping, Tuple

from mrta_alliance.parameters import AllianceParameters, BehaviourSetParameters
from mrta_alliance.reading import read_parameters
from rqt_mrta_py.hooks import AllocationPace, ParameterRangeError
from rqt_mrta_py.model import Mission

__all__ = ["alliance_pace", "slowest_uptake"]

_CYCLES = 3
"""A robot hears what was said a cycle later, takes its decision and tells it in the next one."""

_GENEROUS = 2.0
"""An idle robot may first be reset by another that begins, and begin again."""


def alliance_pace(mission: Mission, usual: AllocationPace) -> AllocationPace:
    """Give the pace of a mission.

    psi is what ``yielding`` is; a free robot takes up a task within tau + threshold / (fast rate x spin rate) of the
    last announcement; what robots announce as expected duration is theirs, and is exceeded where they hold the task for
    longer.

    Args:
        mission: robots without parameters, as of a foreign bag, count as having the defaults.
        usual: as timeouts of monitored topics tell.
    """
    robots = dict(_parameters(mission))
    known = list(robots.values()) or [_DEFAULTS]
    sets = [(told, each) for told in known for each in told.behaviour_sets]
    periods = [1.0 / told.broadcast_rate + _CYCLES / told.spin_rate for told in known]
    delays = [min(each.yielding_delay, each.giving_up_delay) for _, each in sets]
    return replace(
        usual,
        handover=usual.handover + max(periods),
        yielding=max(delays),
        uptake=_GENEROUS * max(slowest_uptake(told, each) for told, each in sets),
        brief=min(usual.brief, 0.9 * min(each.giving_up_delay for _, each in sets)),
        overrun=1.0,
        durations={
            (robot, each.task_id): each.task_expected_duration
            for robot, told in robots.items()
            for each in told.behaviour_sets
        },
    )


def slowest_uptake(told: AllianceParameters, behaviour_set: BehaviourSetParameters) -> float:
    """Say how long a free robot takes at most to take up a task that nobody announces any more [s].

    Args:
        told: to the robot; by ``strict_original`` it believes in others for two tau.
        behaviour_set: of the task.
    """
    silence = told.timeout_duration * (2.0 if told.strict_original else 1.0)
    growth = behaviour_set.threshold / (behaviour_set.fast_rate * told.spin_rate)
    return silence + growth + 1.0 / told.broadcast_rate + _CYCLES / told.spin_rate


def _parameters(mission: Mission) -> Iterator[Tuple[str, AllianceParameters]]:
    for robot in mission.application.robots:
        nested: Mapping[str, Any] = mission.parameters.get(robot.id, {})
        tasks = [task.id for task in (*mission.tasks_of(robot.id), *mission.later_tasks_of(robot.id))]
        try:
            told = read_parameters(nested, tasks)
        except ParameterRangeError:
            continue
        if told.behaviour_sets:
            yield robot.id, told


_DEFAULTS = AllianceParameters(behaviour_sets=(BehaviourSetParameters("any"),))
