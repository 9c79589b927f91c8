"""Monitor pictures at a fixed place of the mission: a picture of tick t enters the stream one picture period later."""

from __future__ import annotations

from pathlib import Path
from typing import List, Optional, Tuple

from rqt_mrta_py.hooks import MonitorView, Outgoing, Renderer
from rqt_mrta_py.render import jpeg, write_picture

__all__ = ["PICTURE_TOPIC", "PictureSchedule", "period_in_ticks", "picture_name"]

PICTURE_TOPIC = "/mrta/monitor/compressed"


def picture_name(mission_time: float) -> str:
    """Name the picture of a mission time [s], so that names sort by time."""
    return f"{mission_time:010.3f}.png"


class PictureSchedule:
    """Draws every so many ticks, writes the file at once, and hands out the message one period later."""

    def __init__(self, renderer: Renderer, folder: Path, period_ticks: int, rate: int) -> None:
        """Plan the pictures.

        Args:
            renderer: draws them.
            folder: where the files go; it exists.
            period_ticks: one picture every so many ticks, at least 1.
            rate: ticks a second [Hz].
        """
        self._renderer = renderer
        self._folder = folder
        self._period = period_ticks
        self._rate = rate
        self._waiting: List[Tuple[int, Outgoing]] = []

    def due(self, tick: int) -> bool:
        """Tell whether a picture is to be drawn at a tick."""
        return tick % self._period == 0

    def draw(self, tick: int, view: MonitorView) -> None:
        """Draw what a tick looks like once everything of it has been heard, and write the file.

        Args:
            tick: of the mission.
            view: what to draw.
        """
        image = self._renderer(view)
        write_picture(self._folder / picture_name(tick / self._rate), image)
        fields = {"header": {"stamp": view.now, "frame_id": "map"}, "format": "jpeg", "data": jpeg(image)}
        self._waiting.append((tick + self._period, Outgoing(PICTURE_TOPIC, "sensor_msgs/CompressedImage", fields)))

    def placed_at(self, tick: int, last: bool) -> List[Outgoing]:
        """Give the messages whose place in the stream is a tick.

        Args:
            tick: of the mission.
            last: True at the mission's last tick, where what still waits is given too.
        """
        due = [message for place, message in self._waiting if last or place <= tick]
        self._waiting = self._waiting[len(due) :]
        return due


def period_in_ticks(period: float, rate: int) -> Optional[int]:
    """Turn a picture period [s] into whole ticks, at least one; None for no pictures.

    Args:
        period: 0 for no pictures [s].
        rate: ticks a second [Hz].
    """
    return max(1, round(period * rate)) if period > 0 else None
