"""Grounds that every architecture shares: what operators, scenarios and behaviours say of tasks."""

from __future__ import annotations

from typing import Dict, Mapping, Sequence

from rqt_mrta_py.hooks import Heard, Subscription
from rqt_mrta_py.model import Ground, Progress, normalise_id
from rqt_mrta_py.supervisor.values import text_of

__all__ = ["OrderGrounds"]

_WISH = Subscription("/mrta/task_progress", "rqt_mrta_py/TaskProgress", ("task_id", "robot_id", "progress", "detail"))
_TEXTS: Mapping[Progress, str] = {
    Progress.DONE: "says that it has done it",
    Progress.FAILED: "says that it has failed at it",
    Progress.UNREACHABLE: "says that it cannot get to it",
    Progress.APPEARED: "has appeared",
    Progress.WITHDRAWN: "was withdrawn",
    Progress.REASSIGNED: "shall have it, by an order",
}
_ANYBODY = "shall be shared out anew, by an order"


class OrderGrounds:
    """Reads ``rqt_mrta_py/TaskProgress``; that somebody is still at work is no ground."""

    def __init__(self) -> None:
        """Start with nothing heard."""
        self._newest: Dict[str, Ground] = {}

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear."""
        return (_WISH,)

    def hear(self, heard: Heard) -> Sequence[Ground]:
        """Answer what one message says, unless it repeats the last one of its task."""
        progress = Progress.of_code(heard.fields["progress"])
        if progress is None or progress not in _TEXTS:
            return ()
        task, robot = (normalise_id(text_of(heard.fields, name)) for name in ("task_id", "robot_id"))
        text = _ANYBODY if progress is Progress.REASSIGNED and not robot else _TEXTS[progress]
        detail = text_of(heard.fields, "detail")
        ground = Ground(heard.receipt, task, f"{text}: {detail}" if detail else text, robot)
        before = self._newest.get(task)
        self._newest[task] = ground
        if before is not None and (before.robot, before.text) == (robot, ground.text):
            return ()
        return (ground,)
