"""What renderers draw: immutable data, the same for a run and for a review of its bag.

Architectures give curves, never pixels; renderers decide how things look.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Callable, Optional, Protocol, Sequence, Tuple

from rqt_mrta_py.hooks.stream import Heard, Subscription
from rqt_mrta_py.model import Arena, Mission, MissionRecord, Obstacle, Pose, Task

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = [
    "BodySight",
    "Curve",
    "CurveGroup",
    "CurvePanel",
    "MonitorPanel",
    "MonitorPanelFactory",
    "MonitorView",
    "PanelSetup",
    "Renderer",
    "RobotSight",
    "ScenarioLabel",
    "SceneView",
]


@dataclass(frozen=True)
class Curve:
    """One line of a panel.

    Attributes:
        label: what it shows, for instance a task's id; curves of one label share a colour over all groups.
        times: of its points, on the stream's clock, not decreasing [s].
        values: in the panel's unit; a point after NaN begins a new stroke.
    """

    label: str
    times: Tuple[float, ...]
    values: Tuple[float, ...]


@dataclass(frozen=True)
class CurveGroup:
    """Curves that share one pair of axes, for instance those of one robot."""

    label: str
    curves: Tuple[Curve, ...]


@dataclass(frozen=True)
class CurvePanel:
    """Small charts of one architecture's inner life.

    Attributes:
        title: what it shows.
        unit: of the values, as written on an axis; ``1`` for a ratio.
        top: upper end of the value axis; the lower is 0.
        reference: a value marked by a line, for instance the threshold; None for none.
        groups: in order.
    """

    title: str
    unit: str
    top: float
    reference: Optional[float]
    groups: Tuple[CurveGroup, ...]


@dataclass(frozen=True)
class PanelSetup:
    """What a panel is made from."""

    mission: Mission


class MonitorPanel(Protocol):
    """Collects what one architecture says of itself."""

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear; asked once. Names must be absolute or patterns."""
        ...

    def hear(self, heard: Heard) -> None:
        """Take in one message."""
        ...

    def view(self, start: float, end: float) -> CurvePanel:
        """Give what is to be drawn of the time from ``start`` to ``end`` [s], both included."""
        ...


MonitorPanelFactory = Callable[[PanelSetup], MonitorPanel]


@dataclass(frozen=True)
class RobotSight:
    """A robot as the scene knows it.

    Attributes:
        id: normalised.
        pose: newest one heard, in the frame ``map``; None before the first.
        radius: of the circle around the robot [m].
        trail: where it was, oldest first: (time [s], x [m], y [m]) each.
    """

    id: str
    pose: Optional[Pose]
    radius: float
    trail: Tuple[Tuple[float, float, float], ...] = ()


@dataclass(frozen=True)
class BodySight:
    """A loose body as the scene knows it.

    Attributes:
        id: its own.
        kind: what it is, as those who look for it call it.
        x: of its centre, in the frame ``map`` [m].
        y: of the same [m].
        length: along its own x, seen from above [m].
        width: along its own y [m].
        yaw: of its own x [rad].
        lift: how far its lower side is above the floor [m].
        held: True while a robot at work holds it.
    """

    id: str
    kind: str
    x: float
    y: float
    length: float
    width: float
    yaw: float = 0.0
    lift: float = 0.0
    held: bool = False


@dataclass(frozen=True)
class ScenarioLabel:
    """Something that a scenario made happen on purpose, told for people: pictures show it, rules never see it.

    Attributes:
        time: when, on the stream's clock [s].
        kind: as in scenarios, for instance ``robot_stops``.
        text: one sentence.
        robot, task: ids it speaks of; empty if none.
        over: True if it sets right what an earlier label told of.
    """

    time: float
    kind: str
    text: str
    robot: str = ""
    task: str = ""
    over: bool = False


@dataclass(frozen=True)
class SceneView:
    """What the arena looks like at one moment.

    Attributes:
        arena: floor and walls; None where nothing is known of them.
        obstacles: fixed bodies.
        robots: in the mission's order.
        tasks: the mission's tasks that are there, for their places; those that appeared later come last.
        labels: what the scenario made happen so far, oldest first.
        bodies: loose ones, sorted by id.
    """

    arena: Optional[Arena]
    obstacles: Tuple[Obstacle, ...]
    robots: Tuple[RobotSight, ...]
    tasks: Tuple[Task, ...]
    labels: Tuple[ScenarioLabel, ...] = ()
    bodies: Tuple[BodySight, ...] = ()


@dataclass(frozen=True)
class MonitorView:
    """Everything that one picture shows.

    Attributes:
        title: of the application.
        subtitle: architecture, taxonomy, seed.
        now: the moment shown, on the stream's clock [s].
        record: the mission up to now.
        scene: the arena now.
        panels: curves up to now.
        duration: planned, of the whole mission [s]; None if unknown.
    """

    title: str
    subtitle: str
    now: float
    record: MissionRecord
    scene: SceneView
    panels: Tuple[CurvePanel, ...] = ()
    duration: Optional[float] = None


Renderer = Callable[[MonitorView], "NDArray[np.uint8]"]
"""Draws one picture: (height, width, 3), blue, green, red."""
