from __future__ import annotations

import logging
from typing import Callable, List, Tuple

import mission_journal.plugin
import pytest
from hypothesis import given
from hypothesis import strategies as st
from mission_journal.journal import Journal
from mission_journal.line import line

from rqt_mrta_py.hooks import Heard, ObserverSetup
from rqt_mrta_py.hooks.manager import PluginManager
from rqt_mrta_py.model import (
    ApplicationRobot,
    ApplicationSpec,
    ArchitectureSpec,
    Event,
    Mission,
    Severity,
    Task,
    Taxonomy,
)
from tests.plugins.csv_tables.missions import RECORD

Told = Callable[[], List[Tuple[str, str]]]

MISSION = Mission(
    ApplicationSpec("yard", "Yard", robots=(ApplicationRobot("a"), ApplicationRobot("b"))),
    ArchitectureSpec("nearest_robot", "Nearest robot", Taxonomy.parse("ST-SR-IA")),
    (Task("t", "any"),),
    seed=4,
)


def rosout(level: int, text: str, receipt: float = 3.0) -> Heard:
    return Heard("/rosout", "rosgraph_msgs/Log", receipt, {"level": level, "name": "/a/agent", "msg": text})


@pytest.fixture
def told(caplog: pytest.LogCaptureFixture) -> Told:
    caplog.set_level(logging.INFO, "rqt_mrta_py.journal")
    return lambda: [(record.levelname, record.getMessage()) for record in caplog.records]


def test_mission_is_told_from_start_to_end(told: Told) -> None:
    journal = Journal()
    journal.begin(MISSION)
    journal.hear(Heard("/mrta/mission", "rqt_mrta_py/Mission", 1.0, {}))
    journal.note(Event(3.25, "allocation_started", Severity.INFO, "a has taken t", robot="a", task="t", state="open"))
    journal.note(Event(4.0, "robot_state", Severity.WARNING, "b is offline", robot="b", state="offline"))
    journal.note(Event(4.5, "incident", Severity.ERROR, "b fell silent", robot="b", state="robot_silent_with_task"))
    journal.end(RECORD)
    assert told() == [
        (
            "INFO",
            "event=mission_started application=yard architecture=nearest_robot taxonomy=ST-SR-IA robots=2 "
            "tasks=1 seed=4",
        ),
        ("INFO", 't=2.250 severity=info event=allocation_started robot=a task=t state=open text="a has taken t"'),
        ("INFO", 't=3.000 severity=warning event=robot_state robot=b state=offline text="b is offline"'),
        ("INFO", 't=3.500 severity=error event=incident robot=b state=robot_silent_with_task text="b fell silent"'),
        ("INFO", "event=mission_ended seconds=10.500 allocations=1 incidents=1 tasks_done=1"),
    ]


@pytest.mark.parametrize(("level", "told_as"), [(1, None), (2, None), (4, "warning"), (8, "error"), (16, "error")])
def test_what_nodes_warn_of_is_told_with_its_severity(
    caplog: pytest.LogCaptureFixture, level: int, told_as: str
) -> None:
    caplog.set_level(logging.DEBUG, "rqt_mrta_py.journal")
    journal = Journal()
    journal.begin(MISSION)
    caplog.clear()
    journal.hear(rosout(level, "stuck"))
    expected = [f"stamp=3.000 severity={told_as} event=node_warned node=/a/agent text=stuck"] if told_as else []
    assert caplog.messages == expected


def test_second_mission_counts_from_its_own_start(told: Told) -> None:
    journal = Journal()
    for start in (1.0, 50.0):
        journal.begin(MISSION)
        journal.hear(Heard("/mrta/mission", "rqt_mrta_py/Mission", start, {}))
        journal.hear(Heard("/mrta/mission", "rqt_mrta_py/Mission", start + 1.0, {}))
        journal.hear(rosout(4, "stuck", start + 5.0))
    assert [text for _, text in told() if "stuck" in text] == [
        "t=5.000 severity=warning event=node_warned node=/a/agent text=stuck"
    ] * 2


def test_supervisors_history_is_not_told_twice(told: Told) -> None:
    journal = Journal()
    journal.hear(Heard("/mrta/event", "rqt_mrta_py/Event", 2.0, {}, caller="/supervisor"))
    journal.hear(Heard("/mrta/event", "rqt_mrta_py/Event", 2.0, {}))
    journal.hear(rosout(4, "history")._replace(caller="/supervisor"))
    journal.hear(rosout(4, "stuck")._replace(caller="/a/agent"))
    journal.hear(rosout(4, "nobody knows who says so"))
    assert [text.partition("text=")[2] for _, text in told()] == ["stuck", '"nobody knows who says so"']


@given(st.text())
def test_any_text_stays_within_its_fact_and_its_line(text: str) -> None:
    written = line(text=text, last=1)
    assert len(written.splitlines()) == 1
    assert written.endswith("last=1")
    assert written.isprintable()
    if text and not written.startswith('text="'):
        assert written == f"text={text} last=1"
        assert " " not in text
        assert "=" not in text


def test_plugin_observes_missions_events_and_messages(told: Told) -> None:
    manager = PluginManager()
    manager.register(mission_journal.plugin, "mission_journal")
    manager.notify("mrta_on_mission_start", mission=MISSION)
    observer = manager.registered("mrta_register_message_observers")["mission_journal"](ObserverSetup(MISSION))
    assert [wish.topic for wish in observer.subscriptions()] == ["/mrta/mission", "/mrta/event", "/rosout"]
    observer.hear(Heard("/mrta/mission", "rqt_mrta_py/Mission", 2.0, {}))
    manager.notify(
        "mrta_on_event", event=Event(3.0, "robot_state", Severity.INFO, "a is idle", robot="a", state="idle")
    )
    manager.notify("mrta_on_mission_end", record=RECORD)
    assert [text.split()[0] for _, text in told()] == ["event=mission_started", "t=1.000", "event=mission_ended"]
