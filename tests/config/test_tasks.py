"""tasks.yaml."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.config import read_tasks
from rqt_mrta_py.errors import ConfigError
from rqt_mrta_py.model import Pose, Task


def test_tasks_are_read_whole() -> None:
    text = """
tasks:
  - id: /dig
    kind: dig_hole
    place: {x: 1, y: -2.5, yaw: 0.5}
    capabilities: [shovel]
    predecessors: [/survey]
    resources: [path]
    robots: 2
    expected_duration: 30
    perpetual: false
    data: {depth: 0.4, layers: [1, {soft: true}]}
  - {id: survey, kind: survey, perpetual: yes, place: }
"""

    assert read_tasks(text, "tasks.yaml") == (
        Task(
            id="dig",
            kind="dig_hole",
            place=Pose(1.0, -2.5, 0.5),
            capabilities=("shovel",),
            predecessors=("survey",),
            resources=("path",),
            robots=2,
            expected_duration=30.0,
            data={"depth": 0.4, "layers": [1, {"soft": True}]},
        ),
        Task(id="survey", kind="survey", perpetual=True),
    )


def test_tasks_may_be_an_empty_list() -> None:
    assert read_tasks(b"tasks: []", "tasks.yaml") == ()


def test_tasks_share_values_through_anchors() -> None:
    text = "tasks:\n- {id: a, kind: go, place: &there {x: 1, y: 2}}\n- {id: b, kind: go, place: *there}\n"

    first, second = read_tasks(text, "tasks.yaml")

    assert first.place == second.place == Pose(1.0, 2.0)


def test_tasks_do_not_share_their_data() -> None:
    first, second = read_tasks("tasks: [{id: a, kind: go}, {id: b, kind: go}]", "tasks.yaml")

    assert first.data is not second.data


def test_task_that_comes_before_itself_is_refused() -> None:
    with pytest.raises(ConfigError, match="go round in a circle: a after a; take one of them out"):
        read_tasks("tasks: [{id: a, kind: go, predecessors: [a]}]", "tasks.yaml")


@settings(deadline=None)
@given(st.lists(st.sets(st.integers(0, 6)), min_size=1, max_size=7))
def test_tasks_are_refused_exactly_when_they_cannot_be_put_in_order(before: list[set[int]]) -> None:
    known = range(len(before))
    wanted = [sorted(other for other in others if other in known) for others in before]
    rows = [
        f"{{id: t{index}, kind: go, predecessors: [{', '.join(f't{other}' for other in wanted[index])}]}}"
        for index in known
    ]
    text = f"tasks: [{', '.join(rows)}]"

    left = dict(enumerate(wanted))
    while True:
        ready = [index for index, others in left.items() if not any(other in left for other in others)]
        if not ready:
            break
        for index in ready:
            del left[index]

    if not left:
        assert len(read_tasks(text, "tasks.yaml")) == len(before)
    else:
        with pytest.raises(ConfigError, match="go round in a circle"):
            read_tasks(text, "tasks.yaml")
