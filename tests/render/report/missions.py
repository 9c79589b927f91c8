"""Finished missions to make reports of: a usual one, an hostile one, an empty one."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Dict, Tuple

from rqt_mrta_py.hooks import CurvePanel, MonitorView, SceneView
from rqt_mrta_py.model import (
    Allocation,
    Candidate,
    CommunicationGraph,
    Evidence,
    Explanation,
    Flow,
    Ground,
    Incident,
    MissionRecord,
    Outcome,
    Pose,
    RobotInterval,
    RobotRecord,
    RobotState,
    Severity,
    Spell,
    Task,
    TaskInterval,
    TaskRecord,
    TaskState,
    Taxonomy,
    Whereabouts,
)
from rqt_mrta_py.model.timing import ConnectionTiming, Gap, RobotClock, SenderClock, TimingTable
from rqt_mrta_py.render.pose_log import RobotTrack
from rqt_mrta_py.render.report import BagFile, Provenance, ReportInput
from tests.render.views import START, patrol

__all__ = ["HOSTILE", "empty_mission", "hostile_mission", "usual_mission"]

HOSTILE = (
    "</script><script>window.broken=1</script>",
    "<img src=x onerror=window.broken=1>",
    '"><svg onload=window.broken=1>',
    "'-window.broken++-'",
    "{{constructor.constructor('window.broken=1')()}}",
    "javascript:window.broken=1",
    "<!--<script>",
    "]]>&lt;b&gt;",
    "\u202etxt.exe\u2028\u2029\x00\x1b[31m",
    "__proto__",
)


def usual_mission() -> ReportInput:
    """Five robots, three tasks, 90 s; robot3 falls silent, robot1 takes over, and everything else that a page shows."""
    view = patrol(whole=True)
    lost = Incident(
        "robot_silent_with_task",
        Severity.ERROR,
        START + 60.0,
        START + 90.0,
        ("robot3",),
        ("border_protection",),
        "robot3 fell silent while it held border_protection, last heard at 60.0 s; robot1 took over at 65.4 s",
        (Evidence("/alliance/inter_robot_communication", START + 60.0, 337),),
        "The robot was switched off, its program died, or the radio failed.",
    )
    flips = Incident(
        "flipping_allocation",
        Severity.WARNING,
        START + 28.0,
        START + 51.0,
        (),
        ("report",),
        "report changed hands often",
    )
    record = replace(view.record, incidents=(flips, lost))
    flows = tuple(
        Flow(f"/robot{number}/agent", topic, kind, messages, messages / 90.0)
        for topic, kind, messages in (
            ("/alliance/inter_robot_communication", "alliance_msgs/InterRobotCommunication", 45),
            ("/mrta/task_progress", "rqt_mrta_py/TaskProgress", 12),
        )
        for number in range(1, 6)
    )
    return ReportInput(
        view=replace(view, record=record),
        provenance=Provenance(
            "review",
            (BagFile("mission.bag", 2_345_678, 12_345),),
            {"rqt_mrta_py": "0.1.0", "numpy": "1.26.4"},
            {f"robot{number}": {"broadcast_rate": 5.0, "id": number} for number in range(1, 6)},
        ),
        tracks=tuple(_track(f"robot{number}", number) for number in range(1, 6)),
        tasks=view.scene.tasks,
        communication=CommunicationGraph(flows),
        clocks=TimingTable((_timing("/robot1/pose", "/robot1/localiser", "robot1"),), (_clock("robot1"),)),
        figures={"messages_per_allocation": 32.1},
        explanations=(_explanation(),),
    )


def hostile_mission() -> ReportInput:
    """A mission in which every text that a bag may bring wants to be a script."""
    names = HOSTILE
    robots = tuple(RobotRecord(name, (RobotInterval(RobotState.BUSY, 0.0, 10.0),), 10.0) for name in names)
    tasks = tuple(TaskRecord(name, (TaskInterval(TaskState.EXECUTING, 0.0, 10.0),)) for name in names)
    held = tuple(Allocation(name, name, 1.0, 9.0, Outcome.OPEN) for name in names)
    incidents = tuple(
        Incident(name, Severity.ERROR, 1.0, 2.0, (name,), (name,), name, (Evidence(name, 1.0, 0),), name)
        for name in names
    )
    usual = usual_mission().view
    panel = usual.panels[0]
    groups = tuple(
        replace(group, label=name, curves=tuple(replace(curve, label=name) for curve in group.curves))
        for group, name in zip(panel.groups, names)
    )
    events = tuple(replace(event, text=name) for event, name in zip(usual.record.events, names * 3))
    statistics: Dict[str, object] = {name: name for name in names}
    record = MissionRecord(
        names[0], names[1], Taxonomy(), 0, 0.0, 10.0, robots, tasks, held, incidents, events, statistics
    )
    scene = SceneView(None, (), (), tuple(Task(name, name, Pose(0.0, 1.0)) for name in names))
    panels: Tuple[CurvePanel, ...] = (replace(panel, title=names[0], unit=names[1], groups=groups),)
    return ReportInput(
        view=MonitorView(names[0], names[1], 10.0, record, scene, panels),
        provenance=Provenance(
            names[0], (BagFile(names[1], 1, 1),), {names[0]: names[1]}, {names[0]: {names[1]: names[2]}}
        ),
        tracks=tuple(_track(name, number) for number, name in enumerate(names)),
        tasks=scene.tasks,
        communication=CommunicationGraph(tuple(Flow(name, name, name, 1, 1.0) for name in sorted(names))),
        clocks=TimingTable(tuple(_timing(name, name, name) for name in names), tuple(_clock(name) for name in names)),
        figures={"messages_per_allocation": 1.0},
        explanations=tuple(
            Explanation(
                name,
                Task(name, name, capabilities=(name,), predecessors=(name,)),
                TaskState.DONE,
                (Candidate(name, True, name),),
                (Spell(1.0, 9.0, name, Outcome.DONE, (), name, (Whereabouts(name, None, (name,), 1.0, 2.0),)),),
                (Ground(1.0, name, name, name),),
                0,
                name,
            )
            for name in names
        ),
    )


def empty_mission() -> ReportInput:
    """Nothing was heard at all."""
    record = MissionRecord(None, None, Taxonomy(), None, None, None, (), (), (), (), ())
    return ReportInput(MonitorView("", "", 0.0, record, SceneView(None, (), (), ())), Provenance("review"))


def _explanation() -> Explanation:
    """robot3 had border_protection from 5 to 60 s while robot1 was idle; then nobody, robot1 from 65.4 s on."""
    idle, busy = RobotState.IDLE, RobotState.BUSY
    there = Whereabouts("robot1", idle, (), START, START + 65.4)
    return Explanation(
        "border_protection",
        Task("border_protection", "follow_border", capabilities=("range_finder",)),
        TaskState.EXECUTING,
        (
            Candidate("robot1", True, "has range_finder"),
            Candidate("robot2", False, "lacks range_finder"),
            Candidate("robot3", True, "has range_finder"),
        ),
        (
            Spell(START + 5.0, START + 60.0, "robot3", Outcome.LOST, (TaskState.EXECUTING,), "", (there,)),
            Spell(START + 60.0, START + 65.4, states=(TaskState.WAITING,), others=(there,)),
            Spell(
                START + 65.4,
                START + 90.0,
                "robot1",
                Outcome.OPEN,
                (TaskState.EXECUTING,),
                others=(Whereabouts("robot3", busy, ("report",), START + 62.0, START + 80.0),),
            ),
        ),
        (
            Ground(START + 4.8, "border_protection", "motivation reached the threshold 30", "robot3"),
            Ground(START + 65.2, "border_protection", "motivation reached the threshold 30", "robot1"),
        ),
    )


def _clock(robot: str) -> RobotClock:
    return RobotClock(robot, robot, robot, SenderClock(900, 0.0021, 1e-6, 0.0015, 12, 0.0004, 0.0031))


def _timing(topic: str, caller: str, robot: str) -> ConnectionTiming:
    gaps = (Gap(START + 20.0, START + 20.31),)
    return ConnectionTiming(
        topic, topic, caller, robot, 900, START, START + 90.0, 10.0, 0.1, 0.004, 1, gaps, 0.31, _clock(robot).clock
    )


def _track(robot: str, number: int) -> RobotTrack:
    times = tuple(START + step * 0.2 for step in range(451))
    turns = tuple(0.05 * (time + 9.0 * number) for time in times)
    xs = tuple((2.0 + 0.4 * number) * math.cos(turn) for turn in turns)
    ys = tuple((1.5 + 0.4 * number) * math.sin(turn) for turn in turns)
    yaws = tuple(math.atan2(math.cos(turn), -math.sin(turn)) for turn in turns)
    return RobotTrack(robot, 0.2, 0.2, times, xs, ys, yaws)
