"""A plan group by group, as seen from above: what is placed, in which order, and the ways."""

from __future__ import annotations

from typing import List, Tuple

from block_construction.execution.arena import Point
from block_construction.execution.plan import BuildPlan, problem_of
from block_construction.execution.problem import START, BuildProblem
from block_construction.pictures.colours import block_key
from block_construction.pictures.levels import block_area, rectangle
from rqt_mrta_py.hooks import Area, Drawing, DrawingPanel, Shape, Stroke, Tint, Words

__all__ = ["plan_drawing"]

_MOST_PANELS = 24
_MOST_COLUMNS = 4
_FETCHING, _PLACING = Tint(8, 0.25), Tint(5, 0.2)
_STAND = 0.02
_PLACE_ROOM = 0.38
"""For a place's number and what it holds: places in the corners are 0.2 m from the walls."""


def plan_drawing(plan: BuildPlan) -> Drawing:
    """Draw each group of a plan: what stands already, its blocks with their numbers in the order, the ways.

    Args:
        plan: that can be carried out.
    """
    problem = problem_of(plan)
    panels: List[DrawingPanel] = []
    first = 0
    for group in problem.groups[:_MOST_PANELS]:
        panels.append(_group(plan, problem, first, first + len(group)))
        first += len(group)
    cost = plan.cost
    left_out = len(problem.groups) - len(panels)
    more = f"; {left_out} more groups are not shown" if left_out else ""
    title = (
        f"{plan.diagram.structure.name}: {cost.total:.2f} m by {plan.method}, fetching {cost.fetching:.2f} m, "
        f"placing {cost.placing:.2f} m{more}"
    )
    key = block_key([units for units, count in plan.diagram.counts.items() if count], 0.35)
    ways = ((_FETCHING, "way to a supply place"), (_PLACING, "way from there"))
    return Drawing("plan", title, tuple(panels), min(_MOST_COLUMNS, len(panels)), (*key, *ways))


def _group(plan: BuildPlan, problem: BuildProblem, first: int, end: int) -> DrawingPanel:
    """Draw the steps from ``first`` on up to ``end``."""
    shapes = _ground(problem)
    ways: List[Shape] = []
    words: List[Shape] = []
    covered, last = 0, START
    for number, step in enumerate(plan.steps[:end], 1):
        block = problem.block(step.block)
        x, y = problem.site.left + block.x, problem.site.bottom + block.y
        drawn = number > first
        shapes.append(block_area(block, x, y, 0.35 if drawn else 0.85))
        if drawn:
            there = problem.ways.path(covered, step.place - 1, last)[::-1]
            ways.append(Stroke(there, _FETCHING, 2))
            ways.append(Stroke(problem.ways.path(covered, step.place - 1, step.block), _PLACING, 2))
            words.append(Words(x, y, str(number)))
        covered |= problem.covers[step.block - 1]
        last = step.block
    level = problem.block(plan.steps[first].block)
    steps = f"step {end}" if end == first + 1 else f"steps {first + 1} to {end}"
    title = f"layer {level.layer}, level {level.placement.z}: {steps}"
    return DrawingPanel(title, (*shapes, *ways, *_places(problem), *words))


def _ground(problem: BuildProblem) -> List[Shape]:
    side, site = problem.arena.side, problem.site
    walls = Area(rectangle(0.0, 0.0, side, side), Tint(Drawing.MUTED, 0.96), Tint(Drawing.INK, 0.2))
    return [walls, Area(rectangle(*site), Tint(Drawing.MUTED, 0.88), Tint(Drawing.MUTED, 0.6))]


def _places(problem: BuildProblem) -> List[Shape]:
    shapes: List[Shape] = []
    for place in problem.places:
        box = rectangle(place.x - 0.1, place.y - 0.1, place.x + 0.1, place.y + 0.1)
        shapes.append(Area(box, Tint(Drawing.MUTED, 0.75), Tint(Drawing.MUTED)))
        held = ",".join(map(str, sorted(place.stock)))
        shapes.append(Words(place.x, place.y, f"{place.number}: {held}", room=_PLACE_ROOM))
    start = Point(*problem.arena.start)
    return [*shapes, Area(_around(start), Tint(Drawing.INK)), Words(start.x, start.y - 0.07, "start", room=0.3)]


def _around(point: Point) -> Tuple[Tuple[float, float], ...]:
    return rectangle(point.x - _STAND, point.y - _STAND, point.x + _STAND, point.y + _STAND)
