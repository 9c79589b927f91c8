"""A node of no graph, for a supervisor that is told message by message and moment by moment what happens."""

from __future__ import annotations

import threading
from typing import Any, Callable, List, Tuple

from rqt_mrta_py.hooks import Codec, Outgoing, Stamped

__all__ = ["StillNode"]


class StillNode:
    """Stands in for a RosNode; its clock shows what a test says.

    Attributes:
        said: what was published, in order: topic, fields or bytes.
        time: what the clock shows [s].
    """

    name = "/supervisor"

    def __init__(self, codec: Codec) -> None:
        self.codec = codec
        self.lock = threading.RLock()
        self.time = 0.0
        self.said: List[Tuple[str, Any]] = []
        self.wanted: Callable[[str, str], bool] = lambda _topic, _type: False
        self.tell: Callable[[Stamped], None] = lambda _stamped: None
        self.awaited: List[str] = []
        self.reason = ""

    def now(self) -> float:
        return self.time

    def hear(self, wanted: Callable[[str, str], bool], callback: Callable[[Stamped], None]) -> None:
        self.wanted, self.tell = wanted, callback

    def hear_topic(self, topic: str, _callback: Callable[[Stamped], None]) -> None:
        self.awaited.append(topic)

    def pass_on(self, stamped: Stamped) -> None:
        self.said.append((stamped.connection.topic, stamped.raw))

    def publish(self, outgoing: Outgoing, _now: float) -> None:
        self.said.append((outgoing.topic, outgoing.fields))

    def is_heard(self, *_topic: object) -> bool:
        return False

    def shut_down(self, reason: str) -> None:
        self.reason = reason
