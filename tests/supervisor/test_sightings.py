"""Messages that only show that their robots are there; times in seconds, silence after two."""

from __future__ import annotations

from typing import List, Sequence

import pytest

from rqt_mrta_py.hooks import Fact, Heard, IncidentBoard, RobotHeard, RobotSilent, Subscription
from rqt_mrta_py.model import Evidence
from tests.supervisor.mini import Stream, allocations, of_kind


class Notes:
    """A rule that keeps the facts about who is heard."""

    def __init__(self) -> None:
        self.facts: List[Fact] = []

    def subscriptions(self) -> Sequence[Subscription]:
        return ()

    def hear(self, heard: Heard, board: IncidentBoard) -> None:
        """Hear nothing."""

    def notice(self, fact: Fact, board: IncidentBoard) -> None:
        if isinstance(fact, (RobotHeard, RobotSilent)):
            self.facts.append(fact)

    def wake(self, time: float, board: IncidentBoard) -> None:
        """Look at nothing."""

    def finish(self, time: float, board: IncidentBoard) -> None:
        """Look at nothing."""


def test_each_robot_told_of_together_is_heard_with_its_own_message() -> None:
    notes = Notes()
    stream = Stream(rules={"notes": lambda setup: notes})
    # robot9 is not of the team, and robot2 speaks twice.
    stream.together(1.0, "robot9", "robot2", "robot1", "robot2")
    stream.together(2.0, "robot9", "robot2", "robot1", "robot2")
    stream.odom(3.5, "robot1")
    stream.together(5.0, "robot2", "robot1")
    one, two = "/robot1/odom", "/robot2/odom"
    assert notes.facts == [
        RobotHeard(1.0, "robot2", Evidence(two, 1.0, 0)),
        RobotHeard(1.0, "robot1", Evidence(one, 1.0, 0)),
        RobotSilent(4.0, "robot2", Evidence(two, 2.0, 3)),
        RobotHeard(5.0, "robot2", Evidence(two, 5.0, 4)),
    ]
    robots = {robot.id: robot.last_heard for robot in stream.finish().robots}
    assert robots == {"robot1": 5.0, "robot2": 5.0}


@pytest.mark.parametrize(
    ("speakers", "settled"),
    [
        (("robot1", "robot2"), True),
        (("robot1", "robot9"), True),
        (("robot2", "robot1"), False),
    ],
    ids=["before another robot", "before somebody else", "last"],
)
def test_an_expired_allocation_is_settled_by_the_message_after_its_robots(
    speakers: Sequence[str], settled: bool
) -> None:
    """robot1 says at 1.0 that it holds patrol, which counts for two seconds, then only that it is there."""
    stream = Stream()
    stream.busy(1.0, "robot1", "patrol")
    stream.every(1.0, 2.0, 4.0, lambda time: stream.together(time, *speakers))
    assert not of_kind(stream.events, "allocation_ended")
    stream.together(4.0, *speakers)
    assert bool(of_kind(stream.events, "allocation_ended")) is settled
    stream.tick(4.0)
    assert allocations(stream.finish()) == [("robot1", "patrol", 1.0, 3.0, "gave_up")]
