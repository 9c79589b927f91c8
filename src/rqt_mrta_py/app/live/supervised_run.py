"""A run of nodes under supervision, as those know it who ask about it, and give orders, while it goes on."""

from __future__ import annotations

import threading
import time
from contextlib import contextmanager
from typing import Any, Iterator, List, Mapping, Sequence, Set

from rqt_mrta_py.app.live.drawing import Drawing
from rqt_mrta_py.app.live.health import Counts
from rqt_mrta_py.app.live.health_report import HealthReport
from rqt_mrta_py.app.live.open_incidents import OpenIncidents
from rqt_mrta_py.app.live.options import LiveOptions
from rqt_mrta_py.app.live.ring_buffer import RingBuffer
from rqt_mrta_py.app.live.supervisor_services import serve_supervisor
from rqt_mrta_py.app.live.tally import with_messages_kept
from rqt_mrta_py.app.live.voice import Voice
from rqt_mrta_py.app.outputs.results import Results
from rqt_mrta_py.app.run.watch import BAG, Watch, WatchPlan
from rqt_mrta_py.errors import UsageError
from rqt_mrta_py.hooks import MonitorView, Outgoing, Stamped
from rqt_mrta_py.model import Mission, MissionRecord
from rqt_mrta_py.supervisor.own_topics import INCIDENT
from rqt_mrta_py.transport import Batch
from rqt_mrta_py.transport.ros1 import RosNode

__all__ = ["SupervisedRun"]

_NS = 1_000_000_000
_HEALTH_PERIOD = 1.0
"""How often health is told, on the wall [s]."""


class SupervisedRun:
    """Stands between the stream of a run and those who watch it, so that orders find their place in it.

    Attributes:
        lock: of everything that the stream changes; whoever holds it may take the node's, never the other way round.
        drawing: draws the pictures that are asked for.

    Args:
        node: that hears and speaks.
        plan: what is watched.
        watch: hears the stream; what it says has been passed on to ``note``.
    """

    def __init__(self, node: RosNode, plan: WatchPlan, watch: Watch) -> None:
        self.lock = threading.RLock()
        self.drawing = Drawing()
        self._node = node
        self._plan = plan
        self._watch = watch
        self._ring = RingBuffer(LiveOptions.snapshot_seconds, LiveOptions.snapshot_bytes)
        self._incidents = OpenIncidents(aloud=False)
        self._health = HealthReport(node, 0)
        self._health_due = time.monotonic()
        self._heard = self._newest_ns = 0
        self._topics: Set[str] = set()
        self._over = False

    @contextmanager
    def serving(self) -> Iterator[None]:
        """Answer requests, and tell how the supervision is."""
        Voice(self._node).open()
        self._health.open()
        serve_supervisor(self._node, self, self._plan.folder.path)
        try:
            yield
        finally:
            self.drawing.close()

    def finish(self) -> Results:
        """End the stream and write what is derived from it; to be called once."""
        with self.lock:
            self._over = True
            return self._watch.finish()

    @property
    def mission(self) -> Mission:
        """What is run."""
        return self._plan.observation.mission

    @property
    def now(self) -> float:
        """The time of the newest message [s].

        Raises:
            UsageError: none has come yet.
        """
        if not self._newest_ns:
            raise UsageError("the mission has not begun; ask again when its nodes are there")
        return self._newest_ns / _NS

    @property
    def incidents(self) -> Sequence[Mapping[str, Any]]:
        """The incidents that last, as fields of their messages, by start."""
        return self._incidents.listed()

    def record(self) -> MissionRecord:
        """Give everything known of the mission so far."""
        return self._plan.observation.supervisor.record(self.now)

    def view(self) -> MonitorView:
        """Give what a picture of this moment shows."""
        return self._plan.observation.view(self.now)

    def last_messages(self, seconds: float) -> List[Stamped]:
        """Give what was said in the last seconds; 0: all that is kept."""
        return self._ring.last(seconds or None)

    def say(self, outgoing: Outgoing) -> None:
        """Give an order: it is said now, and stands in the stream after what was heard before.

        Raises:
            UsageError: the mission is over.
        """
        if self._over:
            raise UsageError("the mission is over")
        self._watch.say(outgoing, self.now)

    def hear(self, batch: Batch) -> None:
        """Take in messages of the team; with the lock held."""
        self.note(batch)
        self._watch.hear(batch)

    def note(self, batch: Batch) -> None:
        """Keep messages that the watch has heard, or is about to; with the lock held."""
        messages = list(batch)
        self._ring.extend(messages)
        self._heard += len(messages)
        for connection, receipt_ns, raw in messages:
            self._newest_ns = receipt_ns
            self._topics.add(connection.topic)
            if connection.topic == INCIDENT.name:
                self._incidents.note(self._node.codec.decode(connection, raw))

    def end_tick(self, tick: int) -> None:
        """Take note that everything of a tick has been heard; with the lock held."""
        self._watch.end_tick(tick)

    def tell_health(self) -> None:
        """Tell how the supervision is, once a second."""
        wall = time.monotonic()
        if wall < self._health_due:
            return
        self._health_due = wall + _HEALTH_PERIOD
        with self.lock:
            counts = Counts(
                heard=self._heard,
                topics=len(self._topics),
                unreadable=self._plan.observation.supervisor.unreadable,
                mission=self.mission.application.package,
                recorded=self._heard,
                recording=str(self._plan.folder.path / BAG),
            )
            self._health.tell(with_messages_kept(counts, None, self._ring), wall, self._newest_ns / _NS)
