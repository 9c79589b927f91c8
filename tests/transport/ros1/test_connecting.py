"""Regression: a second attempt to connect took the place of the first, and what had come through that was lost."""

from __future__ import annotations

import threading
from typing import List, Tuple

from rqt_mrta_py.transport.ros1.connecting import connect_once


class Handler:
    def __init__(self) -> None:
        self.begun = threading.Event()
        self.go_on = threading.Event()
        self.attempts: List[Tuple[str, str]] = []

    def _connect_topic(self, topic: str, uri: str) -> Tuple[int, str, int]:
        self.attempts.append((topic, uri))
        self.begun.set()
        self.go_on.wait(10)
        return 1, "connected", 4711


def test_a_connection_that_is_being_made_is_not_begun_again() -> None:
    handler = Handler()
    connect_once(handler)
    first = threading.Thread(target=handler._connect_topic, args=("/a", "http://one"))
    first.start()
    assert handler.begun.wait(10)
    assert handler._connect_topic("/a", "http://one")[0] == 1
    handler.go_on.set()
    assert handler._connect_topic("/a", "http://two") == (1, "connected", 4711)
    first.join()
    assert handler._connect_topic("/a", "http://one") == (1, "connected", 4711)
    assert handler.attempts == [("/a", "http://one"), ("/a", "http://two"), ("/a", "http://one")]
