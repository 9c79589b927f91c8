"""The monitor picture: one moment of a mission on 1280 x 720 pixels."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any, Dict, List, Optional, Tuple

import numpy as np

from rqt_mrta_py.hooks import MonitorView
from rqt_mrta_py.model import Arena, Obstacle
from rqt_mrta_py.render.arena import Named, draw_arena
from rqt_mrta_py.render.canvas import Box, Canvas
from rqt_mrta_py.render.curve_axes import curve_titles, curves_boxes
from rqt_mrta_py.render.curves import curves_part, draw_fresh_curves
from rqt_mrta_py.render.events import events_part
from rqt_mrta_py.render.floor import ArenaMap, draw_floor, extent
from rqt_mrta_py.render.happenings import radio_is_split
from rqt_mrta_py.render.header import BAND, draw_clock, header_part
from rqt_mrta_py.render.layout import ARENA, HEADER, HEIGHT, SIDE, SMALL, TEAM, TIMELINE, WIDTH, inside, panel
from rqt_mrta_py.render.page import FEW, Page, Part
from rqt_mrta_py.render.palette import HAPPENING, MUTED, PAGE, WHITE
from rqt_mrta_py.render.stamps import Stamps
from rqt_mrta_py.render.tasks import tasks_height, tasks_part
from rqt_mrta_py.render.team import team_part
from rqt_mrta_py.render.timeline import draw_moment, draw_outcome_legend, timeline_part
from rqt_mrta_py.render.trails import cut_trails, draw_fresh_trails

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["MonitorRenderer", "draw_monitor"]

_LEAST_EVENTS = 120.0
_GAP = 10.0
_ARENA_TITLE = Box(ARENA.left + 80.0, ARENA.top + 4.0, ARENA.right - 4.0, ARENA.top + 27.0)

_Ground = Tuple[Arena, Tuple[Obstacle, ...], int, Tuple[str, ...]]


class MonitorRenderer:
    """Draws the arena, the team, the tasks, allocations over time, curves and the newest events.

    What looks as in the picture before is not drawn again: what never moves, and every part whose content is equal. A
    part is drawn from its content alone, so a picture is a function of its view, whatever was drawn before. Not to be
    called from two threads at once.
    """

    def __init__(self) -> None:
        self._ground_of: Optional[_Ground] = None
        self._ground: Any = None
        self._base: Any = None
        self._parts: Dict[Box, Part] = {}
        self._stamps = Stamps()
        self._pictures = _Pictures()

    def __call__(self, view: MonitorView) -> NDArray[np.uint8]:
        """Draw a picture.

        Args:
            view: the mission at one moment.

        Returns:
            A picture (720, 1280, 3), blue, green, red, that is the caller's own; equal for equal views.

        Raises:
            MissingDependencyError: OpenCV, Pillow or the font is not installed.
        """
        page = Page.of(view)
        place = ArenaMap(extent(view.scene), inside(ARENA))
        tasks, events = _side(len(view.record.tasks))
        timeline, curves = timeline_part(page), curves_part(page)
        trails, fresh_trails = cut_trails(page, place)
        self._lay_ground((place.floor, view.scene.obstacles, len(view.record.tasks), curve_titles(view.panels)), place)
        header = header_part(view)
        lists = team_part(page), tasks_part(page, tasks)
        for part in (header, _arena_title(view), trails, *lists, events_part(page, events), timeline, curves):
            self._lay(part)
        image = self._pictures.take()
        np.copyto(image, self._base)
        canvas = Canvas(image)
        draw_clock(canvas, view, header)
        draw_fresh_trails(canvas.part(place.box), page, place, fresh_trails)
        draw_arena(canvas, page, place, _named(lists), self._stamps)
        draw_moment(canvas, page, timeline)
        draw_fresh_curves(canvas, page, curves)
        return image

    def _lay_ground(self, ground: _Ground, place: ArenaMap) -> None:
        if ground != self._ground_of:
            self._ground_of = None
            self._ground = _drawn_ground(ground, place)
            self._base = self._ground.copy()
            self._parts.clear()
            self._ground_of = ground

    def _lay(self, part: Part) -> None:
        if self._parts.get(part.box) == part:
            return
        self._parts.pop(part.box, None)
        left, top, right, bottom = (round(edge) for edge in part.box)
        self._base[top:bottom, left:right] = self._ground[top:bottom, left:right]
        part.draw(Canvas(self._base), part.content)
        self._parts[part.box] = part


def draw_monitor(view: MonitorView) -> NDArray[np.uint8]:
    """Draw one monitor picture; for more than one, a MonitorRenderer is quicker.

    Args:
        view: the mission at one moment.

    Returns:
        A picture (720, 1280, 3), blue, green, red; equal for equal views.

    Raises:
        MissingDependencyError: OpenCV, Pillow or the font is not installed.
    """
    return MonitorRenderer()(view)


class _Pictures:
    """Hands out pictures that nobody else holds any more: to fetch memory anew costs more than to draw a part."""

    _MOST = 4

    def __init__(self) -> None:
        self._pictures: List[NDArray[np.uint8]] = []
        self._references = 0

    def take(self) -> NDArray[np.uint8]:
        """Give a picture with anything on it."""
        for index in range(len(self._pictures)):
            # Counted here just as it was when nobody else held it; arrays made from a picture count too.
            if sys.getrefcount(self._pictures[index]) <= self._references:
                return self._pictures[index]
        picture = np.empty((HEIGHT, WIDTH, 3), dtype=np.uint8)
        if len(self._pictures) < self._MOST:
            self._pictures.append(picture)
            del picture
            self._references = sys.getrefcount(self._pictures[-1])
            return self._pictures[-1]
        return picture


def _side(tasks: int) -> Tuple[Box, Box]:
    """Share the right side among tasks and events."""
    height = tasks_height(tasks, SIDE.height - _LEAST_EVENTS - _GAP)
    upper = Box(SIDE.left, SIDE.top, SIDE.right, round(SIDE.top + height))
    return upper, Box(SIDE.left, upper.bottom + _GAP, SIDE.right, SIDE.bottom)


def _named(parts: Tuple[Part, Part]) -> Named:
    """Say who is named in a crowded arena: those whom the lists of robots and tasks beside it show."""
    team, tasks = parts
    return Named(frozenset(row.robot for row in team.content.rows), frozenset(row.task for row in tasks.content.rows))


def _arena_title(view: MonitorView) -> Part:
    """Say beside the arena's title what holds for all of it."""
    crowd = max(len(view.scene.robots), len(view.scene.tasks)) > FEW
    words = "names: of the lists, where there is room" if crowd else ""
    return Part(_ARENA_TITLE, (words, "radio split" if radio_is_split(view.scene.labels) else ""), _draw_arena_title)


def _draw_arena_title(canvas: Canvas, words: Tuple[str, str]) -> None:
    note, warning = words
    x, y = ARENA.right - 12.0, ARENA.top + 15.0
    x -= canvas.text(x, y, note, SMALL, MUTED, WHITE, anchor=1.0) + 14.0
    canvas.text(x, y, warning, SMALL, HAPPENING, WHITE, anchor=1.0)


def _drawn_ground(ground: _Ground, place: ArenaMap) -> NDArray[np.uint8]:
    """Draw what is the same in all pictures of a mission."""
    _, obstacles, tasks, curves = ground
    canvas = Canvas(np.empty((HEIGHT, WIDTH, 3), dtype=np.uint8))
    canvas.fill(Box(0, 0, WIDTH, HEIGHT), PAGE)
    canvas.fill(HEADER, BAND)
    panels = [(ARENA, "Arena"), (TEAM, "Team"), (TIMELINE, "Allocations"), *zip(curves_boxes(len(curves)), curves)]
    panels += zip(_side(tasks), ("Tasks", "Events, newest first"))
    for box, title in panels:
        panel(canvas, box, title)
    draw_floor(canvas, place, obstacles)
    draw_outcome_legend(canvas)
    return canvas.image
