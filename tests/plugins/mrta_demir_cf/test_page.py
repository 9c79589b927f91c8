"""The page of the architecture shows the tables that the code goes by."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Sequence

import pytest
from mrta_demir_cf.message_kinds import CancelReason, Kind
from mrta_demir_cf.parameters import DemirCfParameters
from mrta_demir_cf.robot_states import ROBOT_ROWS
from mrta_demir_cf.task_states import TASK_ROWS, TaskBelief


@pytest.fixture
def page(root: Path) -> str:
    return (root / "docs/architectures/demir_cf.md").read_text(encoding="utf-8")


def names(states: Sequence[TaskBelief]) -> str:
    return "all but completed" if len(states) == 8 else ", ".join(state.value for state in states)


def test_page_shows_every_row_of_both_tables(page: str) -> None:
    rows = re.findall(r"^\| (\d+) \| (.*) \| (.*) \| (.*) \|$", page, re.MULTILINE)
    expected = [(str(row.number), names(row.states), row.event.value, row.to.value) for row in TASK_ROWS]
    assert rows[:-1] == expected
    for row in ROBOT_ROWS:
        states = ", ".join(state.value for state in row.states)
        assert f"| {states} | {row.event.value} | {row.to.value} |" in page


def test_page_names_every_topic_reason_and_parameter(page: str) -> None:
    for kind in Kind:
        assert f"| `{kind.topic.rpartition('/')[2]}` |" in page
    for name in [reason.value for reason in CancelReason] + list(DemirCfParameters.__dataclass_fields__):
        assert f"`{name}`" in page
