"""Bags of what happened just now: when somebody asks, and when something went badly wrong."""

from __future__ import annotations

import logging
import threading
from pathlib import Path
from typing import List, Optional, Sequence

from rqt_mrta_py.app.live.recording import free_bag
from rqt_mrta_py.errors import MrtaError, TransportError
from rqt_mrta_py.hooks import Stamped
from rqt_mrta_py.transport import BagWriter

__all__ = ["Snapshots", "write_snapshot"]

_log = logging.getLogger("rqt_mrta_py.app")

_PAUSE = 1.0
"""Errors within this time of the stream after one another share a snapshot [s]."""


class Snapshots:
    """Writes a bag at each error, in a thread, unless one has just been written.

    Attributes:
        written: how many.

    Args:
        folder: where to; None: none are written.
    """

    def __init__(self, folder: Optional[Path]) -> None:
        self.folder = folder
        self.written = 0
        self._last: Optional[float] = None
        self._threads: List[threading.Thread] = []

    def due(self, now: float) -> bool:
        """Tell whether an error at a time [s] gets a bag of its own."""
        if self.folder is None or (self._last is not None and now - self._last < _PAUSE):
            return False
        self._last = now
        return True

    def write(self, messages: Sequence[Stamped], name: str) -> None:
        """Write a bag, later.

        Args:
            messages: in order.
            name: of the bag, any text.
        """
        thread = threading.Thread(target=self._write, args=(messages, name), name="snapshot", daemon=True)
        self._threads = [each for each in self._threads if each.is_alive()] + [thread]
        thread.start()

    def close(self) -> None:
        """Wait until all are written."""
        for thread in self._threads:
            thread.join()

    def _write(self, messages: Sequence[Stamped], name: str) -> None:
        try:
            path = write_snapshot(free_bag(self.folder or Path(), name), messages)
        except MrtaError as error:
            _log.error("snapshot=%s was not written: %s", name, error)
        else:
            self.written += 1
            _log.warning("snapshot=%s messages=%d", path, len(messages))


def write_snapshot(path: Path, messages: Sequence[Stamped]) -> Path:
    """Write messages into a bag.

    Args:
        path: of the bag; it must not exist.
        messages: in order.

    Returns:
        The path, absolute.

    Raises:
        TransportError: the bag exists or cannot be written.
    """
    if path.suffix != ".bag":
        raise TransportError(f"{path}: is no name of a bag; give one that ends in .bag")
    with BagWriter(path) as bag:
        for stamped in messages:
            bag.write(stamped)
    return path.absolute()
