"""A supervisor told what a team says, with time passing between messages and without: it records what it reports."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, Dict, List, Tuple, cast

import pytest

from rqt_mrta_py.app.compose import Host, compose
from rqt_mrta_py.app.live.live_supervisor import LiveSupervisor
from rqt_mrta_py.app.live.options import LiveOptions
from rqt_mrta_py.app.mission_message import mission_from_fields, mission_message
from rqt_mrta_py.app.review.review import ReviewRequest, review_bag
from rqt_mrta_py.config.mission import load_mission
from rqt_mrta_py.hooks import Codec, Outgoing, Stamped
from rqt_mrta_py.model import Mission, Progress
from rqt_mrta_py.transport import read_bag
from rqt_mrta_py.transport.ros1 import RosNode
from tests.app.live.still_node import StillNode
from tests.app.outputs import Outputs

NS = 1_000_000_000


@pytest.fixture(scope="module")
def host() -> Host:
    return compose()


@pytest.fixture
def codec(host: Host) -> Codec:
    return host.codec()


@pytest.fixture
def node(codec: Codec) -> StillNode:
    return StillNode(codec)


@pytest.fixture
def mission(host: Host) -> Mission:
    return load_mission(host.registry, "border_patrol", seed=None)


def supervisor_of(node: StillNode, host: Host, **options: Any) -> LiveSupervisor:
    return LiveSupervisor(cast(RosNode, node), host, LiveOptions(pictures=0.0, **options))


def said_by_the_team(bag: Path, until: float) -> List[Stamped]:
    """Read what everybody but the supervisor said in the first seconds [s]."""
    messages = [each for each in read_bag(bag) if each.connection.caller != "/supervisor"]
    end = messages[0].receipt_ns + round(until * NS)
    return [each for each in messages if each.receipt_ns < end]


def files_of(folder: Path) -> Tuple[Dict[str, Any], List[str], List[str]]:
    summary = json.loads((folder / "summary.json").read_text())
    events, incidents = ((folder / f"{name}.jsonl").read_text().splitlines() for name in ("events", "incidents"))
    return summary, events, incidents


def test_review_of_its_recording_gives_what_it_reported(
    patrol: Outputs, node: StillNode, host: Host, tmp_path: Path
) -> None:
    """Robot3 is lost at 60 s: between its last message and the next one of another robot, time passes by the clock."""
    messages = said_by_the_team(patrol.bag, 70.0)
    fields = node.codec.decode(messages[0].connection, messages[0].raw)
    mission = mission_from_fields(fields)
    supervisor = supervisor_of(node, host, record=tmp_path / "live.bag", out=tmp_path / "live")
    node.time = messages[0].receipt_ns / NS
    supervisor.begin(mission, float(fields["duration"]))
    for message in messages:
        while node.time + 0.05 < message.receipt_ns / NS:
            node.time += 0.05
            supervisor.look_at_clock()
        node.time = message.receipt_ns / NS
        if node.wanted(message.connection.topic, message.connection.type):
            node.tell(message)
    node.time += 1.0
    result = supervisor.finish()
    assert result is not None
    review = review_bag(
        host, ReviewRequest(tmp_path / "live.bag", pictures=0, out=tmp_path / "review"), lambda *_: None
    )
    assert files_of(review.folder) == files_of(result.folder)
    summary, _, incidents = files_of(result.folder)
    assert [json.loads(line)["rule"] for line in incidents] == ["robot_silent_with_task"]
    as_run = [each for each in patrol.summary["allocations"] if each["from"] < summary["time"]["end"] - 1.0]
    keys = ("task", "robot", "from")
    assert [[each[key] for key in keys] for each in summary["allocations"]] == [
        [each[key] for key in keys] for each in as_run
    ]


def test_news_is_said_while_the_message_that_makes_it_is_heard(node: StillNode, host: Host, mission: Mission) -> None:
    supervisor = supervisor_of(node, host)
    node.time = 10.0
    supervisor.begin(mission, None, announce=True)
    node.said.clear()
    node.tell(order(node, Progress.DONE, 10.5))
    topics = [topic for topic, _ in node.said]
    assert "/mrta/task_state" in topics
    assert "/mrta/event" in topics


def test_what_is_said_again_and_again_waits_for_a_look_at_the_clock(
    node: StillNode, host: Host, mission: Mission
) -> None:
    supervisor = supervisor_of(node, host)
    node.time = 10.0
    supervisor.begin(mission, None, announce=True)
    node.tell(order(node, Progress.RUNNING, 10.1))
    before = heard(supervisor)
    node.tell(order(node, Progress.RUNNING, 10.2))
    assert heard(supervisor) == before
    node.tell(order(node, Progress.DONE, 10.3))
    assert heard(supervisor) > before + 1


def test_expiry_is_said_without_any_message(node: StillNode, host: Host, mission: Mission) -> None:
    """A robot is idle for 2 s after its last motivation, as the architecture's file says."""
    supervisor = supervisor_of(node, host)
    node.time = 10.0
    supervisor.begin(mission, None, announce=True)
    connection = node.codec.connection(
        "/robot1/alliance/motivation/wander", "alliance_msgs/Motivation", "/robot1/agent"
    )
    node.tell(Stamped(connection, 11 * NS, node.codec.encode(connection.type, {})))
    node.said.clear()
    node.time = 12.9
    supervisor.look_at_clock()
    assert states_told(node) == []
    node.time = 13.1
    supervisor.look_at_clock()
    assert states_told(node) == [("robot1", 0, 13.0)]


def test_stream_goes_on_when_time_goes_back(node: StillNode, host: Host, mission: Mission, tmp_path: Path) -> None:
    supervisor = supervisor_of(node, host, record=tmp_path / "bag.bag")
    node.time = 100.0
    supervisor.begin(mission, None, announce=True)
    node.tell(order(node, Progress.RUNNING, 101.0))
    node.time = 5.0
    supervisor.jumped(101.0, 5.0)
    node.time = 6.0
    node.tell(order(node, Progress.DONE, 6.0))
    supervisor.finish()
    told = [each.receipt_ns / NS for each in read_bag(tmp_path / "bag.bag", topics=["/mrta/task_progress"])]
    assert told == [101.0, 102.0]


def test_messages_before_the_first_time_of_a_simulated_clock_come_with_it(
    node: StillNode, host: Host, mission: Mission, tmp_path: Path
) -> None:
    supervisor = supervisor_of(node, host, record=tmp_path / "bag.bag")
    supervisor.begin(mission, None, announce=True)
    node.tell(order(node, Progress.RUNNING, 0.0))
    supervisor.look_at_clock()
    node.time = 1.0
    supervisor.look_at_clock()
    supervisor.finish()
    first = [(each.connection.topic, each.receipt_ns) for each in read_bag(tmp_path / "bag.bag")][:2]
    assert first == [("/mrta/mission", NS), ("/mrta/task_progress", NS)]


def test_error_leaves_a_bag_of_what_led_to_it(node: StillNode, host: Host, mission: Mission, tmp_path: Path) -> None:
    supervisor = supervisor_of(node, host, snapshots=tmp_path / "snapshots", snapshot_seconds=10.0)
    node.time = 10.0
    supervisor.begin(mission, None, announce=True)
    announce = node.codec.connection("/alliance/inter_robot_communication", TYPE, "/robot1/agent")
    fields = {"header": {"stamp": 11.0, "frame_id": "/robot1"}, "task_id": "wander"}
    node.tell(Stamped(announce, 11 * NS, node.codec.encode(TYPE, fields)))
    for moment in (13.5, 16.0, 20.0):
        node.time = moment
        supervisor.look_at_clock()
    supervisor.finish()
    (bag,) = sorted((tmp_path / "snapshots").iterdir())
    assert bag.name.startswith("robot_silent_with_task-")
    topics = [each.connection.topic for each in read_bag(bag)]
    assert topics[0] == "/mrta/mission"
    assert "/alliance/inter_robot_communication" in topics
    assert "/mrta/incident" in topics


def test_nothing_is_known_before_somebody_says_what_the_mission_is(node: StillNode, host: Host) -> None:
    with pytest.raises(Exception, match="nobody has said yet what the mission is"):
        _ = supervisor_of(node, host).mission


TYPE = "alliance_msgs/InterRobotCommunication"


def order(node: StillNode, progress: Progress, receipt: float) -> Stamped:
    """Let robot1 tell how it goes with a task."""
    said = {"header": {"stamp": receipt}, "task_id": "wander", "robot_id": "robot1", "progress": progress.code}
    connection = node.codec.connection("/mrta/task_progress", "rqt_mrta_py/TaskProgress", "/robot1/agent")
    kept = node.__dict__.setdefault("progress", connection)
    return Stamped(kept, round(receipt * NS), node.codec.encode(connection.type, said))


def heard(supervisor: LiveSupervisor) -> int:
    return supervisor.heard


def states_told(node: StillNode) -> List[Tuple[str, int, float]]:
    connection = node.codec.connection("/mrta/robot_state", "rqt_mrta_py/RobotState")
    told = [node.codec.decode(connection, raw) for topic, raw in node.said if topic == "/mrta/robot_state"]
    return [(each["robot_id"], each["state"], each["header"]["stamp"]) for each in told]


def test_mission_is_announced_as_a_run_does(node: StillNode, host: Host, mission: Mission) -> None:
    node.time = 10.0
    supervisor_of(node, host).begin(mission, 60.0, announce=True)
    expected: Outgoing = mission_message(mission, 10.0, 60.0)
    connection = node.codec.connection("/mrta/mission", "rqt_mrta_py/Mission")
    told = node.codec.decode(connection, dict(node.said)["/mrta/mission"])
    assert told["application_xml"] == expected.fields["application_xml"]
    assert (told["duration"], told["header"]["stamp"]) == (60.0, 10.0)
