"""Memories and their text form."""

from __future__ import annotations

import contextlib
from typing import Dict, Tuple

import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st
from mrta_l_alliance.memory import NOTHING, Memory, Performance, read_memory, written

IDS = st.from_regex(r"[A-Za-z][A-Za-z0-9_/]{0,12}", fullmatch=True) | st.sampled_from(
    ["yes", "null", "1e3", "7", "~", "="]
)
PERFORMANCES = st.builds(
    Performance,
    st.lists(st.integers(1, 10**9).map(lambda milliseconds: milliseconds / 1000), max_size=4).map(tuple),
    st.integers(0, 9),
)


def test_a_performance_keeps_the_newest_trials() -> None:
    performance = NOTHING
    for time in (10.0, 11.0, 12.0, 13.0):
        performance = performance.with_time(time, 3)
    assert performance == Performance((11.0, 12.0, 13.0))
    assert performance.with_failure().attempts == 4


def test_a_memory_is_one_line_of_yaml() -> None:
    memory = Memory({("r2", "dig"): Performance((30.12345,), 1), ("r1", "dig"): Performance((12.5, 13.0))})
    text = written(memory)
    assert text == "{r1: {dig: {failures: 0, times: [12.5, 13.0]}}, r2: {dig: {failures: 1, times: [30.123]}}}"
    assert yaml.safe_load(text)["r2"]["dig"]["times"] == [30.123]


@settings(max_examples=30)
@given(st.dictionaries(st.tuples(IDS, IDS), PERFORMANCES, max_size=5))
def test_a_memory_reads_as_it_was_written(known: Dict[Tuple[str, str], Performance]) -> None:
    text = written(Memory(known))
    assert "\n" not in text
    assert read_memory(text) == Memory(known)


@pytest.mark.parametrize("text", ["", "{}", "  ", "r1:", "# nothing yet"])
def test_nothing_known_is_an_empty_memory(text: str) -> None:
    assert read_memory(text) == Memory()


def test_a_memory_may_be_written_by_hand() -> None:
    memory = read_memory("r1:\n  dig:\n    times: [12, 13.5]\n  fill: {failures: 2}\n")
    assert memory.of("r1", "dig") == Performance((12.0, 13.5))
    assert memory.of("r1", "fill") == Performance((), 2)
    assert memory.of("r1", "pave") == NOTHING


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("[1, 2]", "it: must be a mapping (got [1, 2])"),
        ("{r1: 5}", "r1: must be a mapping (got 5)"),
        ("{1: {}}", "it: every key must be the id of a robot or task (got 1)"),
        ("{r1: {dig: [3]}}", "r1/dig: must be a mapping (got [3])"),
        ("{r1: {dig: {time: [3]}}}", "r1/dig: 'time' is unknown; there are times and failures"),
        ("{r1: {dig: {times: 3}}}", "r1/dig/times: must be a list of seconds above 0 (got 3)"),
        ("{r1: {dig: {times: [0.0]}}}", "r1/dig/times: must be a list of seconds above 0 (got [0.0])"),
        ("{r1: {dig: {times: [.nan]}}}", "r1/dig/times: must be a list of seconds above 0 (got [nan])"),
        ("{r1: {dig: {times: [1" + "0" * 400 + "]}}}", "r1/dig/times: must be a list of seconds above 0 (got [1"),
        ("{r1: {dig: {failures: -1}}}", "r1/dig/failures: must be a whole number, at least 0 (got -1)"),
        ("{r1: &x {}, r2: *x}", "must be YAML without aliases"),
        ("{r1: ", "must be YAML without tags (line "),
        ("[" * 100000, "must be YAML that is nested no deeper than 4 levels"),
        ("!!python/object/apply:os.system [ls]", "must be YAML without tags (line 1, column 1)"),
        ("a" * 1000001, "must be no longer than 1000000 letters (got 1000001)"),
    ],
)
def test_a_text_that_is_no_memory_is_refused_in_one_line(text: str, message: str) -> None:
    with pytest.raises(ValueError, match=r"must be|unknown") as refusal:
        read_memory(text)
    assert str(refusal.value).startswith(message)
    assert "\n" not in str(refusal.value)
    assert len(str(refusal.value)) < 160


@given(st.text(max_size=60))
def test_any_text_is_read_or_refused(text: str) -> None:
    """Refused with a ValueError, nothing else."""
    with contextlib.suppress(ValueError):
        assert all(time > 0.0 for _, _, each in read_memory(text) for time in each.times)
