"""Bags recorded on robots, by the robots' own clocks."""

from __future__ import annotations

import json
from pathlib import Path
from typing import List, Optional, Tuple

import pytest

from rqt_mrta_py.app.review.hosts import host_of
from rqt_mrta_py.hooks import Stamped
from rqt_mrta_py.transport import BagWriter, RosCodec
from tests.app.outputs import Mrta

MS = 10**6
AHEAD = 5_000 * MS
"""By how much robot2's clock is ahead of robot1's [ns]."""
LATENCIES = {("robot1", "robot1"): (0,), ("robot2", "robot2"): (0,), ("robot2", "robot1"): (9, 3, 40, 6)}
LATENCIES["robot1", "robot2"] = (8, 30, 12, 9)
"""How long messages take from one robot to another, over and over [ms]."""


def record(root: Path, path: Path, receiver: str) -> Path:
    """Record what both robots say, ten times a second for 4 s, by the clock of one."""

    def definition(type_name: str) -> Optional[str]:
        package, _, name = type_name.partition("/")
        file = root / "plugins" / "messages" / package / "msg" / f"{name}.msg"
        return file.read_text(encoding="utf-8") if file.exists() else None

    codec = RosCodec(definition)
    messages: List[Stamped] = []
    for sender in ("robot1", "robot2"):
        made = codec.connection(
            "/alliance/inter_robot_communication",
            "alliance_msgs/InterRobotCommunication",
            f"/{sender}/alliance/high_level",
        )
        latencies = LATENCIES[sender, receiver]
        for tick in range(40):
            sent = 100_000 * MS + tick * 100 * MS
            stamp = sent + (AHEAD if sender == "robot2" else 0)
            receipt = sent + latencies[tick % len(latencies)] * MS + (AHEAD if receiver == "robot2" else 0)
            header = {"seq": tick, "stamp": stamp / 1e9, "frame_id": f"/{sender}"}
            said = {"header": header, "task_id": f"task_of_{sender}", "expected_duration": 60.0}
            messages.append(Stamped(made, receipt, codec.encode(made.type, said)))
    with BagWriter(path) as bag:
        for stamped in sorted(messages, key=lambda each: each.receipt_ns):
            bag.write(stamped)
    return path


def pairs(mrta: Mrta, *bags: Path) -> List[Tuple[str, str, float, float]]:
    arguments = ("--architecture", "mrta_alliance", "--pictures", "0", "--out", "out", "--force", "-q")
    status, lines = mrta("review", *map(str, bags), *arguments)
    assert status == 0, lines
    found = json.loads(Path("out/clocks.json").read_text(encoding="utf-8"))["pairs"]
    return [(each["id"], each["other"], each["at_least"], each["at_most"]) for each in found]


def test_clocks_of_robots_that_recorded_each_other_are_bounded_on_both_sides(
    root: Path, mrta: Mrta, tmp_path: Path
) -> None:
    """robot2's promptest message takes 3 ms, robot1's 8 ms: robot1's clock is behind by 4.997 s to 5.008 s."""
    first = record(root, tmp_path / "robot1_2026-05-04-10-00-00.bag", "robot1")
    second = record(root, tmp_path / "robot2.bag", "robot2")
    expected = [("robot1", "robot2", pytest.approx(-5.008, abs=1e-6), pytest.approx(-4.997, abs=1e-6))]
    assert pairs(mrta, first, second) == expected
    assert pairs(mrta, second, first) == expected
    page = Path("out/report.html").read_text(encoding="utf-8")
    assert "Clocks of robots that recorded each other" in page
    assert "-5,008" in page


def test_a_bag_that_is_named_after_no_robot_bounds_nothing(root: Path, mrta: Mrta, tmp_path: Path) -> None:
    first = record(root, tmp_path / "robot1.bag", "robot1")
    base = record(root, tmp_path / "base.bag", "robot2")
    assert pairs(mrta, first, base) == []
    assert pairs(mrta, first) == []
    assert "recorded each other" not in Path("out/report.html").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("stem", "host"),
    [
        ("robot1", "robot1"),
        ("robot1_0", "robot1"),
        ("robot1_2026-05-04-10-00-00_3", "robot1"),
        ("robot1-2", "robot1"),
        ("robot10", "robot10"),
        ("robot11", None),
        ("robot", None),
        ("robot1_base", None),
        ("base_robot1", None),
        ("team/robot1", None),
        ("scout_7", "scout_7"),
        ("scout_7_0", "scout_7"),
        ("scout_8", "scout"),
    ],
)
def test_names_of_bags_tell_their_robots(stem: str, host: Optional[str]) -> None:
    assert host_of(stem, ["robot1", "robot10", "scout", "scout_7"]) == host
