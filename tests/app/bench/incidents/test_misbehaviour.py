"""Agents that misbehave, each change by itself, round an agent that says the same in every cycle."""

from __future__ import annotations

from typing import List, Optional, Sequence, Tuple

import numpy as np
import pytest

from rqt_mrta_py.app.bench.incidents.misbehaviour import (
    AlsoSays,
    Estimates,
    GoesOn,
    HoldsBack,
    NeverBegins,
    SaysNothingOn,
    claim,
    progress,
)
from rqt_mrta_py.hooks import (
    Agent,
    AgentChange,
    AgentSetup,
    Decision,
    Outgoing,
    OutgoingRows,
    Situation,
    Subscription,
    TaskReport,
)
from rqt_mrta_py.model import MonitoredTopic, Progress

BUSY = MonitoredTopic("/claims", "my_msgs/Claim", "header/frame_id", task_field="task_id")
CLAIM = claim(BUSY, "robot1", "gate")


class Steady:
    """Works on the gate, says so, and that it is there; remembers what the gate would cost."""

    rate = 5.0

    def __init__(self) -> None:
        self.costs: List[Optional[float]] = []

    def subscriptions(self) -> Sequence[Subscription]:
        return (Subscription("/claims"),)

    def step(self, situation: Situation) -> Decision:
        self.costs.append(situation.cost("gate"))
        there = OutgoingRows(("/a", "/b"), "my_msgs/There", {"stamp": situation.now})
        return Decision("gate", (Outgoing("/claims", "my_msgs/Claim", {"stamp": situation.now}), there))


def changed(change: AgentChange, robot: str = "robot1", agent: Optional[Agent] = None) -> Agent:
    setup = AgentSetup(robot, ("robot1", "robot2"), (), {}, np.random.default_rng(0))
    return change(setup, agent or Steady())


def situation(now: float, *reports: TaskReport) -> Situation:
    return Situation(now, (), reports, {"gate": True}, lambda task: 2.0)


def said(agent: Agent, *times: float) -> List[Tuple[float, str]]:
    """Step an agent at some times, and give the times with the types of what it said."""
    return [(now, message.type) for now in times for message in agent.step(situation(now)).messages]


@pytest.mark.parametrize(
    "change",
    [
        AlsoSays("robot1", CLAIM, 0.0, 9.0),
        GoesOn("robot1", "gate", ((CLAIM, 0.0, 9.0),)),
        SaysNothingOn("robot1", "my_msgs/There", 0.0, 9.0),
        HoldsBack("robot1", 0.0, 2.0),
        Estimates(frozenset({"robot1"}), 10.0),
    ],
)
def test_agents_of_other_robots_stay_as_they_are(change: AgentChange) -> None:
    agent = Steady()
    assert changed(change, "robot2", agent) is agent
    mine = changed(change, "robot1", agent)
    assert (mine.rate, mine.subscriptions()) == (agent.rate, agent.subscriptions())


def test_a_claim_has_robot_task_and_stamp_where_the_topic_has_them() -> None:
    assert CLAIM.said(7.0) == Outgoing(
        "/claims", "my_msgs/Claim", {"header": {"stamp": 7.0, "frame_id": "robot1"}, "task_id": "gate"}
    )


def test_what_is_said_besides_is_said_time_and_again_within_its_time() -> None:
    agent = changed(AlsoSays("robot1", progress("rover", "gate", Progress.DONE), 2.0, 3.0, period=0.4))
    told = said(agent, 1.8, 2.0, 2.2, 2.4, 2.9, 3.0, 3.4)

    assert [now for now, kind in told if kind == "rqt_mrta_py/TaskProgress"] == [2.0, 2.4, 2.9]
    assert len(told) == 14 + 3


def test_a_robot_goes_on_from_the_moment_at_which_it_is_told_that_the_task_is_done() -> None:
    other = claim(BUSY, "robot1", "tower")
    agent = changed(GoesOn("robot1", "gate", ((CLAIM, 1.0, 2.0), (other, 3.0, None)), period=0.5))
    reports = {
        1.0: TaskReport("tower", Progress.DONE, robot="robot1"),
        2.0: TaskReport("gate", Progress.RUNNING, robot="robot1"),
        4.0: TaskReport("gate", Progress.DONE, robot="robot1"),
    }
    more = []
    for step in range(17):
        now = 0.5 * step
        heard = (reports[now],) if now in reports else ()
        more += [(now, message) for message in agent.step(situation(now, *heard)).messages[2:]]

    assert more == [
        (5.0, CLAIM.said(5.0)),
        (5.5, CLAIM.said(5.5)),
        (6.0, CLAIM.said(6.0)),
        (7.0, other.said(7.0)),
    ]


def test_what_is_to_be_said_once_is_said_in_the_first_cycle_from_then_on() -> None:
    """Cycles need not fall on the moment: 3 s after 4 s lies between 6.8 and 7.1 s."""
    agent = changed(GoesOn("robot1", "gate", ((CLAIM, 3.0, None),)))
    agent.step(situation(4.0, TaskReport("gate", Progress.DONE, robot="robot1")))

    assert [len(agent.step(situation(now)).messages) for now in (6.8, 7.1, 7.4, 8.0)] == [2, 3, 2, 2]


def test_a_type_that_is_not_said_is_left_out_within_its_time() -> None:
    agent = changed(SaysNothingOn("robot1", "my_msgs/There", 2.0, 3.0))
    assert said(agent, 1.0, 2.0, 3.0, 4.0) == [
        (1.0, "my_msgs/Claim"),
        (1.0, "my_msgs/There"),
        (2.0, "my_msgs/Claim"),
        (3.0, "my_msgs/Claim"),
        (4.0, "my_msgs/Claim"),
        (4.0, "my_msgs/There"),
    ]


def test_who_never_begins_does_nothing_and_claims_nothing() -> None:
    decision = changed(NeverBegins("my_msgs/Claim")).step(situation(1.0))
    assert decision.task is None
    assert [message.type for message in decision.messages] == ["my_msgs/There"]


def test_what_is_held_back_comes_late_in_order_and_with_its_stamps() -> None:
    """By 0 s at 2 s, 0.5 s at 3 s, and 1 s from 4 s on."""
    agent = changed(HoldsBack("robot1", 2.0, 1.0))
    stamps = []
    for now in (1.0, 2.0, 3.0, 3.4, 3.5, 4.0, 4.2, 5.0):
        messages = agent.step(situation(now)).messages
        stamps.append([message.fields["stamp"] for message in messages if isinstance(message, Outgoing)])

    assert stamps == [[1.0], [2.0], [], [], [3.0], [], [3.4], [3.5, 4.0]]


def test_dear_tasks_cost_more_in_turns() -> None:
    """The first robot is dear in the first turn of 2 s and in the third, the second one in between."""
    change = Estimates(frozenset({"robot1", "robot2"}), 10.0, 2.0, frozenset({"robot2"}), start=1.0)
    first, second = Steady(), Steady()
    agents = [changed(change, "robot1", first), changed(change, "robot2", second)]
    for now in (0.5, 1.0, 2.9, 3.0, 5.5):
        for agent in agents:
            agent.step(situation(now))

    assert first.costs == [2.0, 30.0, 30.0, 2.0, 30.0]
    assert second.costs == [2.0, 2.0, 2.0, 30.0, 2.0]


def test_only_the_task_that_is_meant_is_dear() -> None:
    steady = Steady()
    changed(Estimates(frozenset({"robot1"}), 10.0, task="tower"), "robot1", steady).step(situation(1.0))
    assert steady.costs == [2.0]
