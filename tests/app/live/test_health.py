"""A supervisor's own health."""

from __future__ import annotations

import dataclasses
from typing import Any, Dict, Sequence, Tuple

import pytest

from rqt_mrta_py.app.compose import compose
from rqt_mrta_py.app.live.health import Counts, diagnostics, memory_in_use

HEALTHY = Counts(heard=3000, topics=100, mission="yard", recorded=2990, backlog=10, recording="/tmp/a.bag", drawn=3)


def told(counts: Counts, waits: Sequence[float]) -> Dict[str, Tuple[int, str, Dict[str, str]]]:
    before = dataclasses.replace(HEALTHY, heard=1000, recorded=1000, drawn=1)
    message = diagnostics("/supervisor", 5.0, counts, before, seconds=2.0, waits=waits)
    assert message.topic == "/diagnostics"
    codec = compose().codec()
    connection = codec.connection(message.topic, message.type)
    fields = codec.decode(connection, codec.encode(message.type, message.fields))
    assert fields["header"]["stamp"] == 5.0
    return {
        each["name"]: (each["level"], each["message"], {pair["key"]: pair["value"] for pair in each["values"]})
        for each in fields["status"]
    }


def test_healthy_supervisor_says_how_much_it_does() -> None:
    status = told(HEALTHY, [0.001, 0.003])
    assert list(status) == [f"supervisor: {part}" for part in ("stream", "hearing", "recording", "pictures", "memory")]
    assert [level for level, _, _ in status.values()] == [0, 0, 0, 0, 0]
    assert status["supervisor: stream"][2]["messages a second"] == "1000.0"
    hearing = status["supervisor: hearing"][2]
    assert (hearing["wait, mean [ms]"], hearing["wait, longest [ms]"]) == ("2.0", "3.0")
    assert status["supervisor: recording"][2]["waiting"] == "10"


@pytest.mark.parametrize(
    ("change", "waits", "part", "level", "message"),
    [
        ({"mission": ""}, (), "stream", 1, "waits for somebody to say what the mission is"),
        ({"heard": 1000}, (), "stream", 1, "hears nothing"),
        ({"unreadable": 1}, (), "stream", 1, "cannot read all that it hears"),
        ({}, (0.2,), "hearing", 1, "messages wait to be heard"),
        ({"unrecorded": 5}, (), "recording", 1, "drops messages"),
        ({"failure": "the disk is full"}, (), "recording", 2, "has ended: the disk is full"),
        ({"undrawn": 1}, (), "pictures", 1, "pictures take longer than their period"),
        ({"kept_dropped": 1}, (), "memory", 1, "snapshots reach less far back than wanted"),
    ],
)
def test_what_is_wrong_is_said_where_it_is(
    change: Dict[str, Any], waits: Tuple[float, ...], part: str, level: int, message: str
) -> None:
    status = told(dataclasses.replace(HEALTHY, **change), list(waits))
    assert status[f"supervisor: {part}"][:2] == (level, message)


def test_memory_of_this_process_is_known() -> None:
    assert memory_in_use() > 1_000_000
