"""Tables of a large team on a small terminal."""

from __future__ import annotations

import io

from rich.console import Console

from rqt_mrta_py.app.cli.watch_screen import ScreenDisplay
from rqt_mrta_py.app.watch.view import WatchView
from rqt_mrta_py.model import (
    Allocation,
    ApplicationSpec,
    ArchitectureSpec,
    Incident,
    Mission,
    MissionRecord,
    Outcome,
    RobotInterval,
    RobotRecord,
    RobotState,
    Severity,
    Taxonomy,
)

TAXONOMY = Taxonomy.parse("ST-SR-IA")
HEIGHT = 30


def view(robots: int, incidents: int) -> WatchView:
    mission = Mission(ApplicationSpec("yard", "Yard"), ArchitectureSpec("auction", "Auction", TAXONOMY), ())
    record = MissionRecord(
        application="yard",
        architecture="auction",
        taxonomy=TAXONOMY,
        seed=None,
        start=10.0,
        end=25.0,
        robots=tuple(
            RobotRecord(f"robot{number}", (RobotInterval(RobotState.BUSY, 20.0, 25.0),), 24.5)
            for number in range(robots)
        ),
        tasks=(),
        allocations=(
            Allocation("fetch", "robot0", 12.0, 14.0, Outcome.DONE),
            Allocation("b", "robot0", 14.0, 25.0, Outcome.OPEN),
            Allocation("a", "robot0", 14.0, 25.0, Outcome.OPEN),
        ),
        incidents=tuple(
            Incident("rule", Severity.ERROR, 10.0 + number, 25.0, (), (), f"trouble number {number}.")
            for number in range(incidents)
        ),
        events=(),
    )
    return WatchView(mission, record, 7, None)


def shown(what: WatchView) -> str:
    written = io.StringIO()
    with ScreenDisplay(console=Console(file=written, width=100, height=HEIGHT, highlight=False)) as display:
        display.show(what)
        display.end(what)
    return written.getvalue()


def test_a_robot_is_shown_with_what_it_holds_and_since_when() -> None:
    text = shown(view(1, 0))
    (line,) = [line for line in text.splitlines() if line.startswith("robot0 ")]
    assert line.split() == ["robot0", "busy", "5.0", "s", "a,", "b", "0.5", "s", "ago"]
    assert "yard under auction   15.0 s   7 messages" in text
    assert "none" in text


def test_a_team_that_does_not_fit_is_counted_and_the_newest_incidents_stay() -> None:
    lines = shown(view(1000, 12)).splitlines()
    assert len(lines) <= HEIGHT
    assert sum(line.startswith("robot") for line in lines) >= 6
    (more,) = [line for line in lines if line.startswith("and ")]
    assert int(more.split()[1]) == 1000 - sum(line.startswith("robot") for line in lines)
    assert [line for line in lines if "trouble number 11." in line]
    assert not [line for line in lines if "trouble number 3." in line]
