"""What the page's script draws: the mission as plain JSON, times in whole milliseconds since its start."""

from __future__ import annotations

import math
from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple

from rqt_mrta_py.hooks import Curve, CurvePanel
from rqt_mrta_py.model import Outcome, RobotState, Severity, TaskState
from rqt_mrta_py.render.body_keeper import BodyTrack
from rqt_mrta_py.render.happenings import happening_word
from rqt_mrta_py.render.palette import BODY_COLOURS, TASK_COLOURS, TaskColours
from rqt_mrta_py.render.pose_log import RobotTrack
from rqt_mrta_py.render.report.html import words
from rqt_mrta_py.render.report.packing import packed
from rqt_mrta_py.render.report.report_input import ReportInput
from rqt_mrta_py.render.report.thinning import corners
from rqt_mrta_py.render.signs import OUTCOME_SIGNS, TASK_SIGNS

__all__ = ["MOST_EVENTS", "MOST_ROWS", "SCHEMA", "payload"]

SCHEMA = "rqt_mrta_py/report/1"

MOST_ROWS = 2000
"""So many robots, and so many tasks, have a row."""

MOST_EVENTS = 10_000
"""So many events are told; of more those of no severity go first."""

_ROBOT_STATES, _TASK_STATES = list(RobotState), list(TaskState)
_OUTCOMES, _SEVERITIES = list(Outcome), list(Severity)

_RESOLUTION = 0.005
"""Of places, in an arena of up to a hundred metres [m]."""
_TOLERANCE = 2.0
"""How far a pose may lie from the way drawn [resolutions]."""
_YAW = 256
"""So many headings are told apart."""
_YAW_TOLERANCE = 4.0
_GONE = 2
"""Where others say whether a body is held: it is not there any more."""
_SILENCE = 4.0
"""A robot unheard for so many periods, and a second, stays where it was seen last."""
_LEVELS = 1000
"""So many values of a curve are told apart from 0 to the top of its axis."""
_FARTHEST = 1e7
"""Nothing that can be drawn lies farther from the origin [m]."""


def payload(given: ReportInput, colours: TaskColours) -> Dict[str, Any]:
    """Tell a mission.

    Args:
        given: what the report is made from.
        colours: of tasks and curves.
    """
    record, scene = given.view.record, given.view.scene
    clock = _Clock(record.start or 0.0)
    robots = {robot.id: number for number, robot in enumerate(record.robots[:MOST_ROWS])}
    tasks = {task.id: number for number, task in enumerate(record.tasks[:MOST_ROWS])}
    places = {task.id: task for task in given.tasks}
    resolution = _resolution(given)
    tracks = {track.robot: track for track in given.tracks}
    held = [each for each in record.allocations if each.robot in robots and each.task in tasks]
    arena = scene.arena
    return {
        "schema": SCHEMA,
        "names": {
            "robots": [state.value for state in _ROBOT_STATES],
            "tasks": [state.value for state in _TASK_STATES],
            "stages": {state.value: TASK_SIGNS[state] for state in _TASK_STATES},
            "outcomes": [outcome.value for outcome in _OUTCOMES],
            "signs": {outcome.value: OUTCOME_SIGNS[outcome] for outcome in _OUTCOMES},
            "severities": [severity.value for severity in _SEVERITIES],
        },
        "end": clock(record.end or 0.0),
        "robots": [
            {
                "id": words(robot.id),
                "radius": round(tracks[robot.id].radius, 3) if robot.id in tracks else 0.2,
                "states": packed(
                    [clock(each.start) for each in robot.states],
                    [_ROBOT_STATES.index(each.state) for each in robot.states],
                ),
                "track": _track(tracks.get(robot.id), clock, resolution),
                "gone": _gone(tracks.get(robot.id), clock),
            }
            for robot in record.robots[:MOST_ROWS]
        ],
        "tasks": [
            {
                "id": words(task.id),
                "colour": _colour(colours, task.id),
                "kind": words(places[task.id].kind) if task.id in places else "",
                "place": _place(places.get(task.id)),
                "history": packed(
                    [clock(each.start) for each in task.history],
                    [_TASK_STATES.index(each.state) for each in task.history],
                ),
            }
            for task in record.tasks[:MOST_ROWS]
        ],
        "allocations": packed(
            [clock(each.start) for each in held],
            [clock(each.end) for each in held],
            [robots[each.robot] for each in held],
            [tasks[each.task] for each in held],
            [_OUTCOMES.index(each.outcome) for each in held],
        ),
        "incidents": [
            {
                "from": clock(each.start),
                "to": clock(each.end),
                "severity": each.severity.rank,
                "rule": words(each.rule.replace("_", " ")),
                "text": words(each.text),
                "robots": [robots[robot] for robot in each.robots if robot in robots],
                "tasks": [tasks[task] for task in each.tasks if task in tasks],
            }
            for each in record.incidents
        ],
        "labels": [
            [
                clock(label.time),
                words(happening_word(label)),
                robots.get(label.robot, -1),
                tasks.get(label.task, -1),
                words(label.text),
            ]
            for label in scene.labels
        ],
        "events": [
            [clock(each.time), each.severity.rank, words(each.text), robots.get(each.robot or "", -1)]
            for each in _events(given)
        ],
        "arena": None
        if arena is None
        else [round(side, 4) for side in (arena.min_x, arena.min_y, arena.max_x, arena.max_y)],
        "obstacles": [
            [
                *(round(value, 4) for value in (each.pose.x, each.pose.y, each.pose.yaw, each.size[0], each.size[1])),
                int(each.shape == "cylinder"),
            ]
            for each in scene.obstacles
        ],
        "resolution": resolution,
        "bodies": _bodies(given.bodies, clock, resolution),
        "panels": [_panel(panel, colours, clock) for panel in given.view.panels],
    }


class _Clock:
    """Turns the stream's seconds into milliseconds since the mission's start."""

    def __init__(self, start: float) -> None:
        self._start = start

    def __call__(self, time: float) -> int:
        return round((time - self._start) * 1000.0)


def _resolution(given: ReportInput) -> float:
    """Give the unit of places: finer than a pixel of any arena."""
    arena = given.view.scene.arena
    if arena is not None:
        extent = max(arena.max_x - arena.min_x, arena.max_y - arena.min_y)
    else:
        spans = [
            max(values) - min(values)
            for track in given.tracks
            for values in (_near(track.xs), _near(track.ys))
            if values
        ]
        extent = max(spans, default=0.0)
    return max(_RESOLUTION, float(f"{extent / 20_000.0:.1g}"))


def _near(values: Sequence[float]) -> List[float]:
    return [value for value in values if abs(value) < _FARTHEST]


def _gone(track: Optional[RobotTrack], clock: _Clock) -> Optional[int]:
    return None if track is None or track.gone is None else clock(track.gone)


def _track(track: Optional[RobotTrack], clock: _Clock, resolution: float) -> Optional[str]:
    if track is None:
        return None
    kept = [at for at in range(len(track.times)) if abs(track.xs[at]) < _FARTHEST and abs(track.ys[at]) < _FARTHEST]
    if not kept:
        return None
    times, columns = _with_pauses(track, kept, resolution)
    chosen = corners(times, columns, (_TOLERANCE, _TOLERANCE, _YAW_TOLERANCE))
    return packed([clock(times[at]) for at in chosen], *([round(column[at]) for at in chosen] for column in columns))


def _with_pauses(
    track: RobotTrack, kept: Sequence[int], resolution: float
) -> Tuple[List[float], Tuple[List[float], List[float], List[float]]]:
    """Give the poses in the page's units; where a robot was not heard for long, it stands until it is seen again."""
    times: List[float] = []
    xs: List[float] = []
    ys: List[float] = []
    yaws: List[float] = []
    longest = _SILENCE * track.period + 1.0
    for at in kept:
        time, turn = track.times[at], track.yaws[at] * _YAW / (2.0 * math.pi)
        if yaws:
            # The shorter way round, so that nothing spins between two headings.
            turn += _YAW * round((yaws[-1] - turn) / _YAW)
            if time - times[-1] > longest:
                times.append(time - 1e-3)
                xs.append(xs[-1])
                ys.append(ys[-1])
                yaws.append(yaws[-1])
        times.append(time)
        xs.append(track.xs[at] / resolution)
        ys.append(track.ys[at] / resolution)
        yaws.append(turn)
    return times, (xs, ys, yaws)


def _place(task: Any) -> Optional[List[float]]:
    if task is None or task.place is None or not (abs(task.place.x) < _FARTHEST and abs(task.place.y) < _FARTHEST):
        return None
    return [round(task.place.x, 3), round(task.place.y, 3)]


def _colour(colours: TaskColours, label: str) -> int:
    colour = colours[label]
    return TASK_COLOURS.index(colour) if colour in TASK_COLOURS else -1


def _events(given: ReportInput) -> Sequence[Any]:
    events = given.view.record.events
    if len(events) > MOST_EVENTS:
        grave = [number for number, each in enumerate(events) if each.severity is not Severity.INFO][:MOST_EVENTS]
        rest = [number for number, each in enumerate(events) if each.severity is Severity.INFO]
        chosen = sorted([*grave, *rest[: MOST_EVENTS - len(grave)]])
        events = tuple(events[number] for number in chosen)
    return sorted(events, key=lambda each: each.time)


def _bodies(bodies: Sequence[BodyTrack], clock: _Clock, resolution: float) -> List[Mapping[str, Any]]:
    kinds = {kind: number for number, kind in enumerate(sorted({body.kind for body in bodies}))}
    told: List[Mapping[str, Any]] = []
    for body in bodies:
        places = [place for place in body.places if abs(place.x) < _FARTHEST and abs(place.y) < _FARTHEST]
        if places:
            told.append(
                {
                    "id": words(body.id),
                    "kind": words(body.kind),
                    "colour": kinds[body.kind] % len(BODY_COLOURS),
                    "length": round(body.length, 3),
                    "width": round(body.width, 3),
                    "places": packed(
                        [clock(place.time) for place in places],
                        [round(place.x / resolution) for place in places],
                        [round(place.y / resolution) for place in places],
                        [int(place.held) if place.is_there else _GONE for place in places],
                        [round(math.degrees(place.yaw)) for place in places],
                        [round(min(place.lift, _FARTHEST) / resolution) for place in places],
                    ),
                }
            )
    return told


def _panel(panel: CurvePanel, colours: TaskColours, clock: _Clock) -> Mapping[str, Any]:
    top = panel.top if math.isfinite(panel.top) and panel.top > 0.0 else 1.0
    reference = panel.reference
    return {
        "title": words(panel.title),
        "unit": words(panel.unit),
        "top": float(f"{top:.6g}"),
        "reference": None if reference is None or not math.isfinite(reference) else float(f"{reference:.6g}"),
        "levels": _LEVELS,
        "groups": [
            {
                "id": words(group.label),
                "curves": [
                    {
                        "label": words(curve.label),
                        "colour": _colour(colours, curve.label),
                        "points": _points(curve, top, clock),
                    }
                    for curve in group.curves
                    if any(not math.isnan(value) for value in curve.values)
                ],
            }
            for group in panel.groups[:MOST_ROWS]
        ],
    }


def _points(curve: Curve, top: float, clock: _Clock) -> str:
    """Pack a curve: milliseconds and levels; -1 where a stroke ends."""
    times: List[int] = []
    levels: List[int] = []
    for stroke in _strokes(curve):
        if times:
            times.append(clock(curve.times[stroke[0]]))
            levels.append(-1)
        since = [curve.times[at] for at in stroke]
        heights = [min(max(curve.values[at] / top, 0.0), 2.0) * _LEVELS for at in stroke]
        chosen = corners(since, (heights,), (1.0,))
        times += [clock(since[at]) for at in chosen]
        levels += [round(heights[at]) for at in chosen]
    return packed(times, levels)


def _strokes(curve: Curve) -> List[List[int]]:
    strokes: List[List[int]] = [[]]
    for at, value in enumerate(curve.values):
        if math.isnan(value):
            strokes.append([])
        else:
            strokes[-1].append(at)
    return [stroke for stroke in strokes if stroke]
