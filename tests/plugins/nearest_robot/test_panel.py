from __future__ import annotations

import math

import pytest
from nearest_robot.panel import CostPanel

from rqt_mrta_py.hooks import Curve, CurveGroup, PanelSetup
from rqt_mrta_py.model import ApplicationRobot, ApplicationSpec, ArchitectureSpec, Mission, Task, Taxonomy
from tests.plugins.nearest_robot.team import bid


@pytest.fixture
def panel() -> CostPanel:
    robots = (ApplicationRobot("a", ("t",)), ApplicationRobot("b"))
    architecture = ArchitectureSpec("nearest_robot", "Nearest robot", Taxonomy.parse("ST-SR-IA"))
    tasks = (Task("t", "any"), Task("u", "any"))
    return CostPanel(PanelSetup(Mission(ApplicationSpec("yard", "Yard", robots=robots), architecture, tasks)))


def test_every_robot_has_a_curve_for_each_of_its_tasks_from_the_start(panel: CostPanel) -> None:
    view = panel.view(0.0, 10.0)
    assert view.groups == (
        CurveGroup("a", (Curve("t", (), ()),)),
        CurveGroup("b", (Curve("t", (), ()), Curve("u", (), ()))),
    )
    assert (view.title, view.unit, view.top, view.reference) == ("Cost", "m", 1.0, None)


def test_curves_show_costs_within_the_time_asked_for(panel: CostPanel) -> None:
    for time in (1.0, 2.0, 3.0, 4.0):
        panel.hear(bid("a", {"t": 10.0 * time}, time))
    view = panel.view(2.0, 3.0)
    assert view.groups[0].curves == (Curve("t", (2.0, 3.0), (20.0, 30.0)),)
    assert view.top == 50.0


def test_no_line_is_drawn_across_a_silence(panel: CostPanel) -> None:
    panel.hear(bid("a", {"t": 1.0}, 1.0))
    panel.hear(bid("a", {"t": 2.0}, 4.0))
    curve = panel.view(0.0, 10.0).groups[0].curves[0]
    assert curve.times == (1.0, 4.0, 4.0)
    assert math.isnan(curve.values[1])


def test_long_missions_are_thinned_to_the_same_points_from_picture_to_picture(panel: CostPanel) -> None:
    for index in range(3000):
        panel.hear(bid("a", {"t": 1.0}, 1.0 + 0.2 * index))
    first = panel.view(0.0, 500.0).groups[0].curves[0].times
    second = panel.view(1.0, 501.0).groups[0].curves[0].times
    assert 200 <= len(first) <= 400
    assert set(second[:-1]) <= {*first, *second[-2:]}


def test_strangers_join_at_the_end(panel: CostPanel) -> None:
    panel.hear(bid("z", {"w": 1.0}, 1.0))
    assert panel.view(0.0, 2.0).groups[-1] == CurveGroup("z", (Curve("w", (1.0,), (1.0,)),))


@pytest.mark.parametrize(("cost", "top"), [(0.3, 1.0), (1.0, 1.0), (1.1, 2.0), (4.2, 5.0), (7.0, 10.0), (120.0, 200.0)])
def test_axis_ends_at_a_round_number(panel: CostPanel, cost: float, top: float) -> None:
    panel.hear(bid("a", {"t": cost}, 1.0))
    assert panel.view(0.0, 2.0).top == top


def test_what_stands_for_an_unknown_cost_is_not_drawn(panel: CostPanel) -> None:
    for time, cost in ((1.0, 1000.0), (2.0, 4.0)):
        panel.hear(bid("a", {"t": cost}, time))
    assert panel.view(0.0, 9.0).groups[0].curves[0].values == (4.0,)
