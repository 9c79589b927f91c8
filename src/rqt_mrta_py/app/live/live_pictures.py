"""Monitor pictures of a live mission, each as soon as it is drawn."""

from __future__ import annotations

import logging
from concurrent.futures import Future
from typing import Any, Callable

from rqt_mrta_py.app.live.drawing import Drawing, PictureFormat
from rqt_mrta_py.app.outputs.pictures import PICTURE_TOPIC
from rqt_mrta_py.hooks import MonitorView, Outgoing

__all__ = ["LivePictures"]

_log = logging.getLogger("rqt_mrta_py.app")

_NS = 1_000_000_000


class LivePictures:
    """Draws pictures at a period; one that is due while another is being drawn is left out.

    Attributes:
        undrawn: how many were left out, or could not be drawn.

    Args:
        drawing: draws them.
        period: between pictures; 0 for none [s].
        lock: of the node.
        say: publishes a message; called with the lock held.
    """

    def __init__(self, drawing: Drawing, period: float, lock: Any, say: Callable[[Outgoing], None]) -> None:
        self.undrawn = 0
        self._drawing = drawing
        self._period_ns = round(period * _NS)
        self._lock = lock
        self._say = say
        self._due_ns = 0
        self._failed = ""

    def due(self, receipt_ns: int) -> bool:
        """Tell whether a picture is due at a time of the stream [ns]."""
        return self._period_ns > 0 and receipt_ns >= self._due_ns

    def draw(self, receipt_ns: int, view: Callable[[float], MonitorView]) -> None:
        """Draw a picture that is due.

        Args:
            receipt_ns: the time [ns].
            view: gives what is to be drawn of a time [s].
        """
        period = self._period_ns
        self._due_ns = max(self._due_ns + period, receipt_ns - receipt_ns % period + period)
        if self._drawing.busy:
            self.undrawn += 1
            return
        seen = view(receipt_ns / _NS)
        self._drawing.draw(seen, PictureFormat.JPEG).add_done_callback(lambda done: self._publish(seen.now, done))

    def _publish(self, stamp: float, done: Future[bytes]) -> None:
        error = done.exception()
        with self._lock:
            if error is None:
                fields = {"header": {"stamp": stamp, "frame_id": "map"}, "format": "jpeg", "data": done.result()}
                self._say(Outgoing(PICTURE_TOPIC, "sensor_msgs/CompressedImage", fields))
                return
            self.undrawn += 1
            if not self._drawing.closed and str(error) != self._failed:
                self._failed = str(error)
                _log.error("picture=%.3f was not drawn: %s", stamp, error)
