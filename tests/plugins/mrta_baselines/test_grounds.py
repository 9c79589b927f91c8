"""By which rule tasks were taken, told from messages written by hand."""

from __future__ import annotations

from typing import List, Mapping, Tuple

import pytest
from mrta_baselines.grounds import BaselineGrounds

from rqt_mrta_py.hooks import GroundsSetup, Heard
from rqt_mrta_py.model import ApplicationRobot, ApplicationSpec, ArchitectureSpec, Mission, Taxonomy
from tests.plugins.nearest_robot.team import bid


def texts(*messages: Heard, rule: str = "fixed") -> List[Tuple[str, str]]:
    """Give what is made of the last of some messages."""
    robots = tuple(ApplicationRobot(robot) for robot in "ab")
    parameters: Mapping[str, Mapping[str, str]] = {robot: {"rule": rule} for robot in "ab"} if rule else {}
    mission = Mission(
        ApplicationSpec("", "", robots=robots),
        ArchitectureSpec("mrta_baselines", "Baselines", Taxonomy()),
        (),
        parameters,
    )
    reader = BaselineGrounds(GroundsSetup(mission))
    return [(ground.task, ground.text) for ground in [reader.hear(message) for message in messages][-1]]


@pytest.mark.parametrize(
    ("rule", "why"),
    [
        ("fixed", "it was dealt to it (rule fixed)"),
        ("random", "it drew it among the free ones (rule random)"),
        ("", "by a rule that is not known"),
        ("eeny", "by a rule that is not known"),
    ],
)
def test_who_takes_a_task_is_told_with_the_rule_and_who_else_offered_it(rule: str, why: str) -> None:
    messages = (
        bid("b", {"t": 0.0, "u": 0.0}, 1.0, holding="u"),
        bid("a", {"t": 0.0}, 1.0),
        bid("a", {"t": 0.0}, 1.2, holding="t"),
    )
    assert texts(*messages, rule=rule) == [("t", f"takes it: {why}; b (holds u) offered it too")]


def test_what_was_offered_too_long_ago_does_not_count() -> None:
    messages = (bid("b", {"t": 0.0}, 1.0), bid("a", {"t": 0.0}, 2.5, holding="t"))
    assert texts(*messages) == [("t", "takes it: it was dealt to it (rule fixed); nobody else offered it")]


def test_an_order_counts_before_the_rule() -> None:
    assert texts(bid("a", {"t": 0.0}, 1.0, holding="t", ordered="t")) == [
        ("t", "takes it: an operator ordered it; nobody else offered it")
    ]


def test_what_is_let_go_is_told() -> None:
    assert texts(bid("a", {"t": 0.0}, 1.0, holding="t"), bid("a", {"t": 0.0}, 1.2)) == [("t", "lets it go")]
    assert texts(bid("a", {"t": 0.0}, 1.0, holding="t"), bid("a", {}, 1.2)) == [
        ("t", "lets it go: it cannot carry it out now")
    ]
