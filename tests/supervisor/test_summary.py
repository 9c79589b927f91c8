from __future__ import annotations

import json

from rqt_mrta_py.model import Progress
from rqt_mrta_py.supervisor import event_lines, incident_lines, summary
from rqt_mrta_py.supervisor.plugin import mrta_register_incident_rules
from tests.supervisor.mini import COMMUNICATION, Stream, mission


def story() -> Stream:
    stream = Stream(
        mission(tasks=("patrol",)),
        rules=mrta_register_incident_rules(),
        statistics={"twice": lambda record: 2 * len(record.robots), "a_third": lambda record: 1.0 / 3.0},
    )
    stream.tick(1.0)
    stream.busy(1.1, "robot1", "patrol")
    stream.busy(4.0, "robot2", "patrol")
    stream.progress(5.0, "patrol", "robot2", Progress.DONE)
    return stream


def test_summary_is_the_documented_one() -> None:
    expected = {
        "schema": "rqt_mrta_py/summary/1",
        "application": "yard",
        "architecture": "mrta_mini",
        "taxonomy": "ST-SR-IA",
        "seed": 7,
        "time": {"start": 1.0, "end": 5.0},
        "robots": [
            {
                "id": "robot1",
                "states": [
                    {"state": "offline", "from": 1.0, "to": 1.1},
                    {"state": "busy", "from": 1.1, "to": 3.1},
                    {"state": "offline", "from": 3.1, "to": 5.0},
                ],
            },
            {
                "id": "robot2",
                "states": [{"state": "offline", "from": 1.0, "to": 4.0}, {"state": "busy", "from": 4.0, "to": 5.0}],
            },
        ],
        "tasks": [
            {
                "id": "patrol",
                "state": "done",
                "history": [
                    {"state": "waiting", "from": 1.0, "to": 1.1},
                    {"state": "executing", "from": 1.1, "to": 3.1},
                    {"state": "waiting", "from": 3.1, "to": 4.0},
                    {"state": "executing", "from": 4.0, "to": 5.0},
                    {"state": "done", "from": 5.0, "to": 5.0},
                ],
            }
        ],
        "allocations": [
            {"task": "patrol", "robot": "robot1", "from": 1.1, "to": 3.1, "outcome": "lost"},
            {"task": "patrol", "robot": "robot2", "from": 4.0, "to": 5.0, "outcome": "done"},
        ],
        "incidents": [
            {
                "rule": "robot_silent_with_task",
                "severity": "error",
                "from": 1.1,
                "to": 5.0,
                "robots": ["robot1"],
                "tasks": ["patrol"],
                "text": "robot1 fell silent while it held patrol, last heard at 0.1 s; robot2 took over at 3.0 s",
                "evidence": [
                    {"topic": COMMUNICATION, "stamp": 1.1, "index": 0},
                    {"topic": COMMUNICATION, "stamp": 4.0, "index": 1},
                ],
                "causes": (
                    "The robot's computer, battery or radio has failed, its nodes were stopped, or it is out of reach."
                ),
            }
        ],
        "statistics": {"a_third": 0.333333333, "twice": 4},
    }
    found = summary(story().finish())
    # As text: the order of keys is part of the promise.
    assert json.dumps(found) == json.dumps(expected)


def test_event_lines_tell_every_change_in_order() -> None:
    lines = event_lines(story().finish().events)
    assert list(lines[0]) == ["time", "kind", "severity", "robot", "task", "state", "text", "causes"]
    assert [(line["time"], line["text"]) for line in lines] == [
        (1.1, "robot1 is busy"),
        (1.1, "robot1 has taken patrol"),
        (1.1, "patrol is executing"),
        (3.1, "robot1 fell silent and lost patrol"),
        (3.1, "robot1 fell silent while it held patrol, last heard at 0.1 s; nobody has taken over"),
        (3.1, "patrol is waiting"),
        (3.1, "robot1 is offline"),
        (4.0, "robot2 is busy"),
        (4.0, "robot2 has taken patrol"),
        (4.0, "patrol is executing"),
        (5.0, "robot2 has done patrol"),
        (5.0, "patrol is done"),
    ]


def test_incident_lines_are_those_of_the_summary() -> None:
    record = story().finish()
    assert incident_lines(record) == summary(record)["incidents"]


def test_numbers_carry_no_noise_and_nothing_but_builtins() -> None:
    stream = Stream()
    stream.tick(0.1 + 0.2)
    found = summary(stream.finish())
    assert found["time"] == {"start": 0.3, "end": 0.3}
    assert json.loads(json.dumps(found)) == found


def test_summary_of_nothing_is_empty() -> None:
    found = summary(Stream(mission(robots=(), tasks=())).finish())
    assert found["time"] == {"start": None, "end": None}
    assert [found[key] for key in ("robots", "tasks", "allocations", "incidents")] == [[], [], [], []]
