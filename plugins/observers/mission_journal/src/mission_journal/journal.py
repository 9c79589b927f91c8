"""The journal of one mission after the other."""

from __future__ import annotations

import logging
from typing import Dict, Mapping, Optional, Sequence, Set

from mission_journal.line import line
from rqt_mrta_py.hooks import Heard, Subscription
from rqt_mrta_py.model import Event, Mission, MissionRecord, Severity

__all__ = ["Journal"]

_LOG = logging.getLogger("rqt_mrta_py.journal")

# Of rosgraph_msgs/Log.
_WARN = 4
_ERROR = 8

_MISSION = Subscription("/mrta/mission", "rqt_mrta_py/Mission")
_EVENT = Subscription("/mrta/event", "rqt_mrta_py/Event")
_ROSOUT = Subscription("/rosout", "rosgraph_msgs/Log", ("level", "name", "msg"))


class Journal:
    """Tells start, events and end of a mission, and what its nodes warn of.

    Everything is logged at INFO, for those who ask for it with ``-v``: that a robot is lost is a fact of the mission,
    and nothing wrong with the command that tells it. How much it matters stands as ``severity``.

    Times are seconds since the stream's start where the stream says when that was, by its first message on
    ``/mrta/mission``; else they are seconds on its clock and stand as ``stamp``. What a supervisor says on /rosout it
    has told as an event already, and so it is not told again.
    """

    def __init__(self) -> None:
        self._start: Optional[float] = None
        self._supervisors: Set[str] = set()

    def begin(self, mission: Mission) -> None:
        """Tell what the mission is about."""
        self._start = None
        self._supervisors.clear()
        facts = line(
            event="mission_started",
            application=mission.application.package,
            architecture=mission.architecture.package,
            taxonomy=str(mission.architecture.taxonomy).strip("-"),
            robots=len(mission.application.robots),
            tasks=len(mission.tasks),
            seed=mission.seed,
        )
        _LOG.info("%s", facts)

    def note(self, event: Event) -> None:
        """Tell an event."""
        if _LOG.isEnabledFor(logging.INFO):
            about = {"robot": event.robot, "task": event.task, "state": event.state, "text": event.text}
            severity = event.severity.value
            _LOG.info("%s", line(**self._when(event.time), severity=severity, event=event.kind, **about))

    def end(self, record: MissionRecord) -> None:
        """Tell how long it took, how many tasks are in which state, and what went wrong."""
        states: Dict[str, int] = {}
        for task in record.tasks:
            states[task.state.value] = states.get(task.state.value, 0) + 1
        facts = line(
            event="mission_ended",
            seconds=None if record.start is None or record.end is None else record.end - record.start,
            allocations=len(record.allocations),
            incidents=len(record.incidents),
            **{f"tasks_{state}": count for state, count in sorted(states.items())},
        )
        _LOG.info("%s", facts)

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear: when the mission began, who is a supervisor, and the nodes' log."""
        return (_MISSION, _EVENT, _ROSOUT)

    def hear(self, heard: Heard) -> None:
        """Note the start; tell what a node warns of."""
        if heard.topic == _MISSION.topic:
            if self._start is None:
                self._start = heard.receipt
        elif heard.topic == _EVENT.topic:
            if heard.caller:
                self._supervisors.add(heard.caller)
        elif heard.fields["level"] >= _WARN and heard.caller not in self._supervisors:
            severity = Severity.ERROR if heard.fields["level"] >= _ERROR else Severity.WARNING
            about = {"node": heard.fields["name"], "text": heard.fields["msg"]}
            facts = line(**self._when(heard.receipt), severity=severity.value, event="node_warned", **about)
            _LOG.info("%s", facts)

    def _when(self, time: float) -> Mapping[str, float]:
        return {"stamp": time} if self._start is None else {"t": time - self._start}
