"""What a hundred robots announce is taken in at once; what is not as ever goes the readable way."""

from __future__ import annotations

from typing import Any, Dict, List, Sequence, Tuple

import numpy as np
import pytest
from mrta_alliance.agent import AllianceAgent
from mrta_alliance.communication import Communication
from mrta_alliance.earshot import Earshot
from mrta_alliance.history import Peer

from rqt_mrta_py.hooks import AgentSetup, Heard, Situation
from rqt_mrta_py.model import Task
from tests.plugins.mrta_alliance.team import announced, behaviour_set, nested, one_by_one

LIMITS = np.array([10.0, 10.0])
TASKS = ("patrol", "inspect")


def earshot(*peers: Tuple[str, str, Peer]) -> Earshot:
    """Make one of robot1 with tau 2 s that knows peers by robot and task."""
    found = Earshot("robot1", 2.0)
    found.pass_over(TASKS)
    for robot, task, peer in peers:
        found.note(peer, robot, task, TASKS.index(task))
    return found


def slowing(who: Earshot, now: float) -> List[Tuple[int, float]]:
    rows, patience = who.slowing(now)
    return list(zip(rows.tolist(), patience.tolist()))


def test_what_is_as_ever_is_taken_in_and_the_rest_is_given_back_in_order() -> None:
    two, three = Peer(5.0, 5.0, 60.0), Peer(5.0, 5.0, 60.0)
    who = earshot(("two", "patrol", two), ("three", "patrol", three))
    heard = [
        announced("four", "patrol", 6.0),
        announced("two", "patrol", 6.0, 30.0),
        announced("robot1", "patrol", 6.0),
        announced("three", "patrol", 6.0, 40.0),
        announced("three", "patrol", 6.1, 10.0),
        announced("two", "unknown", 6.2),
    ]

    assert who.take_in(heard, 6.5, LIMITS) == [heard[0], heard[3], heard[4], heard[5]]
    assert slowing(who, 6.5) == [(0, 30.0), (0, 60.0)]


@pytest.mark.parametrize(
    ("expected", "stamp"),
    [(10.0, 6.0), (float("inf"), 6.0), (float("nan"), 6.0), (60.0, 0.0), (60.0, 7.1), (60.0, float("nan"))],
)
def test_anything_to_be_noticed_goes_the_readable_way(expected: float, stamp: float) -> None:
    who = earshot(("two", "patrol", Peer(5.0, 5.0, 60.0)))
    odd = announced("two", "patrol", 6.0, expected, stamp)
    assert who.take_in([odd], 6.5, LIMITS) == [odd]


def test_a_robot_slows_while_it_is_heard_within_tau_and_first_heard_less_than_phi_ago() -> None:
    """Two was heard last at 5 s, and tau is 2 s; three is heard on, and phi of 8 s from 5 s on ends at 13 s."""
    who = earshot(("two", "patrol", Peer(5.0, 5.0, 60.0)), ("three", "inspect", Peer(5.0, 5.0, 8.0)))
    found: Dict[float, Any] = {}
    limits = np.array([1.0, 1.0])
    for now in (6.9, 7.1, 8.9, 10.7, 12.5, 12.9, 13.1):
        who.take_in([announced("three", "inspect", now, 8.0)], now, limits)
        found[now] = slowing(who, now)
    assert found[6.9] == [(0, 60.0), (1, 8.0)]
    assert found[7.1] == found[12.9] == [(1, 8.0)]
    assert found[13.1] == []


def test_histories_are_told_what_was_taken_in_when_they_are_asked_again() -> None:
    peer = Peer(5.0, 5.0, 60.0)
    who = earshot(("two", "patrol", peer))
    who.take_in([announced("two", "patrol", 6.0, 30.0), announced("two", "patrol", 5.5, 20.0)], 6.5, LIMITS)
    assert list(peer.announcements().times) == [5.0]
    who.settle()
    assert (list(peer.announcements().times), peer.patience) == ([5.0, 6.0], 20.0)


def test_who_fell_silent_is_dropped_with_the_history_told_and_goes_the_readable_way_again() -> None:
    peers = {name: Peer(5.0, 5.0, 60.0) for name in ("two", "three", "four")}
    who = earshot(*((name, "patrol", peer) for name, peer in peers.items()))
    who.take_in([announced("two", "patrol", 6.0)], 6.0, LIMITS)
    who.slowing(9.0)
    again = announced("two", "patrol", 9.1)
    assert who.take_in([again], 9.2, LIMITS) == [again]
    assert peers["two"].recent[-1] == 6.0


def test_nothing_is_taken_in_where_somebody_was_first_heard_about_zero() -> None:
    who = earshot(("two", "patrol", Peer(0.0, 0.2, 60.0)))
    heard = [announced("two", "patrol", 6.0)]
    assert who.take_in(heard, 6.5, LIMITS) == heard


class CountingCommunication(Communication):
    """Counts the announcements that go the readable way."""

    count = 0

    def take_in(self, messages: Sequence[Heard], now: float) -> Any:
        type(self).count += len(messages)
        return super().take_in(messages, now)


def test_of_a_hundred_robots_only_the_first_announcements_go_one_by_one(monkeypatch: pytest.MonkeyPatch) -> None:
    """Counted work: 99 others announce a task each in each of 20 cycles; 99 of the 1980 announcements are new."""
    monkeypatch.setattr("mrta_alliance.agent.Communication", CountingCommunication)
    monkeypatch.setattr(CountingCommunication, "count", 0)
    tasks = tuple(f"task{number}" for number in range(100))
    robots = tuple(f"robot{number}" for number in range(100))
    parameters = nested(*(behaviour_set(task, 0.3, 600.0) for task in tasks))
    who = AllianceAgent(
        AgentSetup("robot0", robots, tuple(Task(task, "any") for task in tasks), parameters, np.random.default_rng(0))
    )
    applicable = dict.fromkeys(tasks, True)
    for cycle in range(20):
        now = 1.0 + 0.2 * cycle
        heard = [announced(robot, task, now, 600.0) for robot, task in zip(robots[1:], tasks[1:])]
        decision = who.step(Situation(now, heard, (), applicable, lambda task: None))
    impatience = {
        message.fields["task_id"]: message.fields["impatience"]
        for message in one_by_one(decision.messages)
        if message.type == "alliance_msgs/Motivation"
    }
    # theta / phi is 30 / 600; nobody is on task0.
    assert impatience["task1"] == impatience["task99"] == 0.05
    assert impatience["task0"] == 0.3
    assert CountingCommunication.count == 99
