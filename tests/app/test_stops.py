"""A stopped robot is silent on all its topics, whenever it stops and returns."""

from __future__ import annotations

from pathlib import Path
from typing import Any, List, Tuple

import pytest

from rqt_mrta_py.transport import RosCodec, read_bag
from tests.app.outputs import Mrta

TICK = 0.05


def heard_of(bag: Path, robot: str) -> List[float]:
    """Give the mission times at which a robot said something: in its namespace, by its nodes, or as a transform."""
    codec = RosCodec(lambda type_name: None)
    times = set()
    for connection, receipt_ns, raw in read_bag(bag):
        said = connection.topic.startswith(f"/{robot}/") or connection.caller.startswith(f"/{robot}/")
        if connection.topic == "/tf":
            frames = {transform["child_frame_id"] for transform in codec.decode(connection, raw)["transforms"]}
            said = said or any(frame.startswith(f"{robot}/") for frame in frames)
        if said:
            times.add(receipt_ns / 1e9 - 1.0)
    return sorted(times)


@pytest.mark.parametrize(
    ("events", "silent"),
    [
        ([(0, "stops"), (1, "returns")], [(0.0, 1.0)]),
        ([(0.5, "stops")], [(0.5, 99.0)]),
        ([(0.5, "stops"), (0.8, "stops"), (1.0, "returns"), (1.3, "returns")], [(0.5, 1.3)]),
        ([(1.0, "stops"), (1.0, "returns")], []),
        ([(2.0, "stops")], [(2.0, 99.0)]),
    ],
    ids=["from the first tick", "for good", "overlapping stops", "stop and return in one tick", "at the last tick"],
)
def test_a_robot_is_silent_exactly_while_it_is_stopped(
    mrta: Mrta, yard: Path, tmp_path: Path, events: List[Tuple[float, Any]], silent: List[Tuple[float, Any]]
) -> None:
    scenario = yard / "scenario.yaml"
    text, _, _ = scenario.read_text().partition("events:")
    lines = [f"  - {{time: {time}, kind: robot_{kind}, robot: robot1}}" for time, kind in events]
    scenario.write_text("\n".join([text + "events:", *lines, ""]))
    status, _ = mrta("run", "yard", "--duration", "2", "--pictures", "0", "--out", str(tmp_path / "out"))
    assert status == 0
    times = heard_of(tmp_path / "out" / "mission.bag", "robot1")
    ticks = [tick * TICK for tick in range(41)]
    awake = [tick for tick in ticks if not any(begin - 1e-9 <= tick < end - 1e-9 for begin, end in silent)]
    assert [time for time in times if min(abs(time - tick) for tick in awake) > 1e-6] == []
    # Its sensors speak at 10 Hz, so while it is awake no pause is longer than a tenth of a second.
    wished = [tick for tick in awake if round(tick / TICK) % 2 == 0]
    assert [tick for tick in wished if min(abs(time - tick) for time in times) > 1e-6] == []
