"""The monitor panel with all that a motivation is made of."""

from __future__ import annotations

import math
from typing import Dict, List, Tuple

import mrta_alliance.plugin
import pytest
from mrta_alliance.detailed_panel import LANES, DetailedPanel
from mrta_alliance.inner_life import FLAGS

from rqt_mrta_py.hooks import Curve, CurveGroup, CurvePanel, Heard, PanelSetup
from tests.plugins.mrta_alliance.test_figures import MISSION, expected, felt


def view(start: float, end: float, *messages: Heard) -> CurvePanel:
    panel = DetailedPanel(PanelSetup(MISSION))
    for message in messages:
        panel.hear(message)
    return panel.view(start, end)


def lanes(group: CurveGroup) -> Dict[str, Curve]:
    return {curve.label: curve for curve in group.curves}


def heights(curve: Curve, lane: str) -> List[Tuple[float, float]]:
    """Give the points of a curve with their height above the floor of their lane, as a share of what is filled."""
    floor = len(LANES) - 1 - LANES.index(lane)
    return [(time, round((value - floor) / 0.7, 6)) for time, value in zip(curve.times, curve.values)]


def test_the_panel_is_registered_under_a_name_that_files_may_list() -> None:
    assert mrta_alliance.plugin.mrta_register_monitor_panels()["rqt_alliance/detailed"] is DetailedPanel


def test_nothing_heard_is_a_panel_without_charts() -> None:
    assert view(0.0, 60.0) == CurvePanel("Behaviour sets in detail", "1", 8.0, None, ())


def test_lanes_stand_in_the_order_of_rqt_alliance_with_the_time_to_activation_below() -> None:
    (group,) = view(0.0, 60.0, felt(10.0), expected(10.0, "a", patrol=30.0)).groups
    assert tuple(lanes(group)) == LANES == ("motivation", "impatience", *FLAGS, "time to activation")
    floors = [min(curve.values) for curve in group.curves]
    assert floors == sorted(floors, reverse=True)


def test_each_robot_shows_its_foremost_behaviour_set() -> None:
    told = (felt(10.0, "a", "patrol", motivation=3.0), felt(10.0, "a", "inspect", motivation=30.0), felt(10.0, "b"))
    assert [group.label for group in view(0.0, 60.0, *told).groups] == ["b patrol", "a inspect"]
    later = felt(11.0, "a", "inspect", motivation=0.0)
    assert [group.label for group in view(0.0, 60.0, *told, later).groups] == ["b patrol", "a patrol"]
    assert [group.label for group in view(0.0, 10.5, *told, later).groups] == ["b patrol", "a inspect"]


def test_values_are_shares_of_threshold_and_largest_impatience_and_minute() -> None:
    told = (felt(10.0, impatience=2.0), felt(11.0, motivation=15.0, impatience=1.0), expected(11.0, "a", patrol=90.0))
    curves = lanes(view(0.0, 60.0, *told).groups[0])
    assert heights(curves["motivation"], "motivation")[-1] == (11.0, 0.5)
    assert heights(curves["impatience"], "impatience") == [(10.0, 1.0), (11.0, 1.0), (11.0, 0.5), (11.0, 0.5)]
    assert heights(curves["time to activation"], "time to activation") == [(11.0, 1.0)]


def test_flags_go_up_and_down_at_once() -> None:
    told = (felt(10.0), felt(10.2, resetted=True), felt(10.4))
    curve = lanes(view(0.0, 60.0, *told).groups[0])["resetted"]
    assert heights(curve, "resetted") == [
        *((10.0, 0.0), (10.2, 0.0), (10.2, 1.0)),
        *((10.4, 1.0), (10.4, 0.0), (10.4, 0.0)),
    ]


def test_what_stands_still_has_points_wherever_a_picture_may_cut() -> None:
    """Of a value that stands still both ends are kept only, and pictures show what lies within their last minute."""
    told = [felt(0.2 * n, motivation=30.0, active=True) for n in range(1, 600)]
    for curve in lanes(view(50.5, 100.25, *told).groups[0]).values():
        if curve.label != "time to activation":
            assert (curve.times[0], curve.times[-1]) == (50.5, 100.25)
            assert max(b - a for a, b in zip(curve.times, curve.times[1:])) <= 1.0
            assert list(curve.times) == sorted(curve.times)
            assert not any(map(math.isnan, curve.values))


def test_a_line_is_cut_where_it_crosses_the_ends() -> None:
    told = (felt(10.0, motivation=0.0), felt(11.9, motivation=19.0))
    curve = lanes(view(10.5, 11.5, *told).groups[0])["motivation"]
    assert heights(curve, "motivation") == [
        (10.5, pytest.approx(5 / 30, abs=1e-6)),
        (11.0, pytest.approx(1 / 3, abs=1e-6)),
        (11.5, 0.5),
    ]
