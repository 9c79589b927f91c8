"""The figures ``alliance``: of what a test tells, and of the recording of the original nodes."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Callable, Dict, List, Sequence, Tuple

import pytest
from mrta_alliance.figures import AllianceFigures
from mrta_alliance.inner_life import FLAGS

from rqt_mrta_py.app.compose import compose
from rqt_mrta_py.app.observation import Observation
from rqt_mrta_py.config.mission import load_observed
from rqt_mrta_py.hooks import Chart, Figure, FigureSetup, Heard, Line, LineStyle
from rqt_mrta_py.model import (
    ApplicationRobot,
    ApplicationSpec,
    ArchitectureSpec,
    Mission,
    MissionRecord,
    Task,
    Taxonomy,
)
from rqt_mrta_py.transport import read_bag

MISSION = Mission(
    ApplicationSpec("app", "App", robots=(ApplicationRobot("b"), ApplicationRobot("a"))),
    ArchitectureSpec("mrta_alliance", "ALLIANCE", Taxonomy()),
    (Task("patrol", "anything"), Task("inspect", "anything")),
)
RECORD = MissionRecord("app", "mrta_alliance", Taxonomy(), 0, 10.0, 20.0, (), (), (), (), ())


def felt(receipt: float, robot: str = "a", task: str = "patrol", **told: float) -> Heard:
    fields = {"motivation": 1.0, "threshold": 30.0, "impatience": 1.0, **dict.fromkeys(FLAGS, False), **told}
    topic = f"/{robot}/alliance/motivation/{task}"
    header = {"header/frame_id": f"/{robot}", "task_id": task}
    return Heard(topic, "alliance_msgs/Motivation", receipt, {**header, **fields}, robot, task)


def expected(receipt: float, robot: str, **seconds: float) -> Heard:
    fields = {"header/frame_id": f"/{robot}", "task_ids": list(seconds), "seconds": list(seconds.values())}
    topic = f"/{robot}/alliance/time_to_activation"
    return Heard(topic, "mrta_alliance_msgs/TimeToActivation", receipt, fields, robot)


def drawn(*messages: Heard) -> Dict[str, Figure]:
    maker = AllianceFigures(FigureSetup(MISSION))
    for message in messages:
        maker.hear(message)
    return {figure.name: figure for figure in maker.figures(RECORD)}


def shown(line: Line) -> List[Tuple[float, float]]:
    """Give the points of a line, rounded, without breaks."""
    return [(round(x, 6), y) for x, y in zip(line.x, line.y) if not math.isnan(y)]


def test_nothing_heard_is_nothing_drawn() -> None:
    assert drawn() == {}
    assert drawn(expected(11.0, "a", patrol=3.0)) == {}


def test_each_robot_has_a_figure_with_a_chart_for_each_task_that_it_told_of_in_the_missions_order() -> None:
    figures = drawn(felt(11.0, "a", "inspect"), felt(11.0, "a"), felt(11.0, "b"), felt(11.0, "new", "x"))
    assert [name for name in figures if name.startswith("motivation")] == [
        *("motivation_b", "motivation_a", "motivation_new"),
    ]
    assert [chart.title for chart in figures["motivation_a"].charts] == ["patrol", "inspect"]


def test_motivation_is_blue_and_solid_and_the_threshold_red_and_dashed_as_in_rqt_alliance() -> None:
    (chart,) = drawn(felt(11.0, motivation=1.5), felt(11.2, motivation=3.0))["motivation_a"].charts
    motivation, threshold = chart.lines
    assert (motivation.label, motivation.style, motivation.colour) == ("Motivation", LineStyle.SOLID, 0)
    assert (threshold.label, threshold.style, threshold.colour) == ("Threshold", LineStyle.DASHED, Line.REFERENCE)
    assert shown(motivation) == [(1.0, 1.5), (1.2, 3.0)]
    assert shown(threshold) == [(1.0, 30.0), (1.2, 30.0)]


def test_figures_of_one_mission_all_span_it() -> None:
    figures = drawn(felt(11.0))
    assert {line.x[-1] for figure in figures.values() for chart in figure.charts for line in chart.lines} == {10.0}


def test_the_detailed_figure_has_seven_charts_with_flags_as_steps() -> None:
    charts = drawn(felt(11.0), felt(11.2, resetted=True), felt(11.4))["detailed_a_patrol"].charts
    assert [chart.y_label for chart in charts] == ["motivation [1]", "impatience [1]", *FLAGS]
    resetted = charts[4].lines[0]
    assert resetted.style is LineStyle.STEPS
    assert shown(resetted) == [(1.0, 0.0), (1.2, 1.0), (1.4, 0.0), (1.4, 0.0)]


def test_time_to_activation_is_the_eighth_where_it_is_told_and_undefined_where_it_is_not_a_number() -> None:
    messages = [felt(11.0), *(expected(11.0 + 0.2 * n, "a", patrol=s) for n, s in enumerate([2.0, math.nan, 1.6]))]
    *_, chart = drawn(*messages)["detailed_a_patrol"].charts
    assert len(drawn(*messages)["detailed_a_patrol"].charts) == 8
    assert chart.y_label == "to activation [s]"
    assert shown(chart.lines[0]) == [(1.0, 2.0), (1.4, 1.6)]
    assert [math.isnan(value) for value in chart.lines[0].y] == [False, True, False, True]


def test_many_tasks_go_to_several_pictures() -> None:
    figures = drawn(*(felt(11.0, "a", f"t{number}") for number in range(23)))
    names = [name for name in figures if name.startswith("motivation")]
    assert names == ["motivation_a", "motivation_a_2", "motivation_a_3"]
    assert [len(figures[name].charts) for name in names] == [10, 10, 3]


def test_ids_that_could_harm_become_names_of_files_that_differ() -> None:
    names = list(drawn(felt(11.0, "../x", "a b"), felt(11.0, "../x", "a_b")))
    assert names == ["motivation___-x", "detailed___-x_a_b", "detailed___-x_a_b_2"]


@pytest.fixture(scope="module")
def recorded() -> Callable[[Path], Dict[str, Figure]]:
    def figures(bag: Path) -> Dict[str, Figure]:
        host = compose()
        mission = load_observed(host.registry, "mrta_alliance")
        maker = AllianceFigures(FigureSetup(mission))
        observation = Observation(mission, host.codec(), host.manager, None, (maker,))
        for stamped in read_bag(bag):
            observation.feed(stamped)
        return {figure.name: figure for figure in maker.figures(observation.finish())}

    return figures


def at(chart: Chart, line: int, time: float) -> float:
    """Give the value of a line at a time: that of its last point before."""
    told: Sequence[Tuple[float, float]] = shown(chart.lines[line])
    return max((point for point in told if point[0] <= time), key=lambda point: point[0])[1]


def test_figures_of_the_recording_show_what_the_reference_says(
    shared_data: Callable[[str], Path], recorded: Callable[[Path], Dict[str, Figure]]
) -> None:
    """Seconds as in the description of the recording: a reset at 4.37, rates fast again from 64.4 on."""
    figures = recorded(shared_data("alliance_two_robots.bag"))
    assert list(figures) == [
        *("motivation_robot1", "detailed_robot1_patrol", "detailed_robot1_inspect"),
        *("motivation_robot2", "detailed_robot2_patrol", "detailed_robot2_inspect"),
    ]
    patrol, inspect = figures["motivation_robot1"].charts
    assert (at(patrol, 0, 10.0), at(patrol, 1, 10.0), at(inspect, 0, 10.0)) == (30.0, 30.0, 0.0)
    assert max(time for time, _ in shown(patrol.lines[0])) == pytest.approx(73.7, abs=0.1)
    detailed = figures["detailed_robot2_patrol"].charts
    assert [round(time, 1) for time, value in shown(detailed[4].lines[0]) if value == 1.0] == [4.4]
    assert [at(detailed[1], 0, time) for time in (3.0, 20.0, 47.5, 60.0, 66.0)] == [1.0, 0.5, 1.0, 0.5, 1.0]
    assert {value for _, value in shown(detailed[2].lines[0])} == {0.0}
