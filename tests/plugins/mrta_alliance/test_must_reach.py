"""What a team reaches on every run without message loss, whatever its parameters and whoever fails when."""

from __future__ import annotations

import itertools
from typing import Any, Dict, List, NamedTuple, Sequence, Tuple

from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.hooks import TaskReport
from rqt_mrta_py.model import Progress
from tests.plugins.mrta_alliance.team import CYCLE, SPIN_RATE, Team, agent, announcements, nested, time_of

TASKS = ("patrol", "inspect", "report")
THRESHOLD = 30.0


class Kind(NamedTuple):
    """Parameters of one robot.

    Attributes:
        fast_rates: by task, as in TASKS.
        patience: by how much the expected duration exceeds threshold / fast rate, at least 1.
        yielding_delay, giving_up_delay, timeout: psi, lambda, tau [s].
        broadcast_rate: [Hz].
    """

    fast_rates: Tuple[float, ...]
    patience: float
    yielding_delay: float
    giving_up_delay: float
    timeout: float
    broadcast_rate: float

    @property
    def period(self) -> float:
        """Give the period of announcements: cycles have to meet it [s]."""
        return max(1.0 / self.broadcast_rate, CYCLE)

    def nested(self, tasks: Sequence[str]) -> Dict[str, Any]:
        sets = [
            {
                "task_id": task,
                "task_expected_duration": self.patience * THRESHOLD / rate,
                "motivational_behaviour": {
                    "threshold": THRESHOLD,
                    "acquiescence": {"yielding_delay": self.yielding_delay, "giving_up_delay": self.giving_up_delay},
                    "impatience": {"fast_rate": rate},
                },
            }
            for task, rate in zip(tasks, self.fast_rates)
        ]
        rates = {"broadcast_rate": self.broadcast_rate, "timeout_duration": self.timeout}
        return nested(*sets, buffer_horizon=self.timeout + 5.0, **rates)


def kind(values: Tuple[Any, ...]) -> Kind:
    rates, patience, yielding, giving_up, slack, broadcast = values
    period = max(1.0 / broadcast, CYCLE)
    return Kind(rates, patience, yielding, giving_up, period + CYCLE + slack, broadcast)


kinds = st.tuples(
    st.tuples(*[st.floats(0.7, 8.0)] * len(TASKS)),
    st.floats(1.1, 20.0),
    st.floats(0.0, 10.0),
    st.floats(3.0, 60.0),
    st.floats(0.05, 4.0),
    st.sampled_from([1.0, 1.3, 2.0, 5.0, 12.0]),
).map(kind)
teams = st.lists(kinds, min_size=2, max_size=4)
losses = st.lists(st.tuples(st.integers(1, 150), st.integers(0, 3)), max_size=3)
"""Who is lost in which cycle; robots that there are not stay out of it."""

CYCLES = 200


def made(team: Sequence[Kind], tasks: Sequence[str]) -> Team:
    names = [f"robot{index}" for index in range(len(team))]
    return Team({name: agent(name, each.nested(tasks), tasks) for name, each in zip(names, team)}, tasks)


def lose(team: Team, plan: Sequence[Tuple[int, int]]) -> None:
    for cycle, index in plan:
        robot = f"robot{index}"
        others = [each for each in team.agents if each != robot and each not in team.stopped]
        if cycle == team.cycle + 1 and robot in team.agents and others:
            team.stopped.append(robot)


@settings(max_examples=15, deadline=None)
@given(teams, losses, st.integers(1, len(TASKS)))
def test_a_free_robot_takes_over_in_time(kinds_of: List[Kind], plan: List[Tuple[int, int]], tasks: int) -> None:
    """Within tau + theta / (fast rate x spin rate) + one cycle after the last announcement, if nobody else does.

    Free is a robot that is applicable and uninhibited all that time. A task that nobody announced yet is taken up
    within the same time without tau.
    """
    names = TASKS[:tasks]
    team = made(kinds_of, names)
    announced = {task: time_of(1) - CYCLE for task in names}
    ever = set()
    free_since = dict.fromkeys(team.agents, time_of(1) - CYCLE)
    for _ in range(CYCLES):
        lose(team, plan)
        decisions = team.step()
        now = time_of(team.cycle)
        for decision in decisions.values():
            for message in announcements(decision):
                announced[message.fields["task_id"]] = now
                ever.add(message.fields["task_id"])
        for robot, decision in decisions.items():
            if decision.task is not None:
                free_since[robot] = now
        holders = team.holders()
        for index, told in enumerate(kinds_of):
            for task, rate in zip(names, told.fast_rates):
                robot = f"robot{index}"
                waited = now - announced[task]
                if robot not in decisions or free_since[robot] > announced[task] or holders[task]:
                    continue
                tau = told.timeout if task in ever else 0.0
                assert waited <= tau + THRESHOLD / (rate * SPIN_RATE) + CYCLE + 1e-6


def overlaps(team: Team, before: Dict[Tuple[str, str, str], float]) -> Dict[Tuple[str, str, str], float]:
    """Give since when two robots have held one task, by task and robots."""
    return {
        (task, one, other): before.get((task, one, other), time_of(team.cycle))
        for task, holders in team.holders().items()
        for one, other in itertools.combinations(holders, 2)
    }


def longest(kinds_of: Sequence[Kind], *pair: str) -> float:
    """Give the larger of psi and the period of announcements, of two robots [s]."""
    told = [kinds_of[int(robot[-1])] for robot in pair]
    return max(limit for each in told for limit in (each.yielding_delay, each.period))


@settings(max_examples=15, deadline=None)
@given(teams, losses, st.integers(1, len(TASKS)))
def test_no_two_robots_hold_one_task_for_long(kinds_of: List[Kind], plan: List[Tuple[int, int]], tasks: int) -> None:
    """Not longer than the larger of psi and one period of announcements, of the two."""
    names = TASKS[:tasks]
    team = made(kinds_of, names)
    since: Dict[Tuple[str, str, str], float] = {}
    for _ in range(CYCLES):
        lose(team, plan)
        team.step()
        since = overlaps(team, since)
        for (_, *pair), begin in since.items():
            assert time_of(team.cycle) - begin <= longest(kinds_of, *pair) + 1e-6


@settings(max_examples=10, deadline=None)
@given(teams, st.integers(0, 3), st.integers(1, 80), st.integers(1, 100))
def test_robot_that_returns_settles_with_whoever_took_over(
    kinds_of: List[Kind], who: int, cycle: int, away: int
) -> None:
    """It has first to hear and to be heard: announcements meet cycles, which takes up to two of them more."""
    team = made(kinds_of, TASKS[:2])
    since: Dict[Tuple[str, str, str], float] = {}
    for _ in range(CYCLES):
        away_now = cycle <= team.cycle + 1 < cycle + away
        team.stopped = [f"robot{who % len(kinds_of)}"] if away_now else []
        team.step()
        since = overlaps(team, since)
        for (_, *pair), begin in since.items():
            assert time_of(team.cycle) - begin <= longest(kinds_of, *pair) + 2 * CYCLE + 1e-6


@settings(max_examples=15, deadline=None)
@given(teams, st.integers(0, 3), st.integers(1, 150), st.integers(1, len(TASKS)))
def test_one_robot_left_alive_carries_out_every_task_that_ends(
    kinds_of: List[Kind], left: int, cycle: int, tasks: int
) -> None:
    """All others are lost in one cycle. A task is done once it was held for two seconds in a row.

    For each task the robot needs tau, unless its owner fell silent long ago, theta / (fast rate x spin rate), and the
    two seconds; and a cycle for each of the three.
    """
    names = TASKS[:tasks]
    team = made(kinds_of, names)
    team.step_to(cycle)
    survivor = left % len(kinds_of)
    team.stopped = [robot for index, robot in enumerate(team.agents) if index != survivor]
    told = kinds_of[survivor]
    needed = told.timeout + sum(THRESHOLD / (rate * SPIN_RATE) + 2.0 + 3.0 * CYCLE for rate in told.fast_rates[:tasks])
    held, done = dict.fromkeys(names, 0), []
    reports: List[TaskReport] = []
    # A set that is at work when the others fall silent may give up once first.
    until = time_of(cycle) + needed + told.giving_up_delay + THRESHOLD / (min(told.fast_rates) * SPIN_RATE)
    while len(done) < tasks:
        team.step(*reports)
        assert time_of(team.cycle) <= until
        for task, holders in team.holders().items():
            held[task] = held[task] + 1 if holders else 0
        ended = [task for task, cycles in held.items() if cycles == 10 and task not in done]
        done += ended
        reports = [TaskReport(task, Progress.DONE) for task in ended]
