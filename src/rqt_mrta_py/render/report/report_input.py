"""What a report is made from: plain values, the same for a run, a live mission and a review."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Mapping, NamedTuple, Optional, Tuple

from rqt_mrta_py.hooks import MonitorView
from rqt_mrta_py.model import CommunicationGraph, Explanation, Task
from rqt_mrta_py.model.timing import TimingTable
from rqt_mrta_py.render.body_keeper import BodyTrack
from rqt_mrta_py.render.pose_log import RobotTrack

__all__ = ["BagFile", "Provenance", "ReportInput"]


class BagFile(NamedTuple):
    """A bag that a report is about: name, size [bytes], number of messages."""

    name: str
    size: int
    messages: int


@dataclass(frozen=True)
class Provenance:
    """Where what a report tells comes from.

    Attributes:
        made_by: what was done, for instance ``run`` or ``review``.
        bags: that were recorded or read.
        versions: of whatever shapes a result, by name.
        parameters: by robot, nested as in its YAML file.
    """

    made_by: str
    bags: Tuple[BagFile, ...] = ()
    versions: Mapping[str, str] = field(default_factory=dict)
    parameters: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)


@dataclass(frozen=True)
class ReportInput:
    """A finished mission, with everything that its page shows.

    Attributes:
        view: the mission at its end; curves from beginning to end, as finely as they shall be shown.
        provenance: of it all.
        tracks: where robots were.
        bodies: where loose bodies were.
        tasks: every task that was known at any moment, for kinds and places.
        communication: nodes and topics; None if unknown.
        clocks: what messages tell of time; None where nobody measured.
        figures: of the whole mission that the record does not tell, among its statistics.
        explanations: of the tasks that somebody asked about.
    """

    view: MonitorView
    provenance: Provenance
    tracks: Tuple[RobotTrack, ...] = ()
    bodies: Tuple[BodyTrack, ...] = ()
    tasks: Tuple[Task, ...] = ()
    communication: Optional[CommunicationGraph] = None
    clocks: Optional[TimingTable] = None
    figures: Mapping[str, Any] = field(default_factory=dict)
    explanations: Tuple[Explanation, ...] = ()
