"""The services of whoever supervises on a ROS 1 graph: what it is asked, and what operators order through it."""

from __future__ import annotations

from pathlib import Path
from typing import Any, ContextManager, Dict, List, Mapping, Protocol, Sequence

from rqt_mrta_py.app.live import orders
from rqt_mrta_py.app.live.drawing import Drawing, PictureFormat
from rqt_mrta_py.app.live.recording import free_bag
from rqt_mrta_py.app.live.snapshots import write_snapshot
from rqt_mrta_py.errors import UsageError
from rqt_mrta_py.hooks import MonitorView, Outgoing, Stamped
from rqt_mrta_py.model import Mission, MissionRecord
from rqt_mrta_py.supervisor import team_news
from rqt_mrta_py.transport.ros1 import RosNode
from rqt_mrta_py.wording import accepted

__all__ = ["Supervised", "serve_supervisor"]

_Fields = Mapping[str, Any]

_PATIENCE = 60.0
"""How long a picture may take, the start of the process that draws it included [s]."""


class Supervised(Protocol):
    """A mission under supervision, as those know it who ask about it or give orders; all but the lock is under it."""

    @property
    def lock(self) -> ContextManager[Any]:
        """Keeps the mission as it is; whoever holds it may take it again."""
        ...

    @property
    def drawing(self) -> Drawing:
        """Draws pictures; needs no lock."""
        ...

    @property
    def mission(self) -> Mission:
        """What is supervised."""
        ...

    @property
    def now(self) -> float:
        """The present time of the stream [s]."""
        ...

    @property
    def incidents(self) -> Sequence[Mapping[str, Any]]:
        """The incidents that last, as fields of their messages, by start."""
        ...

    def record(self) -> MissionRecord:
        """Give everything known of the mission so far."""
        ...

    def view(self) -> MonitorView:
        """Give what a picture of this moment shows."""
        ...

    def last_messages(self, seconds: float) -> List[Stamped]:
        """Give what was heard in the last seconds; 0: all that is kept."""
        ...

    def say(self, outgoing: Outgoing) -> None:
        """Publish a message and take it in like one that was heard."""
        ...


def serve_supervisor(node: RosNode, supervised: Supervised, folder: Path) -> None:
    """Answer requests from now on.

    Args:
        node: that answers.
        supervised: the mission that requests are about.
        folder: where snapshots go for which no path is given.

    Raises:
        TransportError: somebody in this process serves one of them already.
    """
    answers = _Answers(supervised, folder)
    # None holds the node's lock all the time: messages are heard while a picture is drawn or a bag is written.
    for name, type_name, handler in (
        ("get_state", "GetState", answers.state),
        ("get_picture", "GetPicture", answers.picture),
        ("snapshot", "Snapshot", answers.snapshot),
        ("submit_task", "SubmitTask", answers.submit),
        ("withdraw_task", "WithdrawTask", answers.withdraw),
        ("reassign_task", "ReassignTask", answers.reassign),
    ):
        node.serve(f"~{name}", f"rqt_mrta_py/{type_name}", handler, alone=False)


class _Answers:
    """Answers requests; each takes the lock for what it looks at, and none for what takes long."""

    def __init__(self, supervised: Supervised, folder: Path) -> None:
        self._supervised = supervised
        self._folder = folder

    def state(self, _request: _Fields) -> _Fields:
        with self._supervised.lock:
            mission, now = self._supervised.mission, self._supervised.now
            return {
                "state": team_news(self._supervised.record(), now).fields,
                "application": mission.application.package,
                "architecture": mission.architecture.package,
                "incidents": self._supervised.incidents,
            }

    def picture(self, request: _Fields) -> _Fields:
        name = request["format"] or PictureFormat.JPEG.value
        formats = [each.value for each in PictureFormat]
        if name not in formats:
            raise UsageError(f"format: there are no pictures as {name!r}; {accepted(name, formats)}")
        with self._supervised.lock:
            view = self._supervised.view()
        data = self._supervised.drawing.draw(view, PictureFormat(name)).result(_PATIENCE)
        return {"header": {"stamp": view.now, "frame_id": "map"}, "format": name, "data": data}

    def snapshot(self, request: _Fields) -> _Fields:
        if not request["seconds"] >= 0:
            raise UsageError(f"seconds: must be 0 or more (got {request['seconds']}); 0 asks for all that is kept")
        with self._supervised.lock:
            messages = self._supervised.last_messages(request["seconds"])
        path = Path(request["path"]).expanduser()
        if not request["path"]:
            name = f"snapshot-{messages[-1].receipt_ns / 1e9 if messages else 0.0:.3f}"
            path = free_bag(self._folder, name)
        written = write_snapshot(path, messages)
        answer: Dict[str, Any] = {"path": str(written), "messages": len(messages)}
        if messages:
            answer.update(start=messages[0].receipt_ns / 1e9, end=messages[-1].receipt_ns / 1e9)
        return answer

    def submit(self, request: _Fields) -> _Fields:
        with self._supervised.lock:
            order = orders.submitted(request, self._supervised.mission, self._supervised.now)
            self._supervised.say(order)
        return {"task_id": order.fields["task_id"]}

    def withdraw(self, request: _Fields) -> _Fields:
        with self._supervised.lock:
            self._supervised.say(orders.withdrawn(request, self._known_tasks(), self._supervised.now))
        return {}

    def reassign(self, request: _Fields) -> _Fields:
        with self._supervised.lock:
            tasks, robots = self._known_tasks(), self._known_robots()
            self._supervised.say(orders.reassigned(request, tasks, robots, self._supervised.now))
        return {}

    def _known_tasks(self) -> Sequence[str]:
        """List the ids of all tasks that were listed or heard of."""
        mission = self._supervised.mission
        listed = mission.task_ids
        return list(dict.fromkeys((*listed, *(task.id for task in self._supervised.record().tasks))))

    def _known_robots(self) -> Sequence[str]:
        """List the ids of all robots that were listed or heard of."""
        listed = [robot.id for robot in self._supervised.mission.application.robots]
        return list(dict.fromkeys((*listed, *(robot.id for robot in self._supervised.record().robots))))
