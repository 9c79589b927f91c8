"""A finished mission with one of everything."""

from __future__ import annotations

from rqt_mrta_py.model import (
    Allocation,
    Event,
    Incident,
    MissionRecord,
    Outcome,
    RobotInterval,
    RobotRecord,
    RobotState,
    Severity,
    TaskInterval,
    TaskRecord,
    TaskState,
    Taxonomy,
)

RECORD = MissionRecord(
    application="yard",
    architecture="nearest_robot",
    taxonomy=Taxonomy.parse("ST-SR-IA"),
    seed=7,
    start=1.0,
    end=11.5,
    robots=(
        RobotRecord("a", (RobotInterval(RobotState.OFFLINE, 1.0, 1.1), RobotInterval(RobotState.IDLE, 1.1, 11.5))),
        RobotRecord("b", ()),
    ),
    tasks=(TaskRecord("t", (TaskInterval(TaskState.WAITING, 1.0, 3.25), TaskInterval(TaskState.DONE, 3.25, 11.5))),),
    allocations=(Allocation("t", "a", 1.2, 3.25, Outcome.DONE),),
    incidents=(Incident("odd", Severity.WARNING, 2.0, 3.0, ("a", "b"), ("t",), 'a says "no", b too,\nand leaves'),),
    events=(
        Event(1.1, "robot_state", Severity.INFO, "a is idle", robot="a", state="idle"),
        Event(3.25, "unreadable", Severity.WARNING, "=HYPERLINK(1)"),
    ),
)
