from __future__ import annotations

from typing import Any, Mapping

import pytest
from basic_behaviours.avoid import AvoidSettings
from basic_behaviours.collect_settings import CollectSettings
from basic_behaviours.follow_border import FollowBorder, FollowBorderSettings
from basic_behaviours.go_to_place import GoToPlace
from basic_behaviours.report import Report, ReportSettings
from basic_behaviours.settings import SettingsReader
from basic_behaviours.wander import Wander, WanderSettings

from rqt_mrta_py.hooks import BehaviourFactory
from rqt_mrta_py.model import Task
from tests.plugins.basic_behaviours.perception import Perceived, make_setup


def test_settings_take_defaults_for_what_is_left_out() -> None:
    task = Task("w", "wander", data={"speed": 1})
    assert SettingsReader(WanderSettings).read(task) == WanderSettings(speed=1.0, period=10.0)


def test_settings_are_read_once_for_each_task() -> None:
    reader = SettingsReader(AvoidSettings)
    task = Task("a", "avoid")
    assert reader.read(task) is reader.read(task)
    assert reader.read(Task("a", "avoid", data={"speed": 0.1})).speed == 0.1


@pytest.mark.parametrize(
    ("settings", "data", "message"),
    [
        (WanderSettings, {"sped": 1}, "data has no 'sped'; it may have speed, period; did you mean 'speed'?"),
        (WanderSettings, {7: 1}, "data has no 7; it may have speed, period"),
        (WanderSettings, {"speed": "fast"}, "data/speed: must be a finite number (got 'fast')"),
        (WanderSettings, {"speed": True}, "data/speed: must be a finite number (got True)"),
        (WanderSettings, {"speed": float("nan")}, "data/speed: must be a finite number (got nan)"),
        (WanderSettings, {"speed": 0.0}, "data/speed: must be from 0.02 to 5 m/s (got 0.0)"),
        (AvoidSettings, {"distance": -1}, "data/distance: must be from 0.05 to 10 m (got -1.0)"),
        (FollowBorderSettings, {"sense": 3}, "data/sense: must be text (got 3)"),
        (
            FollowBorderSettings,
            {"sense": "left"},
            "data/sense: must be one of counterclockwise, clockwise (got 'left')",
        ),
        (ReportSettings, {"count": 1.5}, "data/count: must be a whole number (got 1.5)"),
        (ReportSettings, {"count": 0}, "data/count: must be from 1 to 1e+06 reports (got 0)"),
        (CollectSettings, {"x": 0, "y": 0}, "data/thing: must name the kind of things to collect (got nothing)"),
        (CollectSettings, {"thing": "can", "x": 0}, "data/y: must tell where the centre of the area is (got nothing)"),
        (
            CollectSettings,
            {"thing": "can", "x": 0, "y": 0, "area": "square"},
            "data/area: must be one of rectangle, circle (got 'square')",
        ),
        (
            CollectSettings,
            {"thing": "can", "x": 0, "y": 0, "spacing": 0.1},
            "data/spacing: must be from 0.2 to 100 m (got 0.1)",
        ),
        (
            CollectSettings,
            {"thing": "can", "x": 0, "y": 0, "tries": 0},
            "data/tries: must be from 1 to 1000 times (got 0)",
        ),
        (ReportSettings, {"period": 0}, "data/period: must be from 0.1 to 3600 s (got 0.0)"),
    ],
)
def test_settings_name_task_key_and_what_is_accepted(settings: Any, data: Mapping[Any, Any], message: str) -> None:
    with pytest.raises(ValueError, match="task 't1'") as caught:
        SettingsReader(settings).read(Task("t1", "kind", data=data))
    assert str(caught.value) == f"task 't1': {message}"


@pytest.mark.parametrize("behaviour", [GoToPlace, Report])
def test_behaviours_for_a_place_refuse_a_task_without_one(behaviour: BehaviourFactory) -> None:
    with pytest.raises(ValueError, match="task 't1': place: a task of kind 'go' needs one"):
        behaviour(make_setup()).applicable(Task("t1", "go"), Perceived())


def test_follow_border_refuses_a_distance_that_the_robot_does_not_fit_into() -> None:
    with pytest.raises(ValueError, match=r"data/distance: must be at least 0\.3 m for a robot of radius 0\.2 m"):
        FollowBorder(make_setup()).start(Task("t1", "follow_border", data={"distance": 0.25}), Perceived())


def test_wrong_data_are_found_before_a_task_starts() -> None:
    with pytest.raises(ValueError, match="task 't1': data has no 'distance'"):
        Wander(make_setup()).applicable(Task("t1", "wander", data={"distance": 1}), Perceived())
