"""The table of robot states, row by row, and what a model of a robot takes for news."""

from __future__ import annotations

import pytest
from mrta_demir_cf.robot_model import RobotModel
from mrta_demir_cf.robot_states import RobotBelief, RobotEvent, next_robot_state

B, E = RobotBelief, RobotEvent


@pytest.mark.parametrize(
    ("before", "event", "after"),
    [
        (B.IDLE, E.REQUESTS, B.REQUESTING),
        (B.EXECUTING, E.REQUESTS, B.REQUESTING),
        (B.IDLE, E.EXECUTES, B.EXECUTING),
        (B.REQUESTING, E.EXECUTES, B.EXECUTING),
        (B.EXECUTING, E.ENDS, B.IDLE),
        (B.REQUESTING, E.ENDS, B.IDLE),
        (B.REQUESTING, E.AWARDS, B.IDLE),
        (B.EXECUTING, E.AWARDS, B.EXECUTING),
        (B.IDLE, E.SPEAKS, B.IDLE),
        (B.EXECUTING, E.SPEAKS, B.EXECUTING),
        (B.REQUESTING, E.SPEAKS, B.REQUESTING),
        (B.IDLE, E.SILENCE, B.FAILED),
        (B.EXECUTING, E.SILENCE, B.FAILED),
        (B.REQUESTING, E.SILENCE, B.FAILED),
        (B.FAILED, E.SILENCE, B.FAILED),
        (B.FAILED, E.REQUESTS, B.REQUESTING),
        (B.FAILED, E.EXECUTES, B.EXECUTING),
        (B.FAILED, E.ENDS, B.IDLE),
        (B.FAILED, E.AWARDS, B.IDLE),
        (B.FAILED, E.SPEAKS, B.IDLE),
    ],
)
def test_state_after_an_event(before: RobotBelief, event: RobotEvent, after: RobotBelief) -> None:
    assert next_robot_state(before, event) is after


def test_robot_counts_once_it_has_said_where_it_is_and_until_it_fails() -> None:
    model = RobotModel("a")
    assert not model.is_present
    model.position = (1.0, 2.0)
    assert model.is_present
    model.happen(E.EXECUTES, 1.0, "t")
    assert (model.task, model.active) == ("t", 1.0)
    model.happen(E.SILENCE, 9.0)
    assert (model.is_present, model.task, model.since) == (False, "", 9.0)


def test_messages_that_are_not_newer_about_a_task_are_no_news() -> None:
    model = RobotModel("a")
    assert model.is_news("t", 5, 1.0)
    assert not model.is_news("t", 5, 1.0)
    assert not model.is_news("t", 4, 0.9)
    assert model.is_news("u", 4, 0.9)
    assert model.is_news("t", 6, 1.0)


def test_robot_that_counts_anew_has_begun_anew() -> None:
    model = RobotModel("a")
    assert model.is_news("t", 500, 1.0)
    assert model.is_news("t", 1, 9.0)
    assert not model.is_news("t", 1, 9.0)
