"""Private parameters of a supervisor."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Dict

from rqt_mrta_py.app.live.options import LiveOptions, ParameterReader, read_options


def reader_of(**values: Any) -> ParameterReader:
    served: Dict[str, Any] = {f"~{name}": value for name, value in values.items()}
    return ParameterReader(served.get)


def test_nothing_given_gives_the_defaults() -> None:
    assert read_options(reader_of()) == LiveOptions()


def test_empty_texts_count_as_not_given() -> None:
    """A launch file has no other way to say nothing."""
    assert read_options(reader_of(application="", record="", pictures="", topics="")) == LiveOptions()


def test_values_are_read() -> None:
    reader = reader_of(
        application="border_patrol", record="/tmp/bags", pictures=2, snapshot_megabytes="8", topics="/clock, !/tf"
    )
    options = read_options(reader)
    assert (options.application, options.record, options.pictures) == ("border_patrol", Path("/tmp/bags"), 2.0)
    assert options.snapshot_bytes == 8 * 2**20
    assert (options.topics.named, options.topics.left_out) == (("/clock",), ("/tf",))
    assert reader.problems == []


def test_values_of_a_wrong_type_are_told_and_not_used() -> None:
    reader = reader_of(application=7, pictures=True, snapshot_seconds=-1.0, record=["a"], topics={"a": 1})
    assert read_options(reader) == LiveOptions()
    assert sorted(reader.problems) == [
        "parameter ~application: must be a text (got 7); nothing is used",
        "parameter ~pictures: must be a number of 0 or more (got True); 1.0 is used",
        "parameter ~record: must be a text (got ['a']); nothing is used",
        "parameter ~snapshot_seconds: must be a number of 0 or more (got -1.0); 30.0 is used",
        "parameter ~topics: must be a text, or a list of texts (got {'a': 1}); nothing is used",
    ]
