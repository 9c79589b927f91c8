"""Monitor pictures at a fixed place of the mission: a picture of tick t enters the stream one picture period later."""

from __future__ import annotations

from collections import deque
from concurrent.futures import Future, ThreadPoolExecutor
from typing import Deque, List, Optional, Tuple

from rqt_mrta_py.app.outputs.picture_files import PictureFiles
from rqt_mrta_py.hooks import MonitorView, Outgoing, Renderer
from rqt_mrta_py.render import JpegSeries

__all__ = ["PICTURE_TOPIC", "PictureSchedule", "period_in_ticks"]

PICTURE_TOPIC = "/mrta/monitor/compressed"


class PictureSchedule:
    """Draws every so many ticks, and hands out the message one period later; it is encoded in a thread meanwhile."""

    def __init__(self, renderer: Renderer, period_ticks: int, rate: int, files: Optional[PictureFiles] = None) -> None:
        """Plan the pictures.

        Args:
            renderer: draws them.
            period_ticks: one picture every so many ticks, at least 1.
            rate: ticks a second [Hz].
            files: take each picture; None for none.
        """
        self._renderer = renderer
        self._period = period_ticks
        self._rate = rate
        self._files = files
        self._waiting: Deque[Tuple[int, float, Future[bytes]]] = deque()
        self._jpeg = JpegSeries()
        self._encoding = ThreadPoolExecutor(1, "mrta-encoding")

    def due(self, tick: int) -> bool:
        """Tell whether a picture is to be drawn at a tick."""
        return tick % self._period == 0

    def draw(self, tick: int, view: MonitorView) -> None:
        """Draw what a tick looks like once everything of it has been heard.

        Args:
            tick: of the mission.
            view: what to draw.
        """
        image = self._renderer(view)
        self._waiting.append((tick + self._period, view.now, self._encoding.submit(self._jpeg, image)))
        if self._files is not None:
            self._files.add(tick / self._rate, image)

    def placed_at(self, tick: int, last: bool) -> List[Outgoing]:
        """Give the messages whose place in the stream is a tick; waits for those that are not encoded yet.

        Args:
            tick: of the mission.
            last: True at the mission's last tick, where what still waits is given too.
        """
        placed: List[Outgoing] = []
        while self._waiting and (last or self._waiting[0][0] <= tick):
            _, stamp, data = self._waiting.popleft()
            fields = {"header": {"stamp": stamp, "frame_id": "map"}, "format": "jpeg", "data": data.result()}
            placed.append(Outgoing(PICTURE_TOPIC, "sensor_msgs/CompressedImage", fields))
        return placed

    def finish(self) -> None:
        """Wait until every file is written."""
        if self._files is not None:
            self._files.finish()

    def close(self) -> None:
        """Let the threads end."""
        self._encoding.shutdown()
        if self._files is not None:
            self._files.close()


def period_in_ticks(period: float, rate: int) -> Optional[int]:
    """Turn a picture period [s] into whole ticks, at least one; None for no pictures.

    Args:
        period: 0 for no pictures [s].
        rate: ticks a second [Hz].
    """
    return max(1, round(period * rate)) if period > 0 else None
