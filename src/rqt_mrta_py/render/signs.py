"""Signs that say by shape what colours say too: lights of robots, states of tasks, ends of allocations."""

from __future__ import annotations

from typing import Mapping

from rqt_mrta_py.model import Outcome, RobotState, Severity, TaskState
from rqt_mrta_py.render.canvas import Canvas, Point
from rqt_mrta_py.render.happenings import Condition
from rqt_mrta_py.render.palette import HAPPENING, INK, SEVERITY_COLOURS, STATE_COLOURS, WHITE, Colour, mix

__all__ = ["BADGE_RADIUS", "OUTCOME_SIGNS", "TASK_SIGNS", "badge", "diamond", "light", "warning"]

OUTCOME_SIGNS: Mapping[Outcome, str] = {
    Outcome.DONE: "✓",
    Outcome.FAILED: "✗",
    Outcome.YIELDED: "»",
    Outcome.GAVE_UP: "↺",
    Outcome.LOST: "!",
    Outcome.PREEMPTED: "⇥",
    Outcome.OPEN: "",
}

TASK_SIGNS: Mapping[TaskState, str] = {
    TaskState.WAITING: "…",
    TaskState.ALLOCATED: "→",
    TaskState.EXECUTING: "▶",
    TaskState.DONE: "✓",
    TaskState.FAILED: "✗",
    TaskState.WITHDRAWN: "–",
}

BADGE_RADIUS = 7.5
"""Of the sign of a condition [pixels]."""


def light(canvas: Canvas, centre: Point, radius: float, state: RobotState) -> None:
    """Draw a robot's light: idle a green ring, busy a yellow disc, offline a crossed grey disc.

    Args:
        canvas: drawn upon.
        centre: of the light.
        radius: of the light [pixels].
        state: what it says.
    """
    colour = STATE_COLOURS[state]
    canvas.disc(centre, radius + 1.2, mix(colour, INK, 0.72))
    canvas.disc(centre, radius, colour)
    x, y = centre
    if state is RobotState.IDLE:
        canvas.disc(centre, radius * 0.42, WHITE)
    elif state is RobotState.OFFLINE:
        arm = radius * 0.45
        canvas.strokes([[(x - arm, y - arm), (x + arm, y + arm)], [(x - arm, y + arm), (x + arm, y - arm)]], WHITE, 2)


def diamond(canvas: Canvas, centre: Point, radius: float, colour: Colour, outline: Colour = WHITE) -> None:
    """Draw the sign of a task in its colour.

    Args:
        canvas: drawn upon.
        centre: of the sign.
        radius: from the centre to a corner [pixels].
        colour: the task's.
        outline: colour of the border around it.
    """
    x, y = centre
    for size, shade in ((radius + 2.0, outline), (radius, colour)):
        canvas.polygon([(x, y - size), (x + size, y), (x, y + size), (x - size, y)], shade)


def warning(canvas: Canvas, centre: Point, radius: float, severity: Severity) -> None:
    """Draw the sign of an incident: a triangle in the colour of its severity.

    Args:
        canvas: drawn upon.
        centre: of the sign.
        radius: half of its height [pixels].
        severity: of the incident.
    """
    x, y = centre
    colour = SEVERITY_COLOURS[severity]
    canvas.polygon([(x, y - radius), (x + 1.1 * radius, y + radius), (x - 1.1 * radius, y + radius)], colour)
    if radius >= 5.0:
        canvas.line([(x, y - 0.25 * radius), (x, y + 0.3 * radius)], WHITE, 1)
        canvas.disc((x, y + 0.68 * radius), 0.7, WHITE)


def badge(canvas: Canvas, centre: Point, condition: Condition) -> None:
    """Draw the sign of what a scenario did to a robot: white on a disc in the colour of scenarios' marks.

    Stopped is a square, stuck two bars, slow an arrow down, off the air a cross, a clock that is off two hands.

    Args:
        canvas: drawn upon.
        centre: of the sign.
        condition: what is the matter.
    """
    x, y = centre
    canvas.disc(centre, BADGE_RADIUS, WHITE)
    canvas.disc(centre, BADGE_RADIUS - 1.3, HAPPENING)
    if condition is Condition.STOPPED:
        canvas.polygon([(x - 2.6, y - 2.6), (x + 2.6, y - 2.6), (x + 2.6, y + 2.6), (x - 2.6, y + 2.6)], WHITE)
    elif condition is Condition.STUCK:
        canvas.strokes([[(x - 2.0, y - 2.6), (x - 2.0, y + 2.6)], [(x + 2.0, y - 2.6), (x + 2.0, y + 2.6)]], WHITE, 2)
    elif condition is Condition.SLOW:
        canvas.polygon([(x - 3.4, y - 2.0), (x + 3.4, y - 2.0), (x, y + 3.4)], WHITE)
    elif condition is Condition.OFF_THE_AIR:
        canvas.strokes([[(x - 2.4, y - 2.4), (x + 2.4, y + 2.4)], [(x - 2.4, y + 2.4), (x + 2.4, y - 2.4)]], WHITE, 2)
    else:
        canvas.strokes([[(x, y - 4.0), (x, y), (x + 3.0, y + 1.5)]], WHITE, 1)
