from __future__ import annotations

import json
import tempfile
from pathlib import Path
from typing import Any, Callable, Dict, Optional

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.app.compare.comparison import compare
from rqt_mrta_py.app.compare.document import document
from rqt_mrta_py.app.compare.page import page
from rqt_mrta_py.app.compare.side import read_side
from rqt_mrta_py.errors import ConfigError
from tests.app.compare.summaries import allocation, folder, incident, summary

ADVICE = "give the folder of a finished run or review, or its summary.json"


def complaint(path: Path) -> str:
    with pytest.raises(ConfigError) as caught:
        read_side(path)
    return str(caught.value)


def test_times_count_from_the_missions_start(tmp_path: Path) -> None:
    content = summary(
        time=(10.0, 20.5),
        allocations=[allocation("haul", "r2", 12.0, 20.5, "open"), allocation("dig", "r1", 11.5, 12.0)],
        incidents=[incident("odd", "info", 13.25, ["r1"], [])],
    )
    side = read_side(folder(tmp_path, "a", content))
    assert side.duration == 10.5
    assert [tuple(each) for each in side.holdings] == [
        ("dig", "r1", 1.5, 2.0, "done"),
        ("haul", "r2", 2.0, 10.5, "open"),
    ]
    assert [(each.start, each.end, each.robots, each.tasks) for each in side.incidents] == [(3.25, 4.25, ("r1",), ())]


def test_a_summary_may_be_named_itself_and_may_know_more_than_we_do(tmp_path: Path) -> None:
    content = {**summary(), "later": {"key": [1]}}
    path = folder(tmp_path, "a", content) / "summary.json"
    assert read_side(path).application == "yard"


def test_a_mission_without_messages_is_read(tmp_path: Path) -> None:
    content = {**summary(time=(None, None), seed=None), "application": None}
    side = read_side(folder(tmp_path, "a", content))
    assert (side.duration, side.seed, side.application) == (None, None, None)


def test_what_is_no_summary_is_told_in_one_line(tmp_path: Path) -> None:
    file = tmp_path / "summary.json"
    assert complaint(tmp_path) == f"{file}: cannot be read: No such file or directory"
    for content, what in (
        (b"{", "Expecting property name enclosed in double quotes: line 1 column 2 (char 1)"),
        (b"[]", "its schema is 'None', not 'rqt_mrta_py/summary/1'"),
        (b'{"schema": "other/1"}', "its schema is 'other/1', not 'rqt_mrta_py/summary/1'"),
        (b'{"schema": NaN}', "NaN is no JSON"),
        (b"[" * 100_000, "it is nested too deeply"),
        (
            b'{"schema": "\\uD800"}',
            "'utf-8' codec can't encode character '\\ud800' in position 12: surrogates not allowed",
        ),
    ):
        file.write_bytes(content)
        assert complaint(file) == f"{file}: is no summary of a run or review: {what}; {ADVICE}"
    bag = tmp_path / "x.bag"
    assert complaint(bag) == (
        f"{bag}: is no summary of a run or review: it is a bag, and mrta review makes a summary of it; {ADVICE}"
    )


def _without_time(content: Dict[str, Any]) -> None:
    del content["time"]


def _texts_for_numbers(content: Dict[str, Any]) -> None:
    content["allocations"][0]["from"] = "soon"
    content["allocations"][0]["robot"] = 7


def _no_list(content: Dict[str, Any]) -> None:
    content["tasks"] = {"dig": "done"}


@pytest.mark.parametrize(
    ("spoil", "messages"),
    [
        (_without_time, ["time: is missing; give a mapping of known keys (start, end)"]),
        (
            _texts_for_numbers,
            [
                "allocations[0]/from: must be a number [s] (got 'soon'); YAML takes this for a text",
                "allocations[0]/robot: must be a text (got 7); put it in quotes",
            ],
        ),
        (_no_list, ["tasks: must be a list of mappings (id, state) (got {'dig': 'done'})"]),
    ],
)
def test_everything_that_is_wrong_in_a_summary_is_told(
    spoil: Callable[[Dict[str, Any]], None], messages: list[str], tmp_path: Path
) -> None:
    content = summary(allocations=[allocation("dig", "r1", 1.0, 2.0)])
    spoil(content)
    path = folder(tmp_path, "a", content)
    lines = complaint(path).splitlines()
    assert len(lines) == len(messages)
    for line, message in zip(lines, messages):
        assert line.startswith(f"{path / 'summary.json'}: {message}")


def test_robots_and_tasks_may_be_called_by_blanks(tmp_path: Path) -> None:
    """Some bag called them so; its review could once not be compared."""
    content = summary(tasks=[(" ", "done")], robots=[" "], allocations=[allocation(" ", " ", 2.0, 3.0)])
    content["incidents"] = [incident("rule", "error", 3.0, [" "], [" "])]
    side = read_side(folder(tmp_path, "a", content))
    assert (side.robots, side.tasks) == ((" ",), ((" ", "done"),))
    assert [(each.robot, each.task) for each in side.holdings] == [(" ", " ")]
    assert side.incidents[0].robots == (" ",)


def test_numbers_beyond_all_bounds_are_told(tmp_path: Path) -> None:
    path = folder(tmp_path, "a", summary())
    text = json.dumps(summary()).replace("101.0", "1e999")
    (path / "summary.json").write_text(text, encoding="utf-8")
    assert "time/end: must be a number [s] (got inf)" in complaint(path)


def test_a_whole_character_may_be_written_as_two_escapes(tmp_path: Path) -> None:
    content = {**summary(), "application": "yard \U0001f916"}
    path = folder(tmp_path, "a", content)
    assert "\\ud83e" in (path / "summary.json").read_text()
    assert read_side(path).application == "yard \U0001f916"


JSON = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=3),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=3), inner, max_size=3),
    max_leaves=6,
)


@settings(max_examples=50)
@given(st.sampled_from(sorted(summary())), st.sampled_from([None, "id", "from", "robots", "outcome", "start"]), JSON)
def test_whatever_stands_in_a_summary_is_read_or_told(key: str, inner: Optional[str], value: Any) -> None:
    content = summary(
        allocations=[allocation("dig", "r1", 1.0, 2.0)], incidents=[incident("odd", "info", 1.0, ["r1"], ["dig"])]
    )
    held = content[key]
    if inner is not None and held and isinstance(held, list):
        held[0][inner] = value
    else:
        content[key] = value
    with tempfile.TemporaryDirectory() as made:
        path = Path(made) / "summary.json"
        path.write_text(json.dumps(content), encoding="utf-8")
        try:
            side = read_side(path)
        except ConfigError:
            return
    comparison = compare(side, side)
    assert comparison.worse == ()
    assert page(comparison, 1.0).encode("utf-8")
    json.dumps(document(comparison, 1.0), allow_nan=False)
