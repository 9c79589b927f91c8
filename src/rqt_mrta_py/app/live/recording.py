"""A recording of a live stream: messages go to the file from a thread of their own, so that hearing never waits.

Whatever becomes of the process, the file has all but the newest half second; messages wait no longer to be written.
"""

from __future__ import annotations

import logging
import threading
from collections import deque
from contextlib import suppress
from pathlib import Path
from typing import Deque, Optional, Sequence

from rqt_mrta_py.app.outputs.folder import safe_file_name
from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Stamped
from rqt_mrta_py.transport import BagWriter

__all__ = ["Recording", "free_bag", "free_folder"]

_log = logging.getLogger("rqt_mrta_py.app")

PERIOD = 0.4
"""How long a message waits to be written, at most [s]."""

_CHUNK_SECONDS = 10.0
"""Of the stream; chunks end sooner, with each writing."""

_MOST_WAITING = 256 * 2**20
"""More than this is not kept where the disk is too slow [bytes]."""


def free_bag(path: Path, name: str) -> Path:
    """Choose a bag that takes nobody's place.

    Args:
        path: of a bag, ending in ``.bag``, or of a folder for bags.
        name: of the bag in a folder, any text, without its ending.

    Returns:
        The bag asked for, or else the first of ``<name>-2.bag``, ``<name>-3.bag``, ... that is not there, neither
        whole nor as a recording that was never completed.

    Raises:
        TransportError: its folder cannot be made.
    """
    path = path.absolute()
    wanted = path if path.suffix == ".bag" and not path.is_dir() else path / f"{safe_file_name(name)}.bag"
    try:
        wanted.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise TransportError(f"{error.filename or path}: cannot be made: {error.strerror}") from error
    bag, number = wanted, 1
    while bag.exists() or bag.with_name(f"{bag.name}.active").exists():
        number += 1
        bag = wanted.with_name(f"{wanted.stem}-{number}.bag")
    return bag


def free_folder(folder: Path) -> Path:
    """Choose the folder asked for, or else the first of ``<name>-2``, ``<name>-3``, ... that holds nothing.

    Args:
        folder: what is asked for.
    """
    chosen = folder = folder.absolute()
    number = 1
    while chosen.exists() and not (chosen.is_dir() and not any(chosen.iterdir())):
        number += 1
        chosen = folder.with_name(f"{folder.name}-{number}")
    return chosen


class Recording:
    """Records into one bag until it is closed.

    A bag that cannot be written any more, for the disk is full or gone, ends; that is logged, and nothing else stops.

    Attributes:
        path: of the bag.
        messages: how many are in the file.
        dropped: how many found no room, for the disk was too slow or is full.
        failure: why the recording has ended; empty while it goes on.

    Args:
        path: of a bag that does not exist.

    Raises:
        TransportError: the bag cannot be made.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self.messages = 0
        self.dropped = 0
        self.failure = ""
        self._bag = BagWriter(path, checkpoint_period=_CHUNK_SECONDS)
        self._waiting: Deque[Stamped] = deque()
        self._bytes = 0
        self._written_bytes = 0
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._run, name="recording", daemon=True)
        self._thread.start()

    @property
    def backlog(self) -> int:
        """How many messages wait to be written."""
        return len(self._waiting)

    def take(self, messages: Sequence[Stamped]) -> None:
        """Record messages; called by one thread at a time, in the order of receipts."""
        if self.failure or self._bytes - self._written_bytes > _MOST_WAITING:
            self.dropped += len(messages)
            return
        self._bytes += sum([len(stamped[2]) for stamped in messages])
        self._waiting.extend(messages)

    def close(self) -> Optional[Path]:
        """Complete the bag.

        Returns:
            The bag; None if it could not be completed, which has been logged.
        """
        self._ended.set()
        self._thread.join()
        if not self.failure:
            try:
                self._bag.close()
            except TransportError as error:
                self._fail(error)
        return None if self.failure else self.path

    def _run(self) -> None:
        ended = False
        while not (ended or self.failure):
            ended = self._ended.wait(PERIOD)
            try:
                self._write()
            except TransportError as error:
                self._fail(error)

    def _write(self) -> None:
        waiting, write = self._waiting, self._bag.write
        for _ in range(len(waiting)):
            stamped = waiting.popleft()
            write(stamped)
            self.messages += 1
            self._written_bytes += len(stamped.raw)
        self._bag.checkpoint()

    def _fail(self, error: TransportError) -> None:
        self.failure = str(error)
        self.dropped += len(self._waiting)
        self._waiting.clear()
        # It may still get its index; if not, mrta salvage makes a whole bag of it.
        with suppress(TransportError):
            self._bag.close()
        _log.error("recording=%s has ended: %s", self.path, error)
