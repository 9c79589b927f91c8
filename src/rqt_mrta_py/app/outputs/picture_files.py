"""Monitor pictures as files: one each, and a film of all."""

from __future__ import annotations

import logging
from collections import deque
from concurrent.futures import Future, ThreadPoolExecutor
from pathlib import Path
from typing import TYPE_CHECKING, Deque, List, Optional, Protocol

from rqt_mrta_py.app.outputs.folder import OutputFolder
from rqt_mrta_py.errors import RenderError, UsageError
from rqt_mrta_py.render import write_picture

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = ["FILM_RATE", "Film", "PictureFiles", "check_film", "open_film", "picture_name"]

_log = logging.getLogger("rqt_mrta_py.app")

FILM_RATE = 10
"""Pictures a second of film [Hz]."""

_UNDER_WAY = 4
"""So many files may wait to be written before the next picture is taken; each picture takes some megabytes."""


def picture_name(mission_time: float) -> str:
    """Name the picture of a mission time [s], so that names sort by time."""
    return f"{mission_time:010.3f}.png"


class Film(Protocol):
    """Takes pictures one after another."""

    def add(self, image: NDArray[np.uint8]) -> None:
        """Append a picture."""
        ...

    def close(self) -> None:
        """Complete the film."""
        ...


def check_film(wanted: bool, period: float) -> None:
    """Check, before anything is written, that there will be pictures to make a film of.

    Args:
        wanted: whether there shall be a film.
        period: between two pictures, 0 for none [s].

    Raises:
        UsageError: there will be none.
    """
    if wanted and not period > 0:
        raise UsageError("--video: there are no pictures to make a film of; give --pictures a time above 0")


def open_film(folder: OutputFolder, wanted: bool) -> Optional[Film]:
    """Begin the film of a folder; one of an earlier run goes.

    Args:
        folder: for the outputs.
        wanted: False if there will be none.

    Raises:
        OutputError: an earlier one cannot be removed.
    """
    path = folder.film(wanted)
    if path is None:
        return None
    from rqt_mrta_py.render.film import FilmWriter

    return FilmWriter(path, FILM_RATE)


class PictureFiles:
    """Writes pictures behind the back of whoever draws them: in a thread of its own, and the film in another.

    Encoding takes longer than drawing and leaves Python's lock to others.

    Args:
        folder: where a file of each goes, it exists; None for no files.
        film: takes each; None for none.
    """

    def __init__(self, folder: Optional[Path], film: Optional[Film] = None) -> None:
        self._folder = folder
        self._film = film
        self._threads: List[ThreadPoolExecutor] = []
        self._writing = self._thread("mrta-pictures") if folder is not None else None
        self._filming = self._thread("mrta-film") if film is not None else None
        self._under_way: Deque[Future[None]] = deque()

    def add(self, mission_time: float, image: NDArray[np.uint8]) -> None:
        """Take the next picture; waits while too many are under way.

        Args:
            mission_time: that it shows [s].
            image: (height, width, 3), blue, green, red; not to be changed from now on.

        Raises:
            RenderError: one before it could not be written.
        """
        while len(self._under_way) >= _UNDER_WAY:
            self._under_way.popleft().result()
        if self._writing is not None and self._folder is not None:
            path = self._folder / picture_name(mission_time)
            self._under_way.append(self._writing.submit(write_picture, path, image))
        if self._filming is not None and self._film is not None:
            self._under_way.append(self._filming.submit(self._film.add, image))

    def finish(self) -> None:
        """Wait until every file is written, and complete the film.

        Raises:
            RenderError: one could not be written.
        """
        while self._under_way:
            self._under_way.popleft().result()
        if self._film is not None:
            self._film.close()

    def close(self) -> None:
        """Let the threads end; what is under way is still done, and a film that was begun is completed."""
        for thread in self._threads:
            thread.shutdown()
        if self._film is not None:
            try:
                self._film.close()
            except RenderError as error:
                # After ``finish`` there is nothing left to fail; before it, what ended the mission matters more.
                _log.warning("event=film_failed reason=%s", error)

    def _thread(self, name: str) -> ThreadPoolExecutor:
        thread = ThreadPoolExecutor(1, name)
        self._threads.append(thread)
        return thread
