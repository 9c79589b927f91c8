"""The monitor picture: one moment of a mission on 1280 x 720 pixels."""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING, Tuple

import numpy as np

from rqt_mrta_py.hooks import MonitorView
from rqt_mrta_py.model import Arena, Obstacle
from rqt_mrta_py.render.arena import draw_arena
from rqt_mrta_py.render.canvas import Box, Canvas
from rqt_mrta_py.render.curves import curve_titles, curves_boxes, draw_curves
from rqt_mrta_py.render.events import draw_events
from rqt_mrta_py.render.floor import ArenaMap, draw_floor, extent
from rqt_mrta_py.render.header import BAND, draw_header
from rqt_mrta_py.render.layout import ARENA, HEADER, HEIGHT, SIDE, TEAM, TIMELINE, WIDTH, inside, panel
from rqt_mrta_py.render.page import Page
from rqt_mrta_py.render.palette import PAGE
from rqt_mrta_py.render.tasks import draw_tasks, tasks_height
from rqt_mrta_py.render.team import draw_team
from rqt_mrta_py.render.timeline import draw_outcome_legend, draw_timeline

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["draw_monitor"]

_LEAST_EVENTS = 120.0
_GAP = 10.0


def draw_monitor(view: MonitorView) -> NDArray[np.uint8]:
    """Draw the arena, the team, the tasks, allocations over time, curves and the newest events.

    Args:
        view: the mission at one moment.

    Returns:
        A picture (720, 1280, 3), blue, green, red; equal for equal views.

    Raises:
        MissingDependencyError: OpenCV, Pillow or the font is not installed.
    """
    floor = extent(view.scene)
    ground = _ground(floor, view.scene.obstacles, len(view.record.tasks), curve_titles(view.panels))
    page = Page.of(Canvas(ground.copy()), view)
    tasks, events = _side(len(view.record.tasks))
    draw_header(page)
    draw_arena(page, ArenaMap(floor, inside(ARENA)))
    draw_team(page)
    draw_tasks(page, tasks)
    draw_events(page, events)
    draw_timeline(page)
    draw_curves(page)
    return page.canvas.image


def _side(tasks: int) -> Tuple[Box, Box]:
    """Share the right side among tasks and events."""
    height = tasks_height(tasks, SIDE.height - _LEAST_EVENTS - _GAP)
    upper = Box(SIDE.left, SIDE.top, SIDE.right, round(SIDE.top + height))
    return upper, Box(SIDE.left, upper.bottom + _GAP, SIDE.right, SIDE.bottom)


@lru_cache(maxsize=2)
def _ground(floor: Arena, obstacles: Tuple[Obstacle, ...], tasks: int, curves: Tuple[str, ...]) -> NDArray[np.uint8]:
    """Draw once what is the same in all pictures of a mission; a function of its arguments alone."""
    canvas = Canvas(np.empty((HEIGHT, WIDTH, 3), dtype=np.uint8))
    canvas.fill(Box(0, 0, WIDTH, HEIGHT), PAGE)
    canvas.fill(HEADER, BAND)
    panels = [(ARENA, "Arena"), (TEAM, "Team"), (TIMELINE, "Allocations"), *zip(curves_boxes(len(curves)), curves)]
    panels += zip(_side(tasks), ("Tasks", "Events, newest first"))
    for box, title in panels:
        panel(canvas, box, title)
    draw_floor(canvas, ArenaMap(floor, inside(ARENA)), obstacles)
    draw_outcome_legend(canvas)
    canvas.image.setflags(write=False)
    return canvas.image
