"""Explanations in words."""

from __future__ import annotations

from typing import List, Tuple

import pytest

from rqt_mrta_py.model import Candidate, Explanation, Outcome, RobotState, Spell, Task, TaskState, Whereabouts
from rqt_mrta_py.render.explaining import (
    candidate_groups,
    ends_of,
    named,
    others_in_lines,
    spell_in_words,
    task_in_words,
)

IDLE, BUSY = RobotState.IDLE, RobotState.BUSY


def test_robots_of_which_the_same_is_to_be_said_stand_together_able_ones_first() -> None:
    candidates = [
        Candidate("a", False, "lacks x"),
        Candidate("b", None, "nobody knows"),
        Candidate("c", True, "has x"),
        Candidate("d", True, "has x"),
    ]
    assert candidate_groups(candidates) == [
        ("yes", "c, d", "has x"),
        ("unknown", "b", "nobody knows"),
        ("no", "a", "lacks x"),
    ]


@pytest.mark.parametrize(
    ("task", "words"),
    [
        (None, "nothing is known of what it is; done at the end"),
        (Task("t", "dig"), "dig, needs nothing in particular; done at the end"),
        (
            Task("t", "dig", capabilities=("see", "lift"), robots=2, predecessors=("u", "v")),
            "dig, needs see, lift, 2 robots, after u, v; done at the end",
        ),
    ],
)
def test_a_task_is_told_with_what_it_needs(task: Task, words: str) -> None:
    assert task_in_words(Explanation("t", task, TaskState.DONE)) == words


@pytest.mark.parametrize(
    ("spell", "words"),
    [
        (Spell(0.0, 1.0, "a", Outcome.GAVE_UP, text="too hard"), "gave up: too hard"),
        (Spell(0.0, 1.0, "a", Outcome.LOST), "lost"),
        (Spell(0.0, 1.0, states=(TaskState.WAITING, TaskState.ALLOCATED)), "waiting, then allocated"),
        (Spell(0.0, 1.0), "not known"),
    ],
)
def test_a_spell_is_told_by_how_it_went(spell: Spell, words: str) -> None:
    assert spell_in_words(spell) == words


def test_of_a_hold_it_is_told_what_the_others_did_when_it_began() -> None:
    others = (
        Whereabouts("b", BUSY, ("u", "v"), 0.0, 9.0),
        Whereabouts("c", BUSY, (), 0.0, 9.0),
        Whereabouts("d", None, (), 0.0, 9.0),
    )
    assert others_in_lines(Spell(1.0, 2.0, "a", Outcome.DONE, others=others, more=3), 0.0) == [
        "when it was taken: b busy with u, v, c busy without a known task, d not known of yet, 3 more in summary.json"
    ]


def test_while_nobody_holds_it_robots_have_a_line_each_in_mission_time() -> None:
    others = (
        Whereabouts("a", IDLE, (), 11.0, 13.0),
        Whereabouts("a", BUSY, ("u",), 13.0, 15.0),
        Whereabouts("b", IDLE, (), 11.0, 15.0),
        Whereabouts("c", IDLE, (), 11.0, 13.0),
        Whereabouts("c", BUSY, ("u",), 13.0, 15.0),
    )
    assert others_in_lines(Spell(11.0, 15.0, others=others), 10.0) == [
        "a, c: idle until 3.0 s, then busy with u",
        "b: idle",
    ]


def test_of_a_robot_that_did_many_things_the_first_and_the_last_are_told() -> None:
    course = tuple(Whereabouts("a", IDLE if n % 2 else BUSY, (), float(n), n + 1.0) for n in range(20))
    (line,) = others_in_lines(Spell(0.0, 20.0, others=course), 0.0)
    assert line.startswith("a: busy without a known task until 1.0 s, then idle until 2.0 s, ")
    assert ", then 11 other things, then " in line
    assert line.endswith(" until 19.0 s, then idle")


@pytest.mark.parametrize(
    ("most", "parts"),
    [(5, ([1, 2, 3, 4, 5], 0, [])), (4, ([1, 2, 3], 1, [5])), (3, ([1, 2], 2, [5])), (2, ([1, 2], 3, []))],
)
def test_of_many_the_first_and_the_last_are_given(most: int, parts: Tuple[List[int], int, List[int]]) -> None:
    first, left_out, last = ends_of([1, 2, 3, 4, 5], most)
    assert (list(first), left_out, list(last)) == parts


def test_ids_that_nobody_could_read_are_shortened_and_made_printable() -> None:
    assert len(named(["x" * 500])) == 60
    assert named(["a\x1b[31m"]) == "a\ufffd[31m"
    assert named([str(n) for n in range(25)]).endswith(", 19 and 5 more")
