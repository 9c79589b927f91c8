"""The table of task states: what it may and may not do, whatever happens."""

from __future__ import annotations

from typing import List, Set

import pytest
from hypothesis import given
from hypothesis import strategies as st
from mrta_demir_cf.task_model import TaskModel, key_of
from mrta_demir_cf.task_states import OWN, TASK_ROWS, TaskBelief, TaskEvent, is_illegal, task_row

B, E = TaskBelief, TaskEvent


@given(st.lists(st.sampled_from(E), max_size=40))
def test_completed_is_absorbing_and_only_listed_changes_happen(events: List[TaskEvent]) -> None:
    model = TaskModel("t")
    completed = False
    for time, event in enumerate(events):
        before = model.belief
        number = model.happen(event, float(time))
        listed = [row for row in TASK_ROWS if before in row.states and row.event is event]
        assert [row.number for row in listed] == ([] if number is None else [number])
        assert model.belief is (listed[0].to if listed else before)
        if model.belief is not before:
            assert model.since == time
        completed = completed or model.belief is B.COMPLETED
        assert not completed or model.belief is B.COMPLETED
        assert not (number is not None and is_illegal(before, event))


def test_every_state_can_be_reached_and_left_but_completed() -> None:
    reached: Set[TaskBelief] = {B.INITIAL}
    for _ in B:
        reached |= {row.to for row in TASK_ROWS if reached.intersection(row.states)}
    assert reached == set(B)
    assert {state for row in TASK_ROWS for state in row.states if row.to is not state} == set(B) - {B.COMPLETED}


def test_no_event_has_two_rows_in_one_state() -> None:
    pairs = [(state, row.event) for row in TASK_ROWS for state in row.states]
    assert len(set(pairs)) == len(pairs)
    assert {event for _, event in pairs} == set(E)


@pytest.mark.parametrize(
    ("state", "event"),
    [(B.INITIAL, E.STARTED), (B.COMPLETED, E.SELECTED), (B.EXECUTING, E.AUCTION_WON), (B.INITIAL, E.REACHED)],
)
def test_own_decision_that_no_row_allows_is_illegal_and_changes_nothing(state: TaskBelief, event: TaskEvent) -> None:
    assert is_illegal(state, event)
    assert task_row(state, event) is None
    assert TaskModel("t", belief=state).happen(event, 1.0) is None


def test_what_is_heard_at_an_odd_moment_is_not_illegal() -> None:
    assert not is_illegal(B.COMPLETED, E.CANCELLED)
    assert E.CANCELLED not in OWN


def test_task_that_becomes_free_has_no_holder() -> None:
    model = TaskModel("t")
    model.happen(E.EXECUTION_HEARD, 1.0)
    model.claim("a", 2.0, 1.0, ordered=True)
    model.happen(E.CANCELLED, 2.0)
    assert (model.holder, model.ordered, model.is_free) == ("", False, True)


def test_claims_compare_by_order_then_cost_then_id() -> None:
    assert sorted([key_of(1.0, "b"), key_of(2.0, "a"), key_of(1.0, "a"), key_of(9.0, "z", True)]) == [
        key_of(9.0, "z", True),
        key_of(1.0, "a"),
        key_of(1.0, "b"),
        key_of(2.0, "a"),
    ]
