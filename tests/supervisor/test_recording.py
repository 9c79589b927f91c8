"""The recording of the original C++ nodes, as section 7.7 of the reference describes it; seconds from its start."""

from __future__ import annotations

import dataclasses
from pathlib import Path
from typing import Callable, List, Tuple

import pytest

from rqt_mrta_py.config.xml.architecture import read_architecture
from rqt_mrta_py.hooks import InterpreterSetup
from rqt_mrta_py.model import ApplicationRobot, ApplicationSpec, Event, Mission, MissionRecord, RobotState, Task
from rqt_mrta_py.supervisor import Supervisor
from rqt_mrta_py.supervisor.plugin import mrta_register_incident_rules, mrta_register_statistics
from rqt_mrta_py.transport import Dispatcher, RosCodec
from rqt_mrta_py.transport.bags.reader import read_bag

ROBOTS = ("robot1", "robot2")
TASKS = ("patrol", "inspect")
WITHIN = 0.011
"""The reference gives hundredths of a second."""


def review(bag: Path, root: Path, idle: bool, listed: bool) -> Tuple[MissionRecord, List[Event]]:
    from mrta_alliance.interpreter import AllianceInterpreter

    described = root / "plugins" / "architectures" / "mrta_alliance" / "rqt_mrta.xml"
    architecture = read_architecture(described.read_text(encoding="utf-8"), described.name, "mrta_alliance")
    mission = Mission(
        application=ApplicationSpec("yard", "Yard", robots=tuple(map(ApplicationRobot, ROBOTS)) if listed else ()),
        architecture=architecture if idle else dataclasses.replace(architecture, idle_robots=()),
        tasks=tuple(Task(task, task) for task in TASKS) if listed else (),
    )
    events: List[Event] = []
    interpreter = AllianceInterpreter(InterpreterSetup((), ()))
    rules, statistics = mrta_register_incident_rules(), mrta_register_statistics()
    supervisor = Supervisor(mission, interpreter, rules, statistics, events.append)
    dispatcher = Dispatcher(RosCodec(lambda type_name: None), supervisor.report)
    dispatcher.watch(supervisor.sighting)
    for subscription, callback in supervisor.listeners():
        dispatcher.subscribe(subscription, callback)
    for stamped in read_bag(bag):
        dispatcher.feed(stamped)
    return supervisor.finish(), events


def in_state(record: MissionRecord, robot: str, state: RobotState) -> List[float]:
    start = record.start or 0.0
    found = next(each for each in record.robots if each.id == robot)
    return [time - start for each in found.states if each.state is state for time in (each.start, each.end)]


@pytest.mark.parametrize("listed", [True, False], ids=["team listed", "team admitted by first sight"])
@pytest.mark.parametrize("idle", [True, False], ids=["with idle topics", "without idle topics"])
def test_supervisor_derives_what_the_reference_says_of_the_recording(
    shared_data: Callable[[str], Path], root: Path, idle: bool, listed: bool
) -> None:
    record, events = review(shared_data("alliance_two_robots.bag"), root, idle, listed)
    start, end = record.start or 0.0, record.end or 0.0

    assert end - start == pytest.approx(124.1, abs=0.05)
    busy1 = [4.12, 45.12, 48.12, 75.52]
    busy2 = [4.97, 46.57, 49.97, 91.37, 94.77, end - start]
    assert in_state(record, "robot1", RobotState.BUSY) == pytest.approx(busy1, abs=WITHIN)
    assert in_state(record, "robot2", RobotState.BUSY) == pytest.approx(busy2, abs=WITHIN)
    if not idle:
        assert not in_state(record, "robot1", RobotState.IDLE)

    found = [(each.robot, each.task, each.outcome.value) for each in record.allocations]
    assert found == [
        ("robot1", "patrol", "gave_up"),
        ("robot2", "inspect", "gave_up"),
        ("robot1", "patrol", "lost"),
        ("robot2", "inspect", "gave_up"),
        ("robot2", "inspect", "open"),
    ]
    assert [each.start - start for each in record.allocations] == pytest.approx(
        [4.12, 4.97, 48.12, 49.97, 94.77], abs=WITHIN
    )
    ends = [each.end - start for each in record.allocations]
    # Given in tenths; a lost robot's allocation ends when two seconds of silence are over.
    assert ends == pytest.approx([43.5, 44.6, 75.72, 89.4, end - start], abs=0.06)

    (incident,) = record.incidents
    assert (incident.rule, incident.severity.value) == ("robot_silent_with_task", "error")
    assert (incident.robots, incident.tasks) == (("robot1",), ("patrol",))
    assert incident.start - start == pytest.approx(73.72, abs=WITHIN)
    assert incident.end == end
    assert incident.text == "robot1 fell silent while it held patrol, last heard at 73.7 s; nobody has taken over"
    assert not [event for event in events if event.kind == "unreadable"]


def test_evidence_can_be_looked_up_in_the_bag(shared_data: Callable[[str], Path], root: Path) -> None:
    bag = shared_data("alliance_two_robots.bag")
    record, _ = review(bag, root, idle=True, listed=True)
    (incident,) = record.incidents
    for each in incident.evidence:
        messages = list(read_bag(bag, [each.topic]))
        assert messages[each.index].receipt_ns / 1_000_000_000 == each.stamp
        assert each.topic.startswith("/robot1/")
    last = incident.evidence[-1]
    assert len(list(read_bag(bag, [last.topic]))) == last.index + 1
