"""Part ``cost``: messages and processor time of a team, by robots and behaviour sets."""

from __future__ import annotations

from typing import Any, Dict, List, Mapping, Tuple

from mrta_alliance.experiments.part import Options
from rqt_mrta_py.hooks import (
    BenchmarkReport,
    BenchmarkTable,
    Chart,
    Figure,
    IdleTeam,
    Laboratory,
    Line,
    LineStyle,
    TeamCost,
)

__all__ = ["idle_team", "measure_cost"]

_SPIN_RATE = 10
"""Of agents, and of control [Hz]."""

_REQUIRED = 5.0
"""What is asked of 100 robots with 100 behaviour sets each: mission seconds a second of processor time [1]."""

_ROBOTS = (10, 30, 100)
_SETS = (10, 30, 100)
_DURATION = 10.0
_WARM_UP = 4.0
"""In which every robot takes up a task and begins to announce it [s]."""

_FEW_ROBOTS = (3,)
_FEW_SETS = (4, 20)
_SHORT_DURATION = 1.0


def measure_cost(options: Options, laboratory: Laboratory) -> BenchmarkReport:
    """Measure teams of which every robot has a behaviour set for every task, and carries out one of them."""
    sizes = [
        (robots, sets)
        for robots in (_FEW_ROBOTS if options.quick else _ROBOTS)
        for sets in (_FEW_SETS if options.quick else _SETS)
    ]
    duration = _SHORT_DURATION if options.quick else _DURATION
    costs = dict(zip(sizes, laboratory.costs([idle_team(robots, sets, duration) for robots, sets in sizes])))
    rows: List[Tuple[Any, ...]] = []
    for (robots, sets), cost in costs.items():
        share = robots * duration
        messages = sum(cost.messages.values()) / share
        rows.append((robots, sets, round(messages, 1), round(_milliseconds(cost), 2), round(_speed(cost), 1)))
    table = BenchmarkTable(
        "What ALLIANCE costs: agents and their hosts on one bus, in one process",
        (
            "robots",
            "behaviour sets of each",
            "messages / robot and s",
            "CPU ms / robot and s",
            "mission s / CPU s",
        ),
        tuple(rows),
        (
            f"{_SPIN_RATE} Hz, 2 announcements a second; {duration:g} s after {_WARM_UP:g} s in which everybody takes "
            "up a task. Behaviours are always applicable and do nothing.",
            "Every robot hears every announcement. Nobody records or supervises: motivations, times to activation and "
            "sensory feedback are made but not serialised.",
        ),
    )
    return BenchmarkReport((table,), (_figure(costs),))


def idle_team(robots: int, sets: int, duration: float) -> IdleTeam:
    """Make a team in which each robot soon takes up a task of its own, as far as there are enough.

    Args:
        robots: number of them.
        sets: number of tasks, each a behaviour set of each robot.
        duration: that is measured [s].
    """
    tasks = tuple(f"task{number}" for number in range(sets))
    parameters = {f"robot{place}": _parameters(place, tasks) for place in range(robots)}
    return IdleTeam("mrta_alliance", parameters, tasks, duration, _WARM_UP, _SPIN_RATE)


def _parameters(place: int, tasks: Tuple[str, ...]) -> Dict[str, Any]:
    sets = {
        f"behaviour_set{index}": {
            "task_id": task,
            "task_expected_duration": 600.0,
            "motivational_behaviour": {
                "threshold": 30.0,
                "acquiescence": {"yielding_delay": 20.0, "giving_up_delay": 300.0},
                "impatience": {"fast_rate": 3.0 if index == place % len(tasks) else 0.3},
            },
        }
        for index, task in enumerate(tasks)
    }
    rates = {"spin_rate": float(_SPIN_RATE), "broadcast_rate": 2.0, "timeout_duration": 3.0, "buffer_horizon": 10.0}
    return {**rates, "behaviour_sets": {"size": len(tasks), **sets}}


def _milliseconds(cost: TeamCost) -> float:
    return 1e3 * cost.processor_time / (len(cost.team.parameters) * cost.team.duration)


def _speed(cost: TeamCost) -> float:
    return cost.team.duration / cost.processor_time


def _figure(costs: Mapping[Tuple[int, int], TeamCost]) -> Figure:
    teams: Dict[int, List[Tuple[int, TeamCost]]] = {}
    for (robots, sets), cost in costs.items():
        teams.setdefault(robots, []).append((sets, cost))
    spent, speed = [], []
    for robots, found in teams.items():
        x = tuple(float(sets) for sets, _ in found)
        label = f"{robots} robots"
        spent.append(Line(label, x, tuple(_milliseconds(cost) for _, cost in found), style=LineStyle.POINTS))
        speed.append(Line(label, x, tuple(_speed(cost) for _, cost in found), style=LineStyle.POINTS))
    ends = min(sets for _, sets in costs), max(sets for _, sets in costs)
    asked = Line("asked for", tuple(map(float, ends)), (_REQUIRED,) * 2, style=LineStyle.DASHED, colour=Line.REFERENCE)
    return Figure(
        "alliance_cost",
        "What ALLIANCE costs",
        "behaviour sets of each robot",
        (
            Chart(tuple(spent), "CPU time per robot and second [ms]", bottom=0.0),
            Chart((*speed, asked), "mission s / CPU s", bottom=0.0),
        ),
    )
