"""Clocks that are off and robots that fall silent in a whole mission, in its run and in the review of its bag."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any, Dict, Iterator, List, Tuple

import pytest

from rqt_mrta_py.app.cli.main import main
from tests.app.outputs import Outputs

SCENARIO = """
events:
  - {time: 3.0, kind: robot_clock_shifts, robot: robot2, parameters: {offset: 5}}
  - {time: 3.0, kind: robot_clock_shifts, robot: robot3, parameters: {offset: -4}}
  - {time: 13.0, kind: robot_clock_shifts, robot: robot3, parameters: {offset: 0}}
"""


@pytest.fixture(scope="module")
def packages(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """Put an application on the path in which clocks are set wrong."""
    packages = tmp_path_factory.mktemp("packages")
    root = Path(__file__).resolve().parents[2]
    shutil.copytree(str(root / "plugins" / "applications" / "border_patrol"), str(packages / "untimely"))
    manifest = packages / "untimely" / "package.xml"
    manifest.write_text(manifest.read_text().replace("<name>border_patrol</name>", "<name>untimely</name>"))
    scenario = packages / "untimely" / "scenario.yaml"
    scenario.write_text(scenario.read_text().partition("events:")[0] + SCENARIO)
    with pytest.MonkeyPatch.context() as monkeypatch:
        monkeypatch.setenv("ROS_PACKAGE_PATH", str(packages))
        yield packages


@pytest.fixture(scope="module")
def untimely(packages: Path, tmp_path_factory: pytest.TempPathFactory) -> Tuple[Outputs, Outputs]:
    """Run it for 18 s, and review it."""
    folder = tmp_path_factory.mktemp("untimely")
    run, review = folder / "run", folder / "review"
    command = ["run", "untimely", "--world", "planar", "--duration", "18", "--pictures", "0", "--out", str(run), "-q"]
    assert main(command) == 0
    assert main(["review", str(run / "mission.bag"), "--pictures", "0", "--out", str(review), "-q"]) == 0
    return Outputs(run), Outputs(review)


def incidents(outputs: Outputs) -> List[Dict[str, Any]]:
    rules = ("message_from_the_future", "message_from_the_past", "topic_gap")
    return [each for each in outputs.summary["incidents"] if each["rule"] in rules]


def test_each_robot_whose_clock_is_off_is_named_once(untimely: Tuple[Outputs, Outputs]) -> None:
    run, review = untimely
    found = {each["rule"]: each for each in incidents(run)}
    assert len(incidents(run)) == 2
    future, past = found["message_from_the_future"], found["message_from_the_past"]
    # Mission second s carries stamp s + 1.
    assert (future["robots"], past["robots"]) == (["robot2"], ["robot3"])
    assert future["from"] == pytest.approx(4.0, abs=0.21)
    assert future["to"] == run.summary["time"]["end"]
    assert "up to 5.0 s" in future["text"]
    # Slewed at half speed it is 1 s behind after 2 s, and 4 s after 8 s; set right it jumps.
    assert past["from"] == pytest.approx(6.0, abs=0.31)
    assert past["to"] == pytest.approx(14.0, abs=0.21)
    assert incidents(review) == incidents(run)


def test_the_table_of_a_review_tells_whose_clock_is_off(untimely: Tuple[Outputs, Outputs]) -> None:
    run, review = untimely
    assert not (run.folder / "clocks.json").exists()
    table = json.loads((review.folder / "clocks.json").read_text(encoding="utf-8"))
    assert table["schema"] == "rqt_mrta_py/clocks/1"
    clocks = {each["id"]: each for each in table["robots"]}
    assert list(clocks) == ["robot1", "robot2", "robot3", "robot4", "robot5"]
    for robot in ("robot1", "robot4", "robot5"):
        assert (clocks[robot]["offset"], clocks[robot]["at_least"], clocks[robot]["drift"]) == (0.0, 0.0, 0.0)
    assert clocks["robot2"]["at_least"] == 5.0
    assert clocks["robot2"]["offset"] == pytest.approx(5.0, abs=0.01)
    odom = next(each for each in table["connections"] if each["topic"] == "/robot1/odom")
    assert odom["robot"] == "robot1"
    assert (odom["jitter"], odom["gaps"]) == (0.0, 0)
    assert odom["rate"] == pytest.approx(1.0 / odom["period"], rel=0.01)
    assert odom["sources"] == ["receipt", "header stamp"]
    plain = next(each for each in table["connections"] if each["topic"] == "/robot1/cmd_vel")
    assert (plain["sources"], plain["clock"]) == (["receipt"], None)
