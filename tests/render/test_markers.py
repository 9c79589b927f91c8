from __future__ import annotations

import math
from collections import Counter
from dataclasses import replace
from typing import Any, Dict, List

import pytest

from rqt_mrta_py.hooks import MonitorView
from rqt_mrta_py.render import team_markers
from tests.render import views

ADD, DELETE = 0, 2
ALL = [views.patrol(), views.patrol(64.0), views.crowd(), views.single(), views.empty()]


def markers(view: MonitorView) -> List[Dict[str, Any]]:
    outgoing = team_markers(view, view.now)
    assert (outgoing.topic, outgoing.type) == ("/mrta/markers", "visualization_msgs/MarkerArray")
    found: List[Dict[str, Any]] = outgoing.fields["markers"]
    return found


@pytest.mark.parametrize("view", ALL)
def test_markers_have_unique_ids_the_frame_map_and_unit_quaternions(view: MonitorView) -> None:
    found = markers(view)
    assert max(Counter((marker["ns"], marker["id"]) for marker in found).values(), default=1) == 1
    for marker in found:
        assert marker["header"] == {"stamp": view.now, "frame_id": "map"}
        turned = marker["pose"]["orientation"]
        assert math.fsum(part * part for part in turned.values()) == pytest.approx(1.0)
        assert marker["lifetime"] > 0.0
        if marker["action"] == ADD:
            assert marker["color"]["a"] == 1.0


def test_markers_show_each_robot_where_it_is() -> None:
    view = views.patrol()
    bodies = [marker for marker in markers(view) if marker["ns"] == "robots"]
    assert [marker["id"] for marker in bodies] == [0, 1, 2, 3, 4]
    for marker, robot in zip(bodies, view.scene.robots):
        assert robot.pose is not None
        position = marker["pose"]["position"]
        assert (position["x"], position["y"]) == (robot.pose.x, robot.pose.y)
        assert marker["scale"]["x"] == 2.0 * robot.radius


def test_markers_name_robots_and_places() -> None:
    texts = {(marker["ns"], marker["text"]) for marker in markers(views.patrol()) if "text" in marker}
    assert texts == {("robot_names", f"robot{i}") for i in range(1, 6)} | {
        ("task_names", "border_protection"),
        ("task_names", "report"),
    }


def test_markers_join_a_robot_to_the_place_of_its_task() -> None:
    view = views.patrol()
    lines = {marker["ns"]: marker for marker in markers(view) if marker["ns"].startswith("allocations/")}
    assert sorted(lines) == ["allocations/robot1", "allocations/robot4"]
    line, pose = lines["allocations/robot1"], view.scene.robots[0].pose
    assert pose is not None
    assert line["id"] == 1  # border_protection is the second task
    assert [(point["x"], point["y"]) for point in line["points"]] == [(pose.x, pose.y), (4.2, 3.4)]


def test_markers_delete_the_line_of_an_allocation_that_just_ended() -> None:
    def lines(now: float) -> Dict[Any, int]:
        found = markers(views.patrol(now))
        return {(m["ns"], m["id"]): m["action"] for m in found if m["ns"].startswith("allocations/")}

    key = ("allocations/robot3", 1)
    assert lines(62.0)[key] == ADD
    assert lines(64.0)[key] == DELETE
    assert key not in lines(70.0)


def test_markers_keep_the_line_of_a_task_taken_again() -> None:
    """A pair that ended and began again within a lifetime must not be deleted."""
    view = views.patrol(91.0)
    record = view.record
    ended = record.allocations[-2]._replace(end=90.5)
    again = record.allocations[-2]._replace(start=90.5)
    view = replace(view, record=replace(record, allocations=(*record.allocations[:-2], ended, again)))
    assert all(marker["action"] == ADD for marker in markers(view))


def test_markers_keep_the_ids_of_tasks_when_another_is_withdrawn() -> None:
    view = views.patrol()
    before, after = (
        {
            marker["text"]: marker["id"]
            for marker in team_markers(each, 92.0).fields["markers"]
            if marker["ns"] == "task_names"
        }
        for each in (view, replace(view, scene=replace(view.scene, tasks=view.scene.tasks[2:])))
    )
    assert before == {"border_protection": 1, "report": 2}
    assert after == {"report": 2}
