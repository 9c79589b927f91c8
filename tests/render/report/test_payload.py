from __future__ import annotations

import math
from dataclasses import replace

import pytest

from rqt_mrta_py.hooks import Curve, CurveGroup, CurvePanel
from rqt_mrta_py.model import Event, RobotState, Severity, TaskState
from rqt_mrta_py.render.body_keeper import BodyPlace, BodyTrack
from rqt_mrta_py.render.palette import TaskColours
from rqt_mrta_py.render.pose_log import RobotTrack
from rqt_mrta_py.render.report.fine_curves import fine_panel
from rqt_mrta_py.render.report.packing import unpacked
from rqt_mrta_py.render.report.payload import MOST_EVENTS, payload
from rqt_mrta_py.render.report.report_input import ReportInput
from tests.render.report.missions import empty_mission, usual_mission


def told(given: ReportInput) -> dict:
    return payload(given, TaskColours.of(given.view))


def with_track(*poses: tuple[float, float, float, float]) -> dict:
    given = usual_mission()
    times, xs, ys, yaws = zip(*poses)
    return told(replace(given, tracks=(RobotTrack("robot1", 0.2, 0.2, times, xs, ys, yaws),)))


def test_states_are_told_in_milliseconds_since_the_start() -> None:
    data = told(usual_mission())
    times, states = unpacked(data["robots"][2]["states"], 2)
    # robot3 takes border_protection at 5.2 s and is silent from 63 s on, the stream's first message being at 1 s.
    assert dict(zip(times, [data["names"]["robots"][state] for state in states]))[62000] == RobotState.OFFLINE.value
    assert data["end"] == 90000
    times, states = unpacked(data["tasks"][1]["history"], 2)
    assert data["names"]["tasks"][states[-1]] == TaskState.EXECUTING.value


def test_a_robot_on_a_straight_way_is_told_by_its_ends() -> None:
    data = with_track(*((1.0 + 0.2 * step, 0.1 * step, 0.0, 0.0) for step in range(21)))
    times, xs, ys, yaws = unpacked(data["robots"][0]["track"], 4)
    assert times == [0, 4000]
    assert [x * data["resolution"] for x in xs] == pytest.approx([0.0, 2.0])
    assert (ys, yaws) == ([0, 0], [0, 0])


def test_a_robot_that_was_not_heard_stands_until_it_is_seen_again() -> None:
    data = with_track((1.0, 0.0, 0.0, 0.0), (2.0, 1.0, 0.0, 0.0), (30.0, 3.0, 0.0, 0.0))
    times, xs, _, _ = unpacked(data["robots"][0]["track"], 4)
    assert dict(zip(times, [x * data["resolution"] for x in xs])) == pytest.approx({0: 0, 1000: 1, 28999: 1, 29000: 3})


def test_headings_turn_the_shorter_way_round() -> None:
    data = with_track((1.0, 0.0, 0.0, 3.1), (1.2, 0.0, 0.0, -3.1))
    yaws = unpacked(data["robots"][0]["track"], 4)[3]
    assert abs(yaws[1] - yaws[0]) < 8


def test_places_beyond_all_arenas_are_left_out() -> None:
    data = with_track((1.0, 1e300, 0.0, 0.0), (2.0, 0.0, -1e12, 0.0))
    assert data["robots"][0]["track"] is None


def test_a_robot_that_was_taken_away_is_gone_from_then_on() -> None:
    assert with_track((1.0, 0.0, 0.0, 0.0))["robots"][0]["gone"] is None
    given = usual_mission()
    track = RobotTrack("robot1", 0.2, 0.2, (1.0,), (0.0,), (0.0,), (0.0,), 31.5)
    assert told(replace(given, tracks=(track,)))["robots"][0]["gone"] == 30500


def test_strokes_of_curves_end_where_nothing_is_known() -> None:
    curve = Curve("wander", (1.0, 2.0, 3.0, 3.0, 4.0), (0.0, 0.5, math.nan, 1.0, 1.0))
    panel = CurvePanel("motivation", "1", 1.0, 1.0, (CurveGroup("robot1", (curve,)),))
    given = usual_mission()
    data = told(replace(given, view=replace(given.view, panels=(panel,))))
    points = unpacked(data["panels"][0]["groups"][0]["curves"][0]["points"], 2)
    assert points == [[0, 1000, 2000, 2000, 3000], [0, 500, -1, 1000, 1000]]


def test_of_too_many_events_the_grave_ones_stay() -> None:
    given = usual_mission()
    events = tuple(Event(1.0 + n / 1000.0, "robot_state", Severity.INFO, str(n)) for n in range(MOST_EVENTS + 5))
    events += (Event(50.0, "incident", Severity.ERROR, "grave"),)
    data = told(replace(given, view=replace(given.view, record=replace(given.view.record, events=events))))
    assert len(data["events"]) == MOST_EVENTS
    assert data["events"][-1][2] == "grave"


def test_nothing_heard_is_told_too() -> None:
    data = told(empty_mission())
    assert (data["end"], data["robots"], data["tasks"], data["arena"]) == (0, [], [], None)


def test_panels_are_asked_for_stretches_and_points_come_once() -> None:
    asked = []

    def view(start: float, end: float) -> CurvePanel:
        asked.append((start, end))
        times = tuple(float(second) for second in range(math.ceil(start), math.floor(end) + 1))
        curve = Curve("wander", times, times)
        return CurvePanel("p", "1", 9.0, None, (CurveGroup("robot1", (curve,)),))

    panel = fine_panel(view, 0.0, 120.0)
    assert asked[1:] == [(0.0, 30.0), (30.0, 60.0), (60.0, 90.0), (90.0, 120.0)]
    assert panel.groups[0].curves[0].times == tuple(float(second) for second in range(121))
    assert fine_panel(view, 0.0, 40.0).groups[0].curves[0].times == tuple(float(second) for second in range(41))


def test_a_body_that_was_taken_away_is_told_as_gone_where_it_was() -> None:
    lying = BodyPlace(1.0, 1.0, 0.5, 0.0, 0.0, held=False)
    places = (lying, lying._replace(time=3.0, held=True), lying._replace(time=6.0, is_there=False))
    (body,) = told(replace(usual_mission(), bodies=(BodyTrack("can", "paper", 0.4, 0.1, places),)))["bodies"]
    times, xs, _, states, _, _ = unpacked(body["places"], 6)
    assert (times, states) == ([0, 2000, 5000], [0, 1, 2])
    assert len(set(xs)) == 1
