"""What a bag is about that says nothing of itself."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Callable, List

import pytest

from rqt_mrta_py.app.compose import Host, compose
from rqt_mrta_py.app.review.inference import fit_of, guess
from rqt_mrta_py.app.review.recordings import Recordings
from rqt_mrta_py.config.mission import load_observed
from rqt_mrta_py.hooks import Stamped
from rqt_mrta_py.transport import BagWriter, read_bag
from tests.app.outputs import Mrta, Outputs

TOPICS_ALONE = """<rqt_mrta><architecture><name>Mine</name>
  <robots><type>ST</type>
    <busy_robots><topic><name>/jobs/@robot_id@</name><type>std_msgs/String</type><task_field>data</task_field>
      <timeout>2.0</timeout></topic></busy_robots>
  </robots>
  <tasks><type>SR</type></tasks><allocations><type>IA</type></allocations>
</architecture></rqt_mrta>
"""


@pytest.fixture(scope="module")
def host() -> Host:
    return compose()


def without_mission(source: Path, target: Path) -> Path:
    with BagWriter(target) as bag:
        for stamped in read_bag(source):
            if not stamped.connection.topic.startswith("/mrta/"):
                bag.write(stamped)
    return target


def test_robots_and_tasks_of_a_silent_bag_tell_its_application(mrta: Mrta, patrol: Outputs, tmp_path: Path) -> None:
    bag = without_mission(patrol.bag, tmp_path / "silent.bag")
    status, lines = mrta("review", str(bag), "--pictures", "0", "--out", "out", "-q")
    assert status == 0
    (line,) = lines
    assert line.startswith(
        f"mrta: {bag}: says nothing of itself; it is read as application border_patrol under mrta_alliance, "
        "for 2 of its 2 monitored topics are there with "
    )
    robots = ", ".join(robot["id"] for robot in patrol.summary["robots"])
    assert f"robots {robots} with tasks" in line
    assert "mrta_l_alliance would fit as well, --architecture chooses" in line
    account = json.loads(Path("out/review.json").read_text(encoding="utf-8"))
    assert account["mission"]["source"] == "inferred"
    allocations = json.loads(Path("out/summary.json").read_text(encoding="utf-8"))["allocations"]
    assert len(allocations) >= 5


@pytest.mark.parametrize(
    ("bag", "architecture", "found"),
    [("alliance_two_robots.bag", "mrta_alliance", 2), ("talmech_two_bidders.bag", "talmech_auction", 6)],
)
def test_recordings_of_original_nodes_are_known_by_their_topics(
    host: Host, shared_data: Callable[[str], Path], bag: str, architecture: str, found: int
) -> None:
    connections = Recordings([shared_data(bag)]).connections
    guessed = guess(host, connections, host.codec())
    assert guessed is not None
    assert (guessed.architecture, guessed.application) == (architecture, None)
    assert guessed.why.startswith(f"{found} of its ")


def test_a_topic_counts_only_with_its_type_and_its_fields(host: Host) -> None:
    codec = host.codec()
    spec = load_observed(host.registry, "mrta_alliance").architecture
    right = codec.connection("/alliance/inter_robot_communication", "alliance_msgs/InterRobotCommunication")
    other = codec.connection("/alliance/inter_robot_communication", "std_msgs/String")
    assert (fit_of(spec, {right: 7}, codec).score, fit_of(spec, {right: 7}, codec).messages) == ((1, -1), 7)
    assert not fit_of(spec, {other: 7}, codec).telling
    assert not fit_of(spec, {right: 0}, codec).telling


def bag_of_jobs(path: Path, host: Host) -> Path:
    codec = host.codec()
    with BagWriter(path) as bag:
        for tick in range(100):
            for robot, job in (("ann", "dig"), ("bob", "carry")):
                connection = codec.connection(f"/jobs/{robot}", "std_msgs/String", "/somebody")
                bag.write(Stamped(connection, (100 + tick) * 10**8, codec.encode("std_msgs/String", {"data": job})))
    return path


def test_a_bag_that_fits_nothing_says_what_to_give(mrta: Mrta, host: Host, tmp_path: Path) -> None:
    bag = bag_of_jobs(tmp_path / "jobs.bag", host)
    status, lines = mrta("review", str(bag))
    assert status == 2
    assert lines == [
        f"mrta: {bag}: does not say what it is about (no message on /mrta/mission); give --application or "
        "--architecture, a registered name or an rqt_mrta.xml; no registered architecture fits its topics and types"
    ]


def test_a_file_of_topics_and_fields_is_enough(mrta: Mrta, host: Host, tmp_path: Path) -> None:
    bag = bag_of_jobs(tmp_path / "jobs.bag", host)
    file = tmp_path / "rqt_mrta.xml"
    file.write_text(TOPICS_ALONE, encoding="utf-8")
    status, _ = mrta("review", str(bag), "--architecture", str(file), "--pictures", "0", "--out", "out", "-q")
    assert status == 0
    summary = json.loads(Path("out/summary.json").read_text(encoding="utf-8"))
    held: List[List[str]] = [[each["robot"], each["task"]] for each in summary["allocations"]]
    assert held == [["ann", "dig"], ["bob", "carry"]]
    assert [robot["id"] for robot in summary["robots"]] == ["ann", "bob"]
