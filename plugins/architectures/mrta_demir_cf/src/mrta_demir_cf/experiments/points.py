"""Missions of points on message level, as the second experiment of the paper has them: 5 m x 5 m, ten targets."""

from __future__ import annotations

from typing import Any, Dict, List, Mapping, Optional, Sequence

import numpy as np
from team_measures.statistics.estimates import Estimate, estimated_mean
from team_measures.statistics.tables import MEANS, estimate_text

from mrta_demir_cf.experiments.point_team import Mission, PointTeam, random_places
from rqt_mrta_py.hooks import BenchmarkTable

__all__ = ["COLUMNS", "NOTES", "carry_out", "estimates", "random_team", "row", "table"]

SIDE = 5.0
"""Of the arena [m]."""
SPEED = 0.1
"""Of every robot [m/s]."""
LONGEST = 1500.0
"""What a mission lasts at most [s]."""

COLUMNS = ("missions", "all visited", "path [m]", "messages", "duplicates", "time [s]")
NOTES = (
    f"{SIDE:g} m x {SIDE:g} m, robots and targets strewn evenly, {SPEED:g} m/s straight on; all move at a time.",
    "Messages without signs of life; duplicates are visits beyond the first; time until the last target is visited.",
    MEANS,
)


def random_team(
    robots: int,
    seed: int,
    targets: int = 10,
    *,
    loss: float = 0.0,
    parameters: Optional[Mapping[str, Any]] = None,
    later: Sequence[int] = (),
) -> PointTeam:
    """Strew robots and targets.

    Robots do not wait for what others request: all move at a time.

    Args:
        robots: how many.
        seed: of places and of what is lost.
        targets: how many.
        loss: which share of messages does not reach a receiver [1].
        parameters: of every agent, beside the defaults.
        later: numbers of targets that are not there from the start.
    """
    places = np.random.default_rng([robots, seed])
    starts = {f"r{number}": place for number, place in enumerate(random_places(robots, SIDE, places))}
    goals = {f"t{number:02d}": place for number, place in enumerate(random_places(targets, SIDE, places))}
    told: Dict[str, Any] = {"gives_way": False, **(parameters or {})}
    missing = [f"t{number:02d}" for number in later]
    return PointTeam(starts, goals, seed=seed, loss=loss, speed=SPEED, parameters=told, later=missing)


def carry_out(team: PointTeam, lost: Optional[str] = None) -> Mission:
    """Let a team visit its targets.

    Args:
        team: at its start.
        lost: a robot that stops for good a cycle after half of the targets have been visited; None for none.
    """
    if lost is not None:
        team.run(LONGEST, until_visited=len(team.targets) // 2)
        team.step()
        team.stopped.add(lost)
    return team.run(LONGEST)


def estimates(missions: Sequence[Mission]) -> Dict[str, Optional[Estimate]]:
    """Estimate path, messages, duplicates and time, by name; the time of those missions in which all was visited."""
    ended = [mission for mission in missions if mission.time < LONGEST]
    return {
        "path": estimated_mean([mission.path for mission in missions]),
        "messages": estimated_mean([float(mission.message_count) for mission in missions]),
        "duplicates": estimated_mean([float(mission.duplicates) for mission in missions]),
        "time": estimated_mean([mission.time for mission in ended]),
    }


def row(missions: Sequence[Mission]) -> List[Any]:
    """Give the cells below ``COLUMNS``."""
    known = estimates(missions)
    complete = sum(mission.time < LONGEST for mission in missions)
    texts = [estimate_text(known["path"], 1), estimate_text(known["messages"], 0)]
    texts += [estimate_text(known["duplicates"], 2), estimate_text(known["time"], 0)]
    return [len(missions), f"{complete} of {len(missions)}", *texts]


def table(title: str, heads: Sequence[str], rows: Sequence[Sequence[Any]], notes: Sequence[str] = ()) -> BenchmarkTable:
    """Make a table of missions.

    Args:
        title: of it.
        heads: of the columns before ``COLUMNS``.
        rows: cells, those of ``row`` last.
        notes: before those that hold for all.
    """
    return BenchmarkTable(title, (*heads, *COLUMNS), tuple(map(tuple, rows)), (*notes, *NOTES))
