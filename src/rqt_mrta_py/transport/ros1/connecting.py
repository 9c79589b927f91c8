"""Connecting to publishers, one attempt at a time.

The master tells a subscriber of all publishers of a topic whenever there is a new one, and rospy connects to each to
which there is no connection yet, in a thread each. While one is being made, the next list begins another, which then
takes the place of the first: what came through that is lost, without a word.
"""

from __future__ import annotations

import threading
from typing import Any, Set, Tuple

__all__ = ["connect_once"]


def connect_once(handler: Any) -> None:
    """Let a process connect no second time to a publisher while it is about to.

    Args:
        handler: of rospy, which connects topics.
    """
    connect = handler._connect_topic
    lock = threading.Lock()
    under_way: Set[Tuple[str, str]] = set()

    def guarded(topic: str, uri: str) -> Any:
        with lock:
            if (topic, uri) in under_way:
                return 1, f"{topic}: a connection to {uri} is being made", 0
            under_way.add((topic, uri))
        try:
            return connect(topic, uri)
        finally:
            with lock:
                under_way.discard((topic, uri))

    handler._connect_topic = guarded
