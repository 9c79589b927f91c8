from __future__ import annotations

from pathlib import Path
from typing import Any, Dict, List

from rqt_mrta_py.hooks import Outgoing
from rqt_mrta_py.supervisor import team_news
from rqt_mrta_py.supervisor.plugin import mrta_register_incident_rules
from rqt_mrta_py.transport import RosCodec
from tests.supervisor.mini import Stream, mission


def on(news: List[Outgoing], topic: str) -> List[Dict[str, Any]]:
    return [dict(message.fields) for message in news if message.topic == topic]


def test_news_tells_each_change_once_dated_when_it_happened() -> None:
    stream = Stream()
    stream.busy(1.5, "robot1", "patrol")
    news = list(stream.supervisor.news())
    assert on(news, "/mrta/robot_state") == [
        {"header": {"stamp": 1.5}, "robot_id": "robot1", "state": 2, "last_heard": 1.5}
    ]
    assert on(news, "/mrta/task_state") == [
        {"header": {"stamp": 1.5}, "task_id": "patrol", "state": 2, "robots": ["robot1"]}
    ]
    assert on(news, "/mrta/allocation") == [
        {"header": {"stamp": 1.5}, "task_id": "patrol", "robot_id": "robot1", "start": 1.5, "end": 0.0, "outcome": 0}
    ]
    assert stream.supervisor.news() == []

    stream.tick(9.0)
    news = list(stream.supervisor.news())
    assert on(news, "/mrta/robot_state") == [
        {"header": {"stamp": 3.5}, "robot_id": "robot1", "state": 0, "last_heard": 1.5}
    ]
    assert on(news, "/mrta/allocation") == [
        {"header": {"stamp": 3.5}, "task_id": "patrol", "robot_id": "robot1", "start": 1.5, "end": 3.5, "outcome": 5}
    ]
    assert on(news, "/mrta/event")[0] == {
        "header": {"stamp": 3.5},
        "kind": "allocation_ended",
        "severity": 1,
        "robot_id": "robot1",
        "task_id": "patrol",
        "state": "lost",
        "text": "robot1 fell silent and lost patrol",
    }


def test_history_on_rosout_has_the_form_of_the_original_with_full_precision() -> None:
    stream = Stream()
    stream.busy(1510520000.25, "robot1", "patrol")
    stream.tick(1510520009.0)
    lines = [(each["level"], each["name"], each["msg"]) for each in on(list(stream.supervisor.news()), "/rosout")]
    assert lines == [
        (2, "/supervisor", "[1510520000.25] [0] [1] id: robot1, state: 1"),
        (2, "/supervisor", "[1510520000.25] [2] [1] id: patrol-1510520000.25, state: 1"),
        (2, "/supervisor", "[1510520000.25] [1] [1] id: patrol, state: 2"),
        (4, "/supervisor", "[1510520002.25] [2] [2] id: patrol-1510520000.25, state: 0"),
        (2, "/supervisor", "[1510520002.25] [1] [1] id: patrol, state: 0"),
        (4, "/supervisor", "[1510520002.25] [0] [2] id: robot1, state: 2"),
    ]


def test_team_state_tells_everything_at_a_moment() -> None:
    stream = Stream(mission(tasks=("patrol",)))
    stream.tick(1.0)
    stream.busy(2.0, "robot2", "patrol")
    message = team_news(stream.supervisor.record(2.5), 2.5)
    assert (message.topic, message.type, message.latched) == ("/mrta/team_state", "rqt_mrta_py/TeamState", True)
    start = {"header": {"stamp": 2.0}, "start": 2.0, "end": 0.0, "outcome": 0}
    assert message.fields == {
        "header": {"stamp": 2.5},
        "robots": [
            {"header": {"stamp": 1.0}, "robot_id": "robot1", "state": 0, "last_heard": 0.0},
            {"header": {"stamp": 2.0}, "robot_id": "robot2", "state": 2, "last_heard": 2.0},
        ],
        "tasks": [{"header": {"stamp": 2.0}, "task_id": "patrol", "state": 2, "robots": ["robot2"]}],
        "allocations": [{**start, "task_id": "patrol", "robot_id": "robot2"}],
    }


def test_every_message_fits_its_published_type(root: Path) -> None:
    def lookup(type_name: str) -> str:
        return (root / "msg" / f"{type_name.split('/')[1]}.msg").read_text(encoding="utf-8")

    stream = Stream(rules=mrta_register_incident_rules())
    stream.busy(1.5, "robot1", "patrol")
    stream.tick(9.0)
    stream.odom(10.0, "robot1")
    news = [*stream.supervisor.news(), team_news(stream.supervisor.record(10.0), 10.0)]
    codec = RosCodec(lookup)
    assert {message.topic for message in news} == {
        "/mrta/robot_state",
        "/mrta/task_state",
        "/mrta/allocation",
        "/mrta/event",
        "/mrta/incident",
        "/mrta/team_state",
        "/rosout",
    }
    for message in news:
        raw = codec.encode(message.type, message.fields)
        decoded = codec.decode(codec.connection(message.topic, message.type), raw)
        assert decoded["header"]["stamp"] == message.fields["header"]["stamp"]
