"""Motivation against threshold, for pictures."""

from __future__ import annotations

import math
from typing import List, Optional, Sequence, Tuple

from mrta_alliance.panel import MotivationPanel

from rqt_mrta_py.hooks import Curve, CurvePanel, Heard, PanelSetup
from rqt_mrta_py.model import ApplicationRobot, ApplicationSpec, ArchitectureSpec, Mission, Task, Taxonomy


def panel(robots: Sequence[ApplicationRobot] = (ApplicationRobot("b"), ApplicationRobot("a"))) -> MotivationPanel:
    mission = Mission(
        ApplicationSpec("app", "App", robots=tuple(robots)),
        ArchitectureSpec("mrta_alliance", "ALLIANCE", Taxonomy()),
        (Task("patrol", "anything"), Task("inspect", "anything")),
    )
    return MotivationPanel(PanelSetup(mission))


def felt(receipt: float, motivation: float, robot: str = "a", task: str = "patrol", threshold: float = 30.0) -> Heard:
    fields = {"header/frame_id": f"/{robot}", "task_id": task, "motivation": motivation, "threshold": threshold}
    return Heard(f"/{robot}/alliance/motivation/{task}", "alliance_msgs/Motivation", receipt, fields, robot, task)


def curve(view: CurvePanel, robot: str = "a", task: str = "patrol") -> Curve:
    (found,) = (c for group in view.groups if group.label == robot for c in group.curves if c.label == task)
    return found


def points(found: Curve) -> List[Tuple[float, Optional[float]]]:
    return [(time, None if math.isnan(value) else value) for time, value in zip(found.times, found.values)]


def test_panel_shows_every_robot_and_task_of_the_mission_in_order_before_anything_is_heard() -> None:
    view = panel().view(0.0, 10.0)
    assert [group.label for group in view.groups] == ["b", "a"]
    assert [[c.label for c in group.curves] for group in view.groups] == [["patrol", "inspect"]] * 2
    assert (view.unit, view.reference) == ("1", 1.0)
    assert 1.05 <= view.top <= 1.1


def test_panel_hears_all_motivations() -> None:
    assert [wish.topic for wish in panel().subscriptions()] == ["/@robot_id@/alliance/motivation/@task_id@"]


def test_panel_shows_a_robot_only_its_own_tasks() -> None:
    view = panel([ApplicationRobot("a", ("inspect",))]).view(0.0, 10.0)
    assert [[c.label for c in group.curves] for group in view.groups] == [["inspect"]]


def test_panel_shows_the_share_of_the_threshold() -> None:
    shown = panel()
    shown.hear(felt(1.0, 7.5))
    shown.hear(felt(1.2, 15.0))
    assert points(curve(shown.view(0.0, 10.0))) == [(1.0, 0.25), (1.2, 0.5)]


def test_panel_lets_strangers_join_at_the_end() -> None:
    shown = panel()
    shown.hear(felt(1.0, 3.0, robot="z", task="cook"))
    view = shown.view(0.0, 10.0)
    assert [group.label for group in view.groups] == ["b", "a", "z"]
    assert points(curve(view, "z", "cook")) == [(1.0, 0.1)]


def test_panel_breaks_a_line_at_a_reset() -> None:
    shown = panel()
    for receipt, motivation in ((1.0, 15.0), (1.2, 0.0), (1.4, 15.0)):
        shown.hear(felt(receipt, motivation))
    assert points(curve(shown.view(0.0, 10.0))) == [(1.0, 0.5), (1.2, None), (1.2, 0.0), (1.4, 0.5)]


def test_panel_breaks_a_line_at_a_silence() -> None:
    shown = panel()
    for receipt, motivation in ((1.0, 15.0), (3.5, 15.0)):
        shown.hear(felt(receipt, motivation))
    assert points(curve(shown.view(0.0, 10.0))) == [(1.0, 0.5), (3.5, None), (3.5, 0.5)]


def test_panel_leaves_out_what_cannot_be_drawn() -> None:
    shown = panel()
    shown.hear(felt(1.0, 3.0, threshold=0.0))
    shown.hear(felt(1.2, math.inf))
    assert points(curve(shown.view(0.0, 10.0))) == []


def test_panel_keeps_times_in_order_when_the_stream_does_not() -> None:
    shown = panel()
    shown.hear(felt(5.0, 3.0))
    shown.hear(felt(4.0, 6.0))
    assert points(curve(shown.view(0.0, 10.0))) == [(5.0, 0.1), (5.0, 0.2)]


def test_panel_view_takes_both_its_ends_in() -> None:
    shown = panel()
    for second in range(1, 7):
        shown.hear(felt(float(second), 3.0 * second))
    assert curve(shown.view(2.0, 4.0)).times == (2.0, 3.0, 4.0)
    assert curve(shown.view(7.0, 9.0)).times == ()


def ramps(cycles: int) -> MotivationPanel:
    """Give a motivation that grows over 50 cycles of 0.2 s, falls to 0, and so on."""
    shown = panel()
    for cycle in range(cycles):
        shown.hear(felt(1.0 + cycle * 0.2, 0.6 * (cycle % 50)))
    return shown


def test_panel_thins_a_long_curve_but_keeps_the_ends_of_strokes() -> None:
    found = curve(ramps(5000).view(0.0, 2000.0))
    assert len(found.times) <= 900
    assert list(found.times) == sorted(found.times)
    assert sum(math.isnan(value) for value in found.values) == 99
    assert max(value for value in found.values if not math.isnan(value)) == 0.98
    for at, value in enumerate(found.values):
        if math.isnan(value):
            assert (found.values[at - 1], found.values[at + 1]) == (0.98, 0.0)


def test_panel_thins_to_points_that_stay_from_view_to_view() -> None:
    """Every n-th point counted from the beginning: what both views show of the inside they show alike."""
    shown = ramps(5000)
    one, two = curve(shown.view(100.0, 900.0)), curve(shown.view(100.2, 900.2))
    assert set(one.times[2:-2]) <= set(two.times) | {100.0, 100.2}


def test_panel_views_are_equal_for_equal_streams() -> None:
    """Compared as text, for NaN is not equal to itself."""
    assert repr(ramps(3000).view(100.0, 500.0)) == repr(ramps(3000).view(100.0, 500.0))
