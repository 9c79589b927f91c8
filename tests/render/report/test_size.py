"""An hour of ten robots, made up: poses with noise, motivations at 5 Hz, an allocation each half minute."""

from __future__ import annotations

import math
import random
from dataclasses import replace
from typing import List

import pytest

from rqt_mrta_py.hooks import CurvePanel, MonitorView, SceneView, TeamTraces, nice_top
from rqt_mrta_py.hooks.curve_trace import CurveTrace
from rqt_mrta_py.model import (
    Allocation,
    ApplicationRobot,
    ApplicationSpec,
    ArchitectureSpec,
    Arena,
    Event,
    Explanation,
    Ground,
    Incident,
    Mission,
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
from rqt_mrta_py.render.pose_log import PoseLog, RobotTrack
from rqt_mrta_py.render.report import Provenance, ReportInput, fine_panel, report_html

HOUR, SPELL = 3600.0, 30.0
ROBOTS = [f"robot{number}" for number in range(1, 11)]
TASKS = [f"patrol_sector_{number}" for number in range(1, 7)]


def hour() -> ReportInput:
    chance = random.Random(3)
    held: List[Allocation] = []
    events: List[Event] = []
    for number, robot in enumerate(ROBOTS):
        for spell in range(int(HOUR / SPELL)):
            start = 1.0 + spell * SPELL + number
            task = chance.choice(TASKS)
            held.append(Allocation(task, robot, start, start + SPELL - 5.0, chance.choice(list(Outcome))))
            kinds = ("is busy", f"has taken {task}", f"has given up {task}", "is idle")
            events += [Event(start, "robot_state", Severity.INFO, f"{robot} {kind}", robot, task) for kind in kinds]
    robots = tuple(
        RobotRecord(
            robot,
            tuple(
                RobotInterval(RobotState.BUSY if step % 2 else RobotState.IDLE, 1.0 + 15 * step, 16.0 + 15 * step)
                for step in range(240)
            ),
            HOUR,
        )
        for robot in ROBOTS
    )
    states = (TaskState.WAITING, TaskState.EXECUTING)
    tasks = tuple(
        TaskRecord(task, tuple(TaskInterval(states[step % 2], 1.0 + 6 * step, 7.0 + 6 * step) for step in range(600)))
        for task in TASKS
    )
    incidents = tuple(
        Incident(
            "flipping_allocation",
            Severity.WARNING,
            60.0 * n,
            60.0 * n + 9,
            (ROBOTS[n % 10],),
            (TASKS[n % 6],),
            "it flips",
        )
        for n in range(1, 60)
    )
    record = MissionRecord(
        "patrol", "mrta_alliance", Taxonomy(), 0, 1.0, 1.0 + HOUR, robots, tasks, tuple(held), incidents, tuple(events)
    )
    scene = SceneView(
        Arena(-20.0, -20.0, 20.0, 20.0), (), (), tuple(Task(task, "patrol", Pose(n, n)) for n, task in enumerate(TASKS))
    )
    view = MonitorView("Patrol", "ALLIANCE", 1.0 + HOUR, record, scene, (motivations(chance),), HOUR)
    return ReportInput(
        view, Provenance("run"), tracks=tuple(track(robot, chance) for robot in ROBOTS), tasks=scene.tasks
    )


def track(robot: str, chance: random.Random) -> RobotTrack:
    """Drive at 0.4 m/s, turn now and then, tell a pose ten times a second that is off by about a centimetre."""
    log = PoseLog(0.2, 20_000)
    x = y = yaw = 0.0
    for step in range(int(HOUR * 10)):
        if step % 70 == 0:
            yaw += chance.uniform(-2.0, 2.0)
        x = (x + 0.04 * math.cos(yaw) + 20.0) % 40.0 - 20.0
        y = (y + 0.04 * math.sin(yaw) + 20.0) % 40.0 - 20.0
        time = 1.0 + step / 10.0
        if time >= log.due:
            told = yaw + chance.gauss(0.0, 0.02)
            turn = (0.0, 0.0, math.sin(told / 2.0), math.cos(told / 2.0))
            log.add(time, x + chance.gauss(0.0, 0.01), y + chance.gauss(0.0, 0.01), turn)
    return log.track(robot, 0.2)


def motivations(chance: random.Random) -> CurvePanel:
    team = ApplicationSpec("patrol", "Patrol", robots=tuple(ApplicationRobot(robot) for robot in ROBOTS))
    mission = Mission(team, ArchitectureSpec("a", "A", Taxonomy()), tuple(Task(task, "patrol") for task in TASKS))
    traces = TeamTraces(mission, lambda: CurveTrace(2.0))
    for robot in ROBOTS:
        for task in TASKS:
            trace, value = traces.of(robot, task), 0.0
            for step in range(int(HOUR * 5)):
                value = 0.0 if value >= 1.0 or chance.random() < 0.002 else min(value + 0.004 * chance.random(), 1.0)
                trace.add(1.0 + step / 5.0, value)

    def view(start: float, end: float) -> CurvePanel:
        groups = traces.groups(start, end)
        return CurvePanel("Motivation / threshold", "1", nice_top(groups), 1.0, groups)

    panel: CurvePanel = fine_panel(view, 1.0, 1.0 + HOUR)
    return panel


@pytest.mark.long
def test_an_hour_explained_with_everything_that_a_page_has_room_for_takes_no_more() -> None:
    given = hour()
    record = given.view.record
    others = tuple(Whereabouts(robot, RobotState.BUSY, (TASKS[0],), 1.0, 31.0) for robot in ROBOTS)
    spells = tuple(Spell(each.start, each.end, each.robot, each.outcome, (), "", others) for each in record.allocations)
    text = "motivation reached the threshold 30 after 20.4 s: becomes active; reset to 0: robot9 has announced it"
    grounds = tuple(Ground(1.0 + n, "patrol", text, ROBOTS[n % 10]) for n in range(2000))
    explained = tuple(Explanation(task, None, TaskState.WAITING, (), spells, grounds) for task in TASKS)
    assert len(report_html(replace(given, explanations=explained)).encode("utf-8")) < 5_000_000


@pytest.mark.long
def test_an_hour_of_ten_robots_takes_less_than_five_megabytes() -> None:
    assert len(report_html(hour()).encode("utf-8")) < 5_000_000
