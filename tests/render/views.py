"""Realistic views to draw: a usual mission with a lost robot, a crowded one, an empty one."""

from __future__ import annotations

import math
from typing import Dict, List, Optional, Sequence, Tuple

from rqt_mrta_py.hooks import Curve, CurveGroup, CurvePanel, MonitorView, RobotSight, SceneView
from rqt_mrta_py.model import (
    Allocation,
    Arena,
    Event,
    Incident,
    MissionRecord,
    Obstacle,
    Outcome,
    Pose,
    RobotInterval,
    RobotRecord,
    RobotState,
    Severity,
    Task,
    TaskInterval,
    TaskRecord,
    TaskState,
    Taxonomy,
)

START = 1.0
LOST = "robot3"
Spell = Tuple[str, str, float, float, Outcome]


def patrol(now: float = 91.0, whole: bool = False) -> MonitorView:
    """Five robots, three tasks; robot3 falls silent at 61 s while it holds border_protection, robot1 takes over."""
    spells: List[Spell] = [
        ("robot3", "border_protection", 5.2, 63.0, Outcome.LOST),
        ("robot1", "wander", 6.0, 66.4, Outcome.YIELDED),
        ("robot2", "report", 9.5, 29.0, Outcome.DONE),
        ("robot2", "report", 33.0, 50.5, Outcome.GAVE_UP),
        ("robot4", "report", 52.0, math.inf, Outcome.OPEN),
        ("robot1", "border_protection", 66.4, math.inf, Outcome.OPEN),
        ("robot5", "wander", 70.0, math.inf, Outcome.OPEN),
    ]
    tasks = (
        Task("wander", "wander"),
        Task("border_protection", "follow_border", Pose(4.2, 3.4)),
        Task("report", "report", Pose(-3.6, -2.4)),
    )
    obstacles = (
        Obstacle("box1", Pose(1.4, 0.8, 0.5), (1.1, 0.6, 0.4)),
        Obstacle("box2", Pose(-1.9, 1.7, -0.2), (0.8, 0.8, 0.4)),
        Obstacle("drum", Pose(0.2, -2.1), (0.7, 0.7, 0.5), "cylinder"),
    )
    robots = [f"robot{i}" for i in range(1, 6)]
    offline = {LOST: (63.0, math.inf), "robot5": (40.0, 55.0)}
    sights = tuple(
        _sight(robot, number, min(now, 61.0) if robot == LOST else now, 180.0 if whole else 60.0)
        for number, robot in enumerate(robots)
    )
    record = record_of(robots, [task.id for task in tasks], spells, offline, now)
    scene = SceneView(Arena(-5.0, -4.0, 5.0, 4.0), obstacles, sights, tasks)
    start = START if whole else max(START, now - 60.0)
    return MonitorView(
        "Border patrol",
        "ALLIANCE  ·  ST-SR-IA  ·  seed 0",
        now,
        record,
        scene,
        (motivation(robots, [task.id for task in tasks], start, now),),
        180.0,
    )


def crowd(now: float = 140.0, robots: int = 12, tasks: int = 10, groups: int = 12) -> MonitorView:
    """Many robots close together, many tasks with long names."""
    names = [f"robot_{i:02d}" for i in range(robots)]
    work = [f"deliver_pallet_to_dock_{i}" if i % 3 else f"inspect_shelf_{i}" for i in range(tasks)]
    spells: List[Spell] = []
    for number, robot in enumerate(names):
        time, turn = 2.0 + 1.3 * number, number
        outcomes = [Outcome.DONE, Outcome.YIELDED, Outcome.FAILED, Outcome.PREEMPTED, Outcome.GAVE_UP, Outcome.LOST]
        while time < now:
            length = 14.0 + (number * 7 + turn * 5) % 23
            over = time + length >= now
            outcome = Outcome.OPEN if over else outcomes[(number + turn) % 6]
            spells.append((robot, work[turn % tasks], time, math.inf if over else time + length, outcome))
            time, turn = time + length + 2.0, turn + 1
    sights = tuple(
        RobotSight(
            robot,
            Pose(2.0 + 0.55 * (i % 4), 1.5 + 0.5 * (i // 4), 0.7 * i),
            0.2,
            tuple(
                (
                    now - 60 + k,
                    2.0 + 0.55 * (i % 4) + (60 - k) * 0.06 * math.cos(0.5 * i + 0.05 * k),
                    1.5 + 0.5 * (i // 4) + (60 - k) * 0.04 * math.sin(0.5 * i + 0.05 * k),
                )
                for k in range(61)
            ),
        )
        for i, robot in enumerate(names)
    )
    places = tuple(Task(name, "go", Pose(-6.0 + 1.3 * i, 3.2 * math.sin(1.9 * i))) for i, name in enumerate(work))
    record = record_of(names, work, sorted(spells, key=lambda spell: spell[2]), {names[7]: (100.0, math.inf)}, now)
    return MonitorView(
        "Warehouse with a rather long name that nobody will ever read to its very end",
        "DEMiR-CF  ·  ST-MR-TA  ·  seed 12345",
        now,
        record,
        SceneView(Arena(-8.0, -4.0, 8.0, 4.0), (), sights, places),
        (motivation(names[:groups], work[:6], now - 60.0, now),),
        240.0,
    )


def single(now: float = 21.0) -> MonitorView:
    """One robot, one task, no arena known, no duration planned."""
    record = record_of(["rover"], ["survey"], [("rover", "survey", 4.0, math.inf, Outcome.OPEN)], {}, now)
    scene = SceneView(None, (), (_sight("rover", 1, now, 60.0),), (Task("survey", "go", Pose(2.0, 1.0)),))
    return MonitorView("Survey", "ALLIANCE", now, record, scene, (motivation(["rover"], ["survey"], 1.0, now),))


def empty() -> MonitorView:
    """Nothing heard yet, of nobody."""
    record = MissionRecord(None, None, Taxonomy(), None, None, None, (), (), (), (), ())
    return MonitorView("mission", "", 0.0, record, SceneView(None, (), (), ()))


def record_of(
    robots: Sequence[str],
    tasks: Sequence[str],
    spells: Sequence[Spell],
    offline: Dict[str, Tuple[float, float]],
    now: float,
) -> MissionRecord:
    """Build a record as a supervisor would have it at ``now``."""
    allocations, events, incidents = [], [], []
    for robot, task, start, end, outcome in spells:
        if start > now:
            continue
        ended = end <= now
        allocations.append(Allocation(task, robot, start, min(end, now), outcome if ended else Outcome.OPEN))
        events.append(Event(start, "allocation_started", Severity.INFO, f"{robot} takes {task}", robot, task))
        if ended:
            bad = outcome in (Outcome.LOST, Outcome.FAILED)
            severity = Severity.WARNING if bad else Severity.INFO
            text = f"{robot} no longer holds {task}: {outcome.value.replace('_', ' ')}"
            events.append(Event(end, "allocation_ended", severity, text, robot, task, outcome.value))
        if ended and outcome is Outcome.LOST:
            text = f"{robot} has been silent for 2.0 s while it holds {task}"
            incidents.append(
                Incident("robot_silent", Severity.ERROR, end, min(end + 3.4, now), (robot,), (task,), text)
            )
            events.append(Event(end, "incident", Severity.ERROR, text, robot, task, "robot_silent"))
    return MissionRecord(
        "border_patrol",
        "mrta_alliance",
        Taxonomy.parse("ST-SR-IA"),
        0,
        START,
        now,
        tuple(RobotRecord(robot, _robot_states(robot, spells, offline.get(robot), now), now) for robot in robots),
        tuple(TaskRecord(task, _task_states(task, spells, now)) for task in tasks),
        tuple(allocations),
        tuple(incidents),
        tuple(sorted(events, key=lambda event: event.time)),
        {
            "allocations_by_outcome": {"done": 1, "gave_up": 1, "lost": 1, "yielded": 1},
            "availability": {robot: 1.0 - 0.1 * number for number, robot in enumerate(robots)},
            "coverage": dict.fromkeys(tasks, 0.97),
            "reallocations": 3,
            "time_to_first_allocation": {task: 4.2 if number else None for number, task in enumerate(tasks)},
            "utilisation": {robot: 0.9 - 0.15 * (number % 5) for number, robot in enumerate(robots)},
        },
    )


def motivation(robots: Sequence[str], tasks: Sequence[str], start: float, end: float) -> CurvePanel:
    """Saw teeth that rise to a threshold of 40 and fall back."""
    groups = []
    for number, robot in enumerate(robots):
        curves = []
        for turn, task in enumerate(tasks):
            period = 17.0 + 5.0 * turn + 3.0 * number
            times: List[float] = []
            values: List[float] = []
            for k in range(int((end - start) * 2)):
                time = start + 0.5 * k
                phase = (time + 4.0 * number) % period
                if values and phase < 0.5:
                    times.append(time)
                    values.append(math.nan)
                times.append(time)
                values.append(min(48.0, 60.0 * phase / period))
            curves.append(Curve(task, tuple(times), tuple(values)))
        groups.append(CurveGroup(robot, tuple(curves)))
    return CurvePanel("Motivation", "1", 50.0, 40.0, tuple(groups))


def _sight(robot: str, number: int, until: float, reach: float) -> RobotSight:
    def point(time: float) -> Tuple[float, float, float]:
        phase = 0.07 * time + 1.3 * number
        return time, 3.9 * math.cos(phase) * math.cos(0.31 * phase), 3.1 * math.sin(phase + 0.2 * number)

    first = max(START, until - reach)
    trail = tuple(point(first + 0.4 * k) for k in range(int((until - first) / 0.4) + 1))
    (_, x, y), (_, next_x, next_y) = point(until), point(until + 0.1)
    return RobotSight(robot, Pose(x, y, math.atan2(next_y - y, next_x - x)), 0.2, trail)


def _robot_states(
    robot: str, spells: Sequence[Spell], offline: Optional[Tuple[float, float]], now: float
) -> Tuple[RobotInterval, ...]:
    edges = {START, now}
    for name, _, start, end, _ in spells:
        if name == robot:
            edges.update((start, end))
    edges.update(offline or ())
    cuts = sorted(edge for edge in edges if START <= edge <= now)
    states: List[RobotInterval] = []
    for start, end in zip(cuts, cuts[1:]):
        state = RobotState.IDLE
        if any(name == robot and since <= start < until for name, _, since, until, _ in spells):
            state = RobotState.BUSY
        if offline is not None and offline[0] <= start < offline[1]:
            state = RobotState.OFFLINE
        if states and states[-1].state is state:
            states[-1] = RobotInterval(state, states[-1].start, end)
        else:
            states.append(RobotInterval(state, start, end))
    return tuple(states)


def _task_states(task: str, spells: Sequence[Spell], now: float) -> Tuple[TaskInterval, ...]:
    history: List[TaskInterval] = []
    time, state = START, TaskState.WAITING
    for _, name, start, end, outcome in spells:
        if name != task or start > now:
            continue
        if start > time:
            history.append(TaskInterval(state, time, start))
        executing = min(start + 1.0, now)
        history.append(TaskInterval(TaskState.ALLOCATED, start, executing))
        history.append(TaskInterval(TaskState.EXECUTING, executing, min(end, now)))
        time = min(end, now)
        state = {Outcome.DONE: TaskState.DONE, Outcome.FAILED: TaskState.FAILED}.get(outcome, TaskState.WAITING)
    if time < now:
        history.append(TaskInterval(state, time, now))
    return tuple(history)
