from __future__ import annotations

import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from typing import Tuple

import matplotlib as mpl
import numpy as np
import pytest

from rqt_mrta_py.hooks import CurveGroup, CurvePanel, MonitorView
from rqt_mrta_py.model import Outcome, Pose, RobotState
from rqt_mrta_py.render import draw_dashboard
from rqt_mrta_py.render.palette import MUTED, STATE_COLOURS, Colour, TaskColours
from rqt_mrta_py.render.spells import spells
from tests.render import views

LEFT, RIGHT = 800.0, 1572.0


def has(picture: np.ndarray, place: Tuple[float, float], colour: Colour) -> bool:
    pixel = picture[round(place[1]), round(place[0])].astype(int)
    return bool(np.abs(pixel - np.array(colour[::-1])).max() <= 8)


def whole() -> MonitorView:
    return views.patrol(181.0, whole=True)


@pytest.fixture(scope="module")
def drawn() -> np.ndarray:
    return draw_dashboard(whole())


@pytest.mark.parametrize(
    "view",
    [
        views.crowd(60.0, robots=30, tasks=25, groups=30),
        views.single(),
        views.empty(),
        replace(views.single(), panels=(CurvePanel("Flat", "m", 0.0, 0.0, (CurveGroup("", ()),)),), duration=0.0),
        replace(views.single(), panels=(), now=40000.0),
    ],
    ids=["huge crowd", "single", "empty", "flat curves", "hours without curves"],
)
def test_dashboard_draws_1600_by_1000_whatever_there_is_to_show(view: MonitorView) -> None:
    picture = draw_dashboard(view)
    assert picture.shape == (1000, 1600, 3)
    assert picture.dtype == np.uint8
    assert picture.flags.c_contiguous


def test_dashboard_draws_equal_pictures_of_equal_views_under_any_settings(drawn: np.ndarray) -> None:
    with mpl.rc_context({"axes.facecolor": "red", "font.size": 30, "lines.linewidth": 9.0}):
        settings = dict(mpl.rcParams)
        assert np.array_equal(draw_dashboard(whole()), drawn)
        assert dict(mpl.rcParams) == settings


def test_dashboard_gives_bars_the_tasks_colours_and_robots_their_states(drawn: np.ndarray) -> None:
    view = whole()
    colours = TaskColours.of(view)

    def at(time: float, row: int, down: float) -> Tuple[float, float]:
        # Rows of 40 pixels below title and incidents.
        return LEFT + (time - 1.0) / 180.0 * (RIGHT - LEFT), 120.0 + 40.0 * row + down

    assert has(drawn, at(40.0, 0, 6.0), colours["wander"])
    assert has(drawn, at(150.0, 0, 6.0), colours["border_protection"])
    assert has(drawn, at(3.0, 0, 36.0), STATE_COLOURS[RobotState.IDLE])
    assert has(drawn, at(40.0, 0, 36.0), STATE_COLOURS[RobotState.BUSY])
    assert has(drawn, at(150.0, 2, 36.0), STATE_COLOURS[RobotState.OFFLINE])


def test_dashboard_writes_short_names_into_bars_too() -> None:
    """Names of up to four letters were once left out."""

    def bar(task: str) -> np.ndarray:
        record = views.record_of(["rover"], [task], [("rover", task, 4.0, 21.0, Outcome.OPEN)], {}, 21.0)
        picture = draw_dashboard(replace(views.single(), record=record, panels=()))
        return picture[122:148, 850:1572]

    assert not np.array_equal(bar("gate"), bar("shed"))


def test_dashboard_says_so_where_no_place_is_known() -> None:
    around = (slice(270, 306), slice(270, 420))
    told, silent = (draw_dashboard(view)[around] for view in (views.empty(), whole()))
    muted = np.array(MUTED[::-1])
    assert (np.abs(told.astype(int) - muted).max(axis=2) <= 8).sum() > 100
    assert (np.abs(silent.astype(int) - muted).max(axis=2) <= 8).sum() < 100


def test_dashboard_reads_names_literally() -> None:
    """Dollar signs would begin mathematics, and fail where it does not parse; glyphs may be missing."""
    view = views.single()
    task = view.record.tasks[0]._replace(id="$\\frac{$\n漢字")
    robot = replace(view.scene.robots[0], id="a$b$c", pose=Pose(0.0, 0.0))
    record = replace(view.record, tasks=(task,))
    view = replace(view, title="$\\oops{$", record=record, scene=replace(view.scene, robots=(robot,)))
    assert draw_dashboard(view).shape == (1000, 1600, 3)


def test_dashboard_needs_no_pyplot(root: Path) -> None:
    code = (
        f"import sys; sys.path[:0] = [{str(root)!r}, {str(root / 'src')!r}];"
        "import rqt_mrta_py.render as r; assert not {'cv2', 'matplotlib', 'PIL'} & set(sys.modules);"
        "from tests.render import views; r.draw_dashboard(views.empty()); assert 'matplotlib.pyplot' not in sys.modules"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


def test_spells_cut_time_at_the_beginning_and_end_of_allocations() -> None:
    robot1 = [a for a in views.patrol(181.0).record.allocations if a.robot == "robot1"]
    assert spells(robot1, 1.0, 181.0) == [
        (1.0, 6.0, None),
        (6.0, 66.4, "wander"),
        (66.4, 181.0, "border_protection"),
    ]
    assert spells([], 5.0, 9.0) == [(5.0, 9.0, None)]
    assert spells(robot1, 5.0, 5.0) == []
