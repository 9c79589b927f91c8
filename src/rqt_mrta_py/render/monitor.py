"""The monitor picture: one moment of a mission on 1280 x 720 pixels."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple, Optional, Tuple

import numpy as np

from rqt_mrta_py.hooks import MonitorView
from rqt_mrta_py.model import Arena, Obstacle
from rqt_mrta_py.render.arena import Named, arena_part
from rqt_mrta_py.render.canvas import Box, Canvas
from rqt_mrta_py.render.curve_axes import curve_titles, curves_boxes
from rqt_mrta_py.render.curves import curves_part, fresh_curves_parts
from rqt_mrta_py.render.events import events_part
from rqt_mrta_py.render.floor import ArenaMap, draw_floor, extent
from rqt_mrta_py.render.happenings import radio_is_split
from rqt_mrta_py.render.header import BAND, clock_parts, header_part
from rqt_mrta_py.render.layers import Layer, Printer
from rqt_mrta_py.render.layout import ARENA, HEADER, HEIGHT, SIDE, SMALL, TEAM, TIMELINE, WIDTH, inside, panel
from rqt_mrta_py.render.page import FEW, Page, Part
from rqt_mrta_py.render.palette import HAPPENING, MUTED, PAGE, WHITE
from rqt_mrta_py.render.tasks import tasks_height, tasks_part
from rqt_mrta_py.render.team import team_part
from rqt_mrta_py.render.timeline import draw_outcome_legend, moment_parts, timeline_part
from rqt_mrta_py.render.trails import cut_trails

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["MonitorRenderer", "draw_monitor"]

_LEAST_EVENTS = 120.0
_GAP = 10.0
_ARENA_TITLE = Box(ARENA.left + 80.0, ARENA.top + 4.0, ARENA.right - 4.0, ARENA.top + 27.0)

_Ground = Tuple[Arena, Tuple[Obstacle, ...], int, Tuple[str, ...]]


class MonitorRenderer:
    """Draws the arena, the team, the tasks, allocations over time, curves and the newest events.

    What looks as in the picture before is not drawn again, nor copied: what never moves, and every part whose content
    is equal. A part is drawn from its content alone, so a picture is a function of its view, whatever was drawn before.
    Not to be called from two threads at once.
    """

    def __init__(self) -> None:
        self._ground_of: Optional[_Ground] = None
        self._layers: Optional[_Layers] = None

    def __call__(self, view: MonitorView) -> NDArray[np.uint8]:
        """Draw a picture.

        Args:
            view: the mission at one moment.

        Returns:
            A picture (720, 1280, 3), blue, green, red; equal for equal views. It is not to be written on, and stays as
            it is while anybody holds it.

        Raises:
            MissingDependencyError: OpenCV, Pillow or the font is not installed.
        """
        page = Page.of(view)
        place = ArenaMap(extent(view.scene), inside(ARENA))
        layers = self._layers_on(
            (place.floor, view.scene.obstacles, len(view.record.tasks), curve_titles(view.panels)), place
        )
        tasks, events = _side(len(view.record.tasks))
        trails, fresh_trails = cut_trails(page, place)
        header, timeline, curves = header_part(view), timeline_part(page), curves_part(page)
        lists = team_part(page), tasks_part(page, tasks)
        layers.settled.show(
            [header, _arena_title(view), trails, *lists, events_part(page, events), timeline, curves],
        )
        layers.moving.show(
            [
                *clock_parts(view, header),
                arena_part(page, place, _named(lists), fresh_trails),
                *moment_parts(page, timeline),
                *fresh_curves_parts(page, curves),
            ]
        )
        return layers.printer.print()

    def _layers_on(self, ground: _Ground, place: ArenaMap) -> _Layers:
        if self._layers is None or ground != self._ground_of:
            self._layers = _Layers.on(_drawn_ground(ground, place))
            self._ground_of = ground
        return self._layers


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


class _Layers(NamedTuple):
    """A picture on one ground: what looks the same until the next whole second, what moves, and prints of both."""

    settled: Layer
    moving: Layer
    printer: Printer

    @classmethod
    def on(cls, ground: NDArray[np.uint8]) -> _Layers:
        settled = Layer(ground).on_top()
        moving = settled.on_top()
        return cls(settled, moving, Printer(moving))


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
