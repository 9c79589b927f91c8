"""What a bag tells of loose bodies: nothing where a scenario has none."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Dict, List, Tuple

import pytest

from rqt_mrta_py.transport import RosCodec, read_bag
from tests.app.outputs import Mrta
from tests.transport.support import lookup

BODIES = """bodies:
  - {id: tin, kind: metal, x: 3.0, y: 0.5, size: [0.1, 0.1, 0.1]}
  - {id: cup, kind: paper, x: -3.0, y: -0.5, size: [0.1, 0.1, 0.06]}
"""
DETECTOR = "    - {kind: detector, topic: detections, rate: 4, max_range: 20, fov: 6.28, position_noise: 0}\n"

Messages = List[Tuple[float, str, Dict[str, Any]]]


def told(bag: Path, *topics: str) -> Messages:
    """Give mission time, topic and content of what was said on some topics."""
    codec = RosCodec(lookup)
    return [
        (receipt_ns / 1e9 - 1.0, connection.topic, codec.decode(connection, raw))
        for connection, receipt_ns, raw in read_bag(bag)
        if connection.topic in topics
    ]


def run(mrta: Mrta, yard: Path, out: Path, scenario: str) -> Path:
    (yard / "scenario.yaml").write_text(scenario)
    arguments = ["--world", "planar", "--duration", "1", "--pictures", "0", "--out", str(out)]
    assert mrta("run", "yard", *arguments)[0] == 0
    return out / "mission.bag"


def test_bag_tells_where_bodies_are_what_detectors_see_and_what_grippers_hold(
    mrta: Mrta, yard: Path, tmp_path: Path
) -> None:
    scenario = (yard / "scenario.yaml").read_text().replace("model: diff_drive\n", "model: carrier\n")
    scenario = scenario.replace("  sensors:\n", f"  sensors:\n{DETECTOR}", 1)
    bag = run(mrta, yard, tmp_path / "out", BODIES + scenario)
    truth = told(bag, "/simulation/bodies")
    assert [time for time, _, _ in truth] == pytest.approx([0.0, 0.5, 1.0])
    cup, tin = truth[0][2]["detections"]
    assert (cup["id"], cup["kind"], cup["position"]) == ("cup", "paper", {"x": -3.0, "y": -0.5, "z": 0.03})
    assert (tin["id"], tin["kind"], tin["position"]) == ("tin", "metal", {"x": 3.0, "y": 0.5, "z": 0.05})
    seen = told(bag, *(f"/robot{number}/detections" for number in range(1, 6)))
    assert len(seen) == 5 * 5
    assert {body["id"] for _, _, fields in seen for body in fields["detections"]} == {"cup", "tin"}
    held = told(bag, "/robot1/gripper/state")
    assert [(time, fields) for time, _, fields in held] == [
        (pytest.approx(time), {"data": ""}) for time in (0.0, 0.5, 1.0)
    ]


def test_bag_of_a_scenario_without_bodies_says_nothing_of_any(mrta: Mrta, yard: Path, tmp_path: Path) -> None:
    bag = run(mrta, yard, tmp_path / "out", (yard / "scenario.yaml").read_text())
    topics = {connection.topic for connection, _, _ in read_bag(bag)}
    assert "/robot1/pose" in topics
    assert [topic for topic in topics if "bodies" in topic or "detections" in topic or "gripper" in topic] == []
