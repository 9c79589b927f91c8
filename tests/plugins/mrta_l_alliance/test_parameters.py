"""What a robot is told about learning."""

from __future__ import annotations

from typing import Any, Dict

import pytest
from mrta_l_alliance.memory import Memory, Performance
from mrta_l_alliance.parameters import LearningParameters, Phase, find_learning_problems, read_learning


def test_what_is_missing_takes_its_default() -> None:
    assert read_learning({"spin_rate": 5.0}) == LearningParameters()
    told = read_learning({"learning": {"phase": "active", "window": 7, "memory": "{r1: {dig: {times: [3]}}}"}})
    assert (told.phase, told.window, told.max_delay) == (Phase.ACTIVE, 7, 6.0)
    assert told.memory == Memory({("r1", "dig"): Performance((3.0,))})


@pytest.mark.parametrize(
    ("given", "problems"),
    [
        ({"phase": "off"}, ["learning/phase: must be one of active, adaptive (got 'off')"]),
        ({"window": 0}, ["learning/window: must be from 1 to 1000 (got 0)"]),
        ({"window": 2.5}, ["learning/window: must be a whole number (got 2.5)"]),
        ({"deviations": -1}, ["learning/deviations: must be a finite number, at least 0 (got -1)"]),
        ({"least_spread": "much"}, ["learning/least_spread: must be a number (got 'much')"]),
        ({"min_delay": 0.0}, ["learning/min_delay: must be above 0 s (got 0)"]),
        ({"min_delay": 9}, ["learning/max_delay: must be at least min_delay = 9 s (got 6)"]),
        ({"boredom_delay": -0.5}, ["learning/boredom_delay: must be a finite number, at least 0 s (got -0.5)"]),
        ({"giving_up_factor": 1}, ["learning/giving_up_factor: must be above 1 (got 1)"]),
        ({"memory": 5}, ["learning/memory: must be a text (got 5)"]),
        ({"memory": "{r1: 5}"}, ["learning/memory: r1: must be a mapping (got 5)"]),
        (
            {"phase": "off", "window": 0},
            [
                "learning/phase: must be one of active, adaptive (got 'off')",
                "learning/window: must be from 1 to 1000 (got 0)",
            ],
        ),
    ],
)
def test_everything_that_is_wrong_is_told_at_once(given: Dict[str, Any], problems: list) -> None:
    found = find_learning_problems({"learning": given})
    assert [f"{problem.path}: {problem.message}" for problem in found] == problems


def test_a_group_must_be_a_group() -> None:
    (problem,) = find_learning_problems({"learning": "much"})
    assert problem == ("learning", "must be a group of parameters (got 'much')")
