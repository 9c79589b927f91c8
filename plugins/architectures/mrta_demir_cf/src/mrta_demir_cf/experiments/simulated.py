"""Missions of simulated robots, and what is measured of each."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Dict, List, Mapping, Optional, Sequence

from team_measures.statistics.estimates import Estimate, estimated_mean
from team_measures.statistics.tables import estimate_text

from rqt_mrta_py.hooks import Trial
from rqt_mrta_py.model import TaskState

__all__ = ["COLUMNS", "SimulatedMission", "estimates", "row", "summed_up"]

_SIGNS_OF_LIFE = "demir_cf_msgs/Hello"
_FOR_WATCHERS = "demir_cf_msgs/Beliefs"
_PACKAGE = "demir_cf_msgs/"
_UNACHIEVABLE = "demir_cf_msgs/Unachievability"

COLUMNS = ("missions", "all visited", "path [m]", "messages", "reallocations", "found unreachable", "time [s]")


@dataclass(frozen=True)
class SimulatedMission:
    """What one mission came to.

    Attributes:
        visited: how many targets were visited.
        wanted: how many should have been.
        time: when the last of them was visited, since the beginning [s].
        path: of all robots together [m].
        messages: that robots said to one another, without signs of life.
        reallocations: how often a target went to another robot.
        unreachable: how often a target was announced as one that cannot be reached.
    """

    visited: int
    wanted: int
    time: float
    path: float
    messages: int
    reallocations: int
    unreachable: int


def summed_up(trial: Trial, wanted: int) -> SimulatedMission:
    """Sum a mission up.

    Args:
        trial: that was carried out.
        wanted: how many targets can be reached.
    """
    record = trial.record
    done = [task.history[-1].start for task in record.tasks if task.state is TaskState.DONE]
    said = {name: count for name, count in trial.messages.items() if name.startswith(_PACKAGE)}
    travel: Mapping[str, Any] = record.statistics.get("travel") or {}
    return SimulatedMission(
        visited=len(done),
        wanted=wanted,
        time=max(done, default=0.0) - (record.start or 0.0),
        path=float(travel.get("team", 0.0)),
        messages=sum(count for name, count in said.items() if name not in {_SIGNS_OF_LIFE, _FOR_WATCHERS}),
        reallocations=int(record.statistics.get("reallocations", 0)),
        unreachable=said.get(_UNACHIEVABLE, 0),
    )


def estimates(missions: Sequence[SimulatedMission]) -> Dict[str, Optional[Estimate]]:
    """Estimate path, messages, reallocations, announcements and time, by name; the time of complete missions."""
    complete = [mission for mission in missions if mission.visited >= mission.wanted]
    return {
        "path": estimated_mean([mission.path for mission in missions]),
        "messages": estimated_mean([float(mission.messages) for mission in missions]),
        "reallocations": estimated_mean([float(mission.reallocations) for mission in missions]),
        "unreachable": estimated_mean([float(mission.unreachable) for mission in missions]),
        "time": estimated_mean([mission.time for mission in complete]),
    }


def row(missions: Sequence[SimulatedMission]) -> List[Any]:
    """Give the cells below ``COLUMNS``."""
    known = estimates(missions)
    complete = sum(mission.visited >= mission.wanted for mission in missions)
    digits = {"path": 1, "messages": 0, "reallocations": 2, "unreachable": 2, "time": 0}
    texts = [estimate_text(known[name], places) for name, places in digits.items()]
    return [len(missions), f"{complete} of {len(missions)}", *texts]
