"""What a task is, for every architecture and every application."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Mapping, Optional, Tuple

from rqt_mrta_py.model.geometry import Pose

__all__ = ["Task"]


@dataclass(frozen=True)
class Task:
    """One piece of work that robots share out among themselves.

    Attributes:
        id: unique in the mission.
        kind: names the behaviour that carries it out.
        place: where it is done, in the frame ``map``; None if it is done anywhere.
        capabilities: what a robot must be able to do.
        predecessors: ids of tasks that must be done before.
        resources: what it occupies while it is carried out.
        robots: how many robots it needs.
        expected_duration: how long one robot is expected to take [s]; None if unknown.
        perpetual: True if it never ends by itself.
        data: whatever its behaviour wants to know besides.
        layers: kinds of behaviours above the one that carries it out, from lower to higher. While a higher layer
            commands an actuator, what lower ones command it does not count (subsumption).
    """

    id: str
    kind: str
    place: Optional[Pose] = None
    capabilities: Tuple[str, ...] = ()
    predecessors: Tuple[str, ...] = ()
    resources: Tuple[str, ...] = ()
    robots: int = 1
    expected_duration: Optional[float] = None
    perpetual: bool = False
    data: Mapping[str, Any] = field(default_factory=dict)
    layers: Tuple[str, ...] = ()
