"""tasks.yaml, and one of its entries as a text of its own."""

from __future__ import annotations

import sys
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.config.tasks.task_text import dump_task, read_task
from rqt_mrta_py.config.tasks.tasks_file import read_tasks
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


def test_layers_are_read_from_lower_to_higher() -> None:
    (task,) = read_tasks("tasks: [{id: roam, kind: wander, layers: [follow, avoid]}]", "tasks.yaml")
    assert task == Task("roam", "wander", layers=("follow", "avoid"))


@pytest.mark.parametrize(
    ("layers", "message"),
    [
        ("[avoid, avoid]", "names 'avoid' twice; take one of them out"),
        ("[avoid, wander]", "names 'wander', the task's own kind, which is the lowest layer; take it out"),
        ("avoid", "must be a list of texts (got 'avoid')"),
    ],
)
def test_layers_that_cannot_be_are_told_with_their_line(layers: str, message: str) -> None:
    text = f"tasks:\n- id: roam\n  kind: wander\n  layers: {layers}\n"
    with pytest.raises(ConfigError) as caught:
        read_tasks(text, "tasks.yaml")
    assert str(caught.value) == f"tasks.yaml:4: tasks[0]/layers: {message}"
    with pytest.raises(ConfigError) as caught:
        read_task(f"id: roam\nkind: wander\nlayers: {layers}\n", "task_yaml")
    assert str(caught.value) == f"task_yaml:3: layers: {message}"


def test_a_task_travels_with_its_layers() -> None:
    task = Task("roam", "wander", layers=("follow", "avoid"), data={"layers": {"avoid": {"distance": 0.5}}})
    assert read_task(dump_task(task), "task_yaml") == task


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


names = st.text(min_size=1, max_size=12).filter(lambda name: bool(name.strip()))
ids = names.filter(lambda name: not any(character.isspace() for character in name))
numbers = st.floats(allow_nan=False, allow_infinity=False)
plain = st.recursive(
    st.none() | st.booleans() | st.integers() | numbers | st.text(max_size=12),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=5), inner, max_size=3),
    max_leaves=8,
)
entries = st.builds(
    Task,
    id=ids,
    kind=names,
    place=st.none() | st.builds(Pose, numbers, numbers, numbers),
    capabilities=st.lists(names, max_size=2).map(tuple),
    predecessors=st.just(()),
    resources=st.lists(names, max_size=2).map(tuple),
    robots=st.integers(1, sys.maxsize),
    expected_duration=st.none() | st.floats(min_value=0.0, exclude_min=True, allow_infinity=False),
    perpetual=st.booleans(),
    data=st.dictionaries(st.text(max_size=5), plain, max_size=3),
)


@settings(deadline=None)
@given(entries)
def test_task_that_was_written_reads_as_the_same(task: Task) -> None:
    assert read_task(dump_task(task), "task_yaml") == task


@settings(deadline=None)
@given(entries, st.lists(ids, max_size=3))
def test_task_that_was_written_reads_as_the_same_with_its_predecessors(task: Task, others: list[str]) -> None:
    after = Task(task.id, task.kind, predecessors=tuple(other for other in others if other != task.id))

    assert read_task(dump_task(after), "task_yaml") == after


@pytest.mark.parametrize("tricky", ["yes", "null", "1e3", "2026-01-01", "=", "<<", "~", "- a", "#", "a: b", "\u2028"])
def test_text_that_yaml_would_take_for_something_else_stays_a_text(tricky: str) -> None:
    task = Task("a", "go", data={tricky: [tricky]})

    assert read_task(dump_task(task), "task_yaml") == task


def test_task_is_written_as_a_person_would() -> None:
    task = Task("dig", "dig_hole", Pose(1.0, -2.5), robots=2, data={"depth": 0.4, "tools": ["spade"]})

    assert dump_task(task) == (
        "id: dig\nkind: dig_hole\nplace:\n  x: 1.0\n  y: -2.5\nrobots: 2\ndata:\n  depth: 0.4\n  tools:\n  - spade\n"
    )


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "task_yaml:1: is empty; accepted: id, kind, layers, place"),
        ("[]", r"task_yaml:1: must be a mapping \(got \[\]\)"),
        ("id: a", "task_yaml:1: kind: is missing; give a text"),
        ("{id: a b, kind: go}", r"task_yaml:1: id: must be a name without spaces \(got 'a b'\)"),
        ("{id: /, kind: go}", r"task_yaml:1: id: must be a name without spaces \(got '/'\)"),
        ("{id: a, kind: go, predecessors: [b, /a]}", "task_yaml:1: predecessors: go round in a circle: a after a"),
        ("{id: a, kind: go, robots: 0}", r"task_yaml:1: robots: must be a whole number from 1 \(got 0\)"),
        ("{id: a, kind: go, expected_duration: .nan}", "task_yaml:1: holds .nan; numbers must be finite"),
        ("{id: a, kind: go, sped: 1}", "task_yaml:1: sped: is not known"),
        ("&a [*a]", "task_yaml:1: refers to 'a', which is not complete here"),
        ("{id: a, kind: !!python/name:os.system go}", "tags are not accepted"),
        ("id: {", "task_yaml:1: is not YAML"),
    ],
)
def test_text_that_is_no_task_is_refused(text: str, message: str) -> None:
    with pytest.raises(ConfigError, match=message):
        read_task(text, "task_yaml")


@settings(deadline=None)
@given(st.binary(max_size=80) | st.text(max_size=80))
def test_text_that_is_noise_is_refused(text: Any) -> None:
    with pytest.raises(ConfigError, match="task_yaml"):
        read_task(text, "task_yaml")
