from __future__ import annotations

import math

import pytest
from mrta_demir_cf.message_kinds import Kind
from mrta_demir_cf.messages import Speaker
from mrta_demir_cf.panel import CostPanel

from rqt_mrta_py.hooks import Curve, CurveGroup, PanelSetup
from rqt_mrta_py.model import ApplicationRobot, ApplicationSpec, ArchitectureSpec, Mission, Task, Taxonomy
from tests.plugins.mrta_demir_cf.script import as_heard


@pytest.fixture
def panel() -> CostPanel:
    robots = (ApplicationRobot("a", ("t",)), ApplicationRobot("b"))
    architecture = ArchitectureSpec("mrta_demir_cf", "DEMiR-CF", Taxonomy.parse("ST-SR-IA"))
    tasks = (Task("t", "any"), Task("u", "any"))
    return CostPanel(PanelSetup(Mission(ApplicationSpec("yard", "Yard", robots=robots), architecture, tasks)))


def tell(panel: CostPanel, time: float, cost: float, robot: str = "a", task: str = "t") -> None:
    speaker = Speaker(robot)
    speaker.say(Kind.EXECUTION, task, cost=cost, eta=1.0, perpetual=False, ordered=False)
    panel.hear(as_heard(speaker.take()[0], time))


def test_every_robot_has_a_curve_for_each_of_its_tasks_from_the_start(panel: CostPanel) -> None:
    view = panel.view(0.0, 10.0)
    assert view.groups == (
        CurveGroup("a", (Curve("t", (), ()),)),
        CurveGroup("b", (Curve("t", (), ()), Curve("u", (), ()))),
    )
    assert (view.title, view.unit, view.top) == ("Cost of the task carried out", "m", 1.0)


def test_curves_show_what_is_left_within_the_time_asked_for(panel: CostPanel) -> None:
    for time in (2.0, 4.0, 6.0, 8.0):
        tell(panel, time, 40.0 - 4.0 * time)
    view = panel.view(4.0, 6.0)
    assert view.groups[0].curves == (Curve("t", (4.0, 6.0), (24.0, 16.0)),)
    assert view.top == 50.0


def test_no_line_is_drawn_from_one_time_with_a_task_to_the_next(panel: CostPanel) -> None:
    tell(panel, 2.0, 3.0)
    tell(panel, 12.0, 5.0)
    curve = panel.view(0.0, 20.0).groups[0].curves[0]
    assert curve.times == (2.0, 12.0, 12.0)
    assert math.isnan(curve.values[1])


def test_costs_that_are_no_numbers_are_not_drawn(panel: CostPanel) -> None:
    tell(panel, 2.0, math.nan, "stranger")
    assert len(panel.view(0.0, 9.0).groups) == 2
    tell(panel, 3.0, 1.0, "stranger")
    assert panel.view(0.0, 9.0).groups[2].label == "stranger"


def test_long_missions_are_thinned(panel: CostPanel) -> None:
    for number in range(3000):
        tell(panel, 2.0 * number, 1.0)
    assert len(panel.view(0.0, 6000.0).groups[0].curves[0].times) <= 400


def test_what_stands_for_an_unknown_cost_is_not_drawn() -> None:
    mission = Mission(
        ApplicationSpec("yard", "Yard", robots=(ApplicationRobot("a"), ApplicationRobot("b"))),
        ArchitectureSpec("mrta_demir_cf", "DEMiR-CF", Taxonomy.parse("ST-SR-IA")),
        (Task("t", "any"),),
        parameters={"b": {"unknown_cost": 70.0}},
    )
    panel = CostPanel(PanelSetup(mission))
    for robot in ("a", "b"):
        for time, cost in ((1.0, 1000.0), (2.0, 70.0), (3.0, 4.0)):
            tell(panel, time, cost, robot)
    values = [group.curves[0].values for group in panel.view(0.0, 9.0).groups]
    assert values == [(70.0, 4.0), (1000.0, 4.0)]
