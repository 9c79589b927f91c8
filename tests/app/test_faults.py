"""A mission in which everything happens that a scenario can make happen."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any, Dict, Iterator, List, Tuple

import pytest

from rqt_mrta_py.app.cli.main import main
from rqt_mrta_py.transport import RosCodec, read_bag
from tests.app.outputs import Outputs

EVENTS: List[Tuple[float, str, str, str, str]] = [
    (1.0, "robot_sticks", "robot1", "", ""),
    (2.0, "robot_slows", "robot2", "", "{factor: 0.5}"),
    (2.5, "robot_clock_shifts", "robot4", "", "{offset: 3}"),
    (3.0, "robot_comes_free", "robot1", "", ""),
    (3.0, "radio_fails", "robot5", "", ""),
    (3.5, "radio_partitions", "", "", "{groups: [[robot1, robot2], [robot3, robot4]]}"),
    (4.0, "task_appears", "", "report", ""),
    (5.0, "radio_heals", "", "", ""),
    (5.0, "robot_clock_shifts", "robot4", "", "{offset: 0}"),
    (5.5, "radio_changes", "", "", "{kind: lossy, loss: 0.2, delay: 0.1, jitter: 0.1, duplicates: 0.1, range: 8}"),
    (6.0, "radio_returns", "robot5", "", ""),
    (6.0, "task_reassigned", "robot2", "border_protection", ""),
    (8.0, "task_withdrawn", "", "wander", ""),
    (9.0, "robot_stops", "robot3", "", ""),
    (10.0, "robot_returns", "robot3", "", ""),
    (11.0, "robot_removed", "robot5", "", ""),
    (11.0, "robot_removed", "robot3", "", ""),
]


def write_events(scenario: Path) -> None:
    text, _, _ = scenario.read_text().partition("events:")
    lines = [text + "events:"]
    for time, kind, robot, task, parameters in EVENTS:
        further = {"robot": robot, "task": task, "parameters": parameters}
        given = "".join(f", {key}: {value}" for key, value in further.items() if value)
        lines.append(f"  - {{time: {time}, kind: {kind}{given}}}")
    scenario.write_text("\n".join([*lines, ""]))


@pytest.fixture(scope="module")
def package(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """Put an application on the path in which everything happens."""
    packages = tmp_path_factory.mktemp("packages")
    root = Path(__file__).resolve().parents[2]
    shutil.copytree(str(root / "plugins" / "applications" / "border_patrol"), str(packages / "troubled"))
    manifest = packages / "troubled" / "package.xml"
    manifest.write_text(manifest.read_text().replace("<name>border_patrol</name>", "<name>troubled</name>"))
    write_events(packages / "troubled" / "scenario.yaml")
    with pytest.MonkeyPatch.context() as monkeypatch:
        monkeypatch.setenv("ROS_PACKAGE_PATH", str(packages))
        yield packages / "troubled"


def run(folder: Path) -> Outputs:
    command = ["run", "troubled", "--duration", "12", "--pictures", "4", "--seed", "3", "--out", str(folder), "-q"]
    assert main(command) == 0
    return Outputs(folder)


@pytest.fixture(scope="module")
def troubled(package: Path, tmp_path_factory: pytest.TempPathFactory) -> Outputs:
    """Run it for 12 s."""
    return run(tmp_path_factory.mktemp("troubled") / "out")


def heard(outputs: Outputs, topic: str) -> List[Tuple[float, str, Dict[str, Any]]]:
    """Give mission time of receipt, publisher and content of each message of a topic."""
    codec = RosCodec(lambda type_name: None)
    return [
        (receipt_ns / 1e9 - 1.0, connection.caller, codec.decode(connection, raw))
        for connection, receipt_ns, raw in read_bag(outputs.bag, topics=[topic])
    ]


def test_everything_that_happens_is_labelled_at_its_time(troubled: Outputs) -> None:
    labels = heard(troubled, "/mrta/scenario_event")
    told = [(time, label["kind"], label["robot_id"], label["task_id"]) for time, _, label in labels]
    assert told == [(pytest.approx(time), kind, robot, task) for time, kind, robot, task, _ in EVENTS]
    assert all(label["text"] for _, _, label in labels)


def test_operators_orders_are_given_at_their_times(troubled: Outputs) -> None:
    orders = [
        (time, fields["task_id"], fields["robot_id"], fields["progress"], bool(fields["task_yaml"]))
        for time, caller, fields in heard(troubled, "/mrta/task_progress")
        if caller == "/operator"
    ]
    appeared, withdrawn, reassigned = 4, 5, 6
    assert orders == [
        (pytest.approx(4.0), "report", "", appeared, True),
        (pytest.approx(6.0), "border_protection", "robot2", reassigned, False),
        (pytest.approx(8.0), "wander", "", withdrawn, False),
    ]


def test_operator_tells_who_was_taken_off_the_floor_and_it_says_nothing_more(troubled: Outputs) -> None:
    told = heard(troubled, "/mrta/robot_removed")
    assert told == [
        (pytest.approx(11.0), "/operator", {"data": "robot5"}),
        (pytest.approx(11.0), "/operator", {"data": "robot5 robot3"}),
    ]
    poses = [time for time, _, _ in heard(troubled, "/robot5/pose")]
    assert poses[-1] == pytest.approx(10.9)
    assert heard(troubled, "/robot4/pose")[-1][0] == pytest.approx(12.0)


def test_task_that_appears_later_is_in_the_books_from_then_on(troubled: Outputs) -> None:
    (mission,) = [fields for _, _, fields in heard(troubled, "/mrta/mission")]
    assert mission["tasks"] == ["wander", "border_protection"]
    states = {task["id"]: task for task in troubled.summary["tasks"]}
    assert troubled.mission_seconds(states["report"]["history"][0]["from"]) == pytest.approx(4.0)
    assert states["wander"]["state"] == "withdrawn"


def test_stamps_of_a_robot_are_those_of_its_own_clock(troubled: Outputs) -> None:
    """Its clock is 3 s ahead from 2.5 s on, and from 5 s on runs at half speed until it is right, at 11 s."""

    def offset(time: float) -> float:
        if time < 2.5 - 1e-6:
            return 0.0
        return 3.0 if time < 5.0 else max(0.0, 3.0 - (time - 5.0) / 2)

    for topic in ("/robot4/odom", "/robot4/pose", "/robot4/scan"):
        stamps = [(time, fields["header"]["stamp"] - time - 1.0) for time, _, fields in heard(troubled, topic)]
        assert len(stamps) == 121
        assert [late for _, late in stamps] == pytest.approx([offset(time) for time, _ in stamps], abs=1e-6)
    assert all(
        fields["header"]["stamp"] == pytest.approx(time + 1.0) for time, _, fields in heard(troubled, "/robot3/odom")
    )


def test_agent_of_a_robot_goes_by_the_robots_clock(troubled: Outputs) -> None:
    ahead = [
        fields["header"]["stamp"] - time - 1.0
        for time, _, fields in heard(troubled, "/robot4/alliance/motivation/wander")
        if 2.5 <= time < 5.0
    ]
    assert ahead
    assert ahead == pytest.approx([3.0] * len(ahead))


def test_stuck_robot_is_heard_where_it_is(troubled: Outputs) -> None:
    xs = [
        fields["pose"]["pose"]["position"]["x"]
        for time, _, fields in heard(troubled, "/robot1/odom")
        if 1.5 <= time < 3.0
    ]
    assert len(xs) == 15
    assert max(xs) - min(xs) < 0.01


@pytest.mark.parametrize("name", ["events.jsonl", "incidents.jsonl", "summary.json"])
def test_review_of_trouble_gives_the_same_bytes_as_the_run(troubled: Outputs, tmp_path: Path, name: str) -> None:
    review = tmp_path / "review"
    assert main(["review", str(troubled.bag), "--pictures", "0", "--out", str(review), "-q"]) == 0
    assert (review / name).read_bytes() == (troubled.folder / name).read_bytes()


def test_trouble_comes_the_same_way_again(troubled: Outputs, package: Path, tmp_path: Path) -> None:
    again = run(tmp_path / "again")
    assert again.bag.read_bytes() == troubled.bag.read_bytes()
