"""Log lines of a node: to stderr as everywhere in this project, onto ``/rosout``, and into ROS's log file."""

from __future__ import annotations

import logging
from contextlib import contextmanager
from typing import Callable, Iterator, List, Tuple

from rqt_mrta_py.hooks import Outgoing
from rqt_mrta_py.transport.ros1.door import rospy

_log = logging.getLogger("rqt_mrta_py.transport")

__all__ = ["ROSOUT", "RosoutHandler", "own_logging"]

ROSOUT = ("/rosout", "rosgraph_msgs/Log")
"""Topic and type of log lines."""

_OURS = ("rqt_mrta_py", "rosout")
_ROSPYS = ("rospy", "rosout")

_LEVELS: Tuple[Tuple[int, int], ...] = (
    (logging.CRITICAL, 16),
    (logging.ERROR, 8),
    (logging.WARNING, 4),
    (logging.INFO, 2),
    (logging.DEBUG, 1),
)
"""From Python's levels to those of rosgraph_msgs/Log, the highest first."""


class RosoutHandler(logging.Handler):
    """Publishes log lines of this project and of rospy.

    Args:
        node: resolved name.
        now: gives ROS time [s].
        publish: is told what to publish.
    """

    def __init__(self, node: str, now: Callable[[], float], publish: Callable[[Outgoing], None]) -> None:
        super().__init__()
        self._node = node
        self._now = now
        self._publish = publish

    def handle(self, record: logging.LogRecord) -> bool:
        """Take in a line without a lock, for whoever held one might wait for somebody who publishes and logs."""
        accepted = bool(self.filter(record))
        if accepted:
            self.emit(record)
        return accepted

    def attach(self) -> None:
        """Begin to publish."""
        for name in _OURS:
            logging.getLogger(name).addHandler(self)

    def close(self) -> None:
        """Publish no more."""
        for name in _OURS:
            logging.getLogger(name).removeHandler(self)
        super().close()

    def emit(self, record: logging.LogRecord) -> None:
        """Publish a line; what goes wrong with it must not make another."""
        try:
            level = next((code for least, code in _LEVELS if record.levelno >= least), 1)
            fields = {
                "header": {"stamp": self._now()},
                "level": level,
                "name": self._node,
                "msg": record.getMessage(),
                "file": record.filename,
                "function": record.funcName,
                "line": record.lineno,
            }
            self._publish(Outgoing(*ROSOUT, fields, latched=True))
        except Exception:  # noqa: BLE001 - as logging's own handlers do
            self.handleError(record)


@contextmanager
def own_logging() -> Iterator[None]:
    """Keep this program's logging while rospy sets up its own; ROS's log file gets the lines of both."""
    # What is asked to end over the network says so with print, among what a command prints for a program to read.
    vars(rospy().impl.masterslave)["print"] = _log.info
    root = logging.getLogger()
    handlers, level = list(root.handlers), root.level
    try:
        yield
    finally:
        files: List[logging.Handler] = [each for each in root.handlers if each not in handlers]
        root.handlers[:] = handlers
        root.setLevel(level)
        logging.getLogger("rosout").handlers.clear()
        for name in dict.fromkeys((*_ROSPYS, *_OURS)):
            logger = logging.getLogger(name)
            for handler in files:
                logger.addHandler(handler)
        logging.getLogger("rospy").propagate = False
