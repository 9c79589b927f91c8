"""Bags of one mission as the command takes them: several, in parts, cut short, a range of them, some topics."""

from __future__ import annotations

import json
import random
from pathlib import Path
from typing import Any, Dict, List

import pytest

from rqt_mrta_py.hooks import Stamped
from rqt_mrta_py.transport import BagWriter, read_bag
from tests.app.outputs import Mrta, Outputs

SAME = ("summary.json", "events.jsonl", "incidents.jsonl")


def write(path: Path, messages: List[Stamped]) -> Path:
    with BagWriter(path) as bag:
        for stamped in messages:
            bag.write(stamped)
    return path


def review(mrta: Mrta, *arguments: object) -> Dict[str, Any]:
    status, lines = mrta("review", *map(str, arguments), "--pictures", "0", "--out", "out", "--force", "-q")
    assert status == 0, lines
    return {
        **{name: Path("out", name).read_text(encoding="utf-8") for name in (*SAME, "review.json")},
        "lines": lines,
    }


@pytest.fixture(scope="module")
def stream(patrol: Outputs) -> List[Stamped]:
    return list(read_bag(patrol.bag))


@pytest.mark.parametrize("way", ["parts", "robots"])
def test_several_bags_are_reviewed_as_one(
    mrta: Mrta, patrol: Outputs, stream: List[Stamped], tmp_path: Path, way: str
) -> None:
    """A recording in three parts, given in any order; recordings of some topics each, one for a third of them."""
    count = len(stream)
    if way == "parts":
        thirds = [stream[: count // 3], stream[count // 3 : count // 2], stream[count // 2 :]]
        bags = [write(tmp_path / f"mission_{number}.bag", part) for number, part in enumerate(thirds)]
        random.Random(1).shuffle(bags)
    else:
        # Messages of one moment keep the order of the bags; here they are all of topics of the same bag.
        halves = [[each for each in stream if (each.receipt_ns // 50_000_000) % 2 == half] for half in (0, 1)]
        bags = [write(tmp_path / f"half{number}.bag", part) for number, part in enumerate(halves)]
    found = review(mrta, *bags)
    for name in SAME:
        assert found[name] == (patrol.folder / name).read_text(encoding="utf-8")
    assert [bag["messages"] for bag in json.loads(found["review.json"])["bags"]] == [
        len(list(read_bag(bag))) for bag in bags
    ]


def test_a_part_alone_says_that_there_are_more(mrta: Mrta, stream: List[Stamped], tmp_path: Path) -> None:
    for number in range(2):
        write(tmp_path / f"mission_{number}.bag", stream[:500])
    found = review(mrta, tmp_path / "mission_0.bag")
    note = "there are more parts of this recording: mission_1.bag; give them too"
    assert found["lines"] == [f"mrta: {tmp_path / 'mission_0.bag'}: {note}"]
    status, lines = mrta("review", str(tmp_path / "mission.bag"))
    names = f"{tmp_path / 'mission_0.bag'} {tmp_path / 'mission_1.bag'}"
    assert (status, lines) == (
        2,
        [f"mrta: {tmp_path / 'mission.bag'}: no such file, but it was recorded in parts; give {names}"],
    )


def test_a_bag_given_twice_is_wrong_usage(mrta: Mrta, patrol: Outputs) -> None:
    again = patrol.folder / "." / "mission.bag"
    assert mrta("review", str(patrol.bag), str(again))[0] == 2


def test_a_bag_that_lost_its_end_is_reviewed_and_says_so(mrta: Mrta, patrol: Outputs, tmp_path: Path) -> None:
    whole = patrol.bag.read_bytes()
    cut = tmp_path / "cut.bag"
    cut.write_bytes(whole[: len(whole) // 2])
    found = review(mrta, cut)
    account = json.loads(found["review.json"])
    assert account["bags"][0]["indexed"] is False
    assert account["bags"][0]["bytes_missing"] > 0
    assert found["lines"][0] == f"mrta: {cut}: has no index that can be read, so its records are walked over"
    assert any("are missing" in line for line in found["lines"])
    # What happened up to there is what the run itself reported.
    events = found["events.jsonl"].splitlines()
    assert len(events) > 10
    assert events[:-5] == (patrol.folder / "events.jsonl").read_text(encoding="utf-8").splitlines()[: len(events) - 5]


def test_a_range_and_some_topics_are_reviewed_alone(mrta: Mrta, patrol: Outputs) -> None:
    found = review(
        mrta, patrol.bag, "--from", "20", "--to", "40.5", "--topics", "*/alliance/*", "--topics", "!/robot2/*"
    )
    account = json.loads(found["review.json"])
    assert account["excerpt"] == {"from": 20.0, "to": 40.5, "topics": ["*/alliance/*", "!/robot2/*"]}
    start = float(patrol.summary["time"]["start"])
    time = json.loads(found["summary.json"])["time"]
    assert start + 20.0 <= time["start"] <= time["end"] <= start + 40.5
    inside = [
        stamped
        for stamped in read_bag(patrol.bag)
        if "/alliance/" in stamped.connection.topic
        and not stamped.connection.topic.startswith("/robot2/")
        and 20.0 <= round(stamped.receipt_ns / 1e9 - start, 9) <= 40.5
    ]
    assert account["messages"] == len(inside) > 100


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("--from", "1000"), "--from 1000: leaves nothing to review; there are 150 s, and --to must not be less"),
        (
            ("--from", "20", "--to", "10"),
            "--from 20: leaves nothing to review; there are 150 s, and --to must not be less",
        ),
        (("--topics", "/nope"), "--topics: names no topic of "),
    ],
)
def test_an_excerpt_that_is_empty_is_wrong_usage(mrta: Mrta, patrol: Outputs, arguments: Any, message: str) -> None:
    status, lines = mrta("review", str(patrol.bag), *arguments)
    assert status == 2
    assert lines[0].startswith(f"mrta: {message}")
