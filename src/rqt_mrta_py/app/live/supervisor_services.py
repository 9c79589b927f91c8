"""The services of a supervisor node: what it is asked, and what operators order through it."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Dict, Mapping

from rqt_mrta_py.app.live import orders
from rqt_mrta_py.app.live.drawing import PictureFormat
from rqt_mrta_py.app.live.live_supervisor import LiveSupervisor
from rqt_mrta_py.app.live.options import LiveOptions
from rqt_mrta_py.app.live.recording import free_bag
from rqt_mrta_py.app.live.snapshots import write_snapshot
from rqt_mrta_py.errors import UsageError
from rqt_mrta_py.hooks import Outgoing
from rqt_mrta_py.supervisor import team_news
from rqt_mrta_py.wording import accepted

__all__ = ["serve_supervisor"]

_Fields = Mapping[str, Any]

_PATIENCE = 60.0
"""How long a picture may take, the start of the process that draws it included [s]."""


def serve_supervisor(supervisor: LiveSupervisor, options: LiveOptions) -> None:
    """Answer requests from now on.

    Args:
        supervisor: whom they are about.
        options: where snapshots go for which no path is given.

    Raises:
        TransportError: somebody in this process serves one of them already.
    """
    answers = _Answers(supervisor, options)
    node = supervisor.node
    node.serve("~get_state", "rqt_mrta_py/GetState", answers.state)
    node.serve("~submit_task", "rqt_mrta_py/SubmitTask", answers.submit)
    node.serve("~withdraw_task", "rqt_mrta_py/WithdrawTask", answers.withdraw)
    node.serve("~reassign_task", "rqt_mrta_py/ReassignTask", answers.reassign)
    # These take long; messages are heard meanwhile.
    node.serve("~get_picture", "rqt_mrta_py/GetPicture", answers.picture, alone=False)
    node.serve("~snapshot", "rqt_mrta_py/Snapshot", answers.snapshot, alone=False)


class _Answers:
    def __init__(self, supervisor: LiveSupervisor, options: LiveOptions) -> None:
        self._supervisor = supervisor
        self._options = options

    def state(self, _request: _Fields) -> _Fields:
        mission, now = self._supervisor.mission, self._supervisor.now
        return {
            "state": team_news(self._supervisor.record(), now).fields,
            "application": mission.application.package,
            "architecture": mission.architecture.package,
            "incidents": self._supervisor.incidents,
        }

    def picture(self, request: _Fields) -> _Fields:
        name = request["format"] or PictureFormat.JPEG.value
        formats = [each.value for each in PictureFormat]
        if name not in formats:
            raise UsageError(f"format: there are no pictures as {name!r}; {accepted(name, formats)}")
        with self._supervisor.node.lock:
            view = self._supervisor.view()
        data = self._supervisor.drawing.draw(view, PictureFormat(name)).result(_PATIENCE)
        return {"header": {"stamp": view.now, "frame_id": "map"}, "format": name, "data": data}

    def snapshot(self, request: _Fields) -> _Fields:
        if not request["seconds"] >= 0:
            raise UsageError(f"seconds: must be 0 or more (got {request['seconds']}); 0 asks for all that is kept")
        with self._supervisor.node.lock:
            messages = self._supervisor.last_messages(request["seconds"])
        path = Path(request["path"]).expanduser()
        if not request["path"]:
            name = f"snapshot-{messages[-1].receipt_ns / 1e9 if messages else 0.0:.3f}"
            path = free_bag(self._options.snapshots or Path.cwd(), name)
        written = write_snapshot(path, messages)
        answer: Dict[str, Any] = {"path": str(written), "messages": len(messages)}
        if messages:
            answer.update(start=messages[0].receipt_ns / 1e9, end=messages[-1].receipt_ns / 1e9)
        return answer

    def submit(self, request: _Fields) -> _Fields:
        order = orders.submitted(request, self._supervisor.mission, self._supervisor.now)
        self._order(order)
        return {"task_id": order.fields["task_id"]}

    def withdraw(self, request: _Fields) -> _Fields:
        self._order(orders.withdrawn(request, self._supervisor.known_tasks, self._supervisor.now))
        return {}

    def reassign(self, request: _Fields) -> _Fields:
        tasks, robots = self._supervisor.known_tasks, self._supervisor.known_robots
        self._order(orders.reassigned(request, tasks, robots, self._supervisor.now))
        return {}

    def _order(self, order: Outgoing) -> None:
        self._supervisor.say(order)
