from __future__ import annotations

import pytest
from basic_behaviours import plugin

from rqt_mrta_py.model import Pose, Task
from tests.plugins.basic_behaviours.perception import Perceived, make_setup


def test_behaviours_are_registered_by_kind() -> None:
    assert sorted(plugin.mrta_register_behaviours()) == [
        "avoid",
        "collect",
        "follow_border",
        "go_to_place",
        "report",
        "wander",
    ]


def test_behaviours_are_applicable_once_pose_and_scan_are_known() -> None:
    task = Task("t", "any", place=Pose(3.0, 3.0))
    for kind, make in plugin.mrta_register_behaviours().items():
        if kind == "collect":
            continue  # it wants a detector and a gripper too, see test_collect
        behaviour = make(make_setup())
        assert not behaviour.applicable(task, Perceived())
        placed = Perceived(Pose(1.0, 1.0))
        assert not behaviour.applicable(task, placed)
        placed.look_around()
        assert behaviour.applicable(task, placed)


def test_costs_are_the_way_before_the_work_begins() -> None:
    here = Perceived(Pose(2.05, 3.05))
    here.look_around()
    makers = plugin.mrta_register_behaviours()
    costs = {
        kind: make(make_setup()).cost(Task("t", kind, place=Pose(8.05, 3.05)), here)
        for kind, make in makers.items()
        if kind != "collect"
    }
    # Straight along a row of cells to the place; to the wall at x = 0 less the distance to be kept from it.
    expected = {"avoid": 0.0, "wander": 0.0, "go_to_place": 6.0, "report": 6.0, "follow_border": 2.05 - 0.6}
    assert costs == pytest.approx(expected)
