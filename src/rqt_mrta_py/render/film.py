"""Films of pictures."""

from __future__ import annotations

import os
from contextlib import contextmanager
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Any, Iterator, Optional, Tuple, Type

from rqt_mrta_py.errors import RenderError
from rqt_mrta_py.render.libraries import opencv

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = ["FilmWriter"]

_CODEC = "VP80"
_SEGMENT = b"\x18\x53\x80\x67"
_HEAD = 256


class FilmWriter:
    """Writes a WebM film that browsers play (VP8), aside first; ``close`` renames it.

    The first picture fixes the size. A film without pictures leaves no file. As a context manager it closes at the
    end, also when an error ends it: a film of a mission that stopped is worth having.

    Args:
        path: of the film, ending in ``.webm``; its folder exists.
        pictures_per_second: how many pictures make one second of film.

    Raises:
        ValueError: the ending is another one, or no picture would be shown.
    """

    def __init__(self, path: Path, pictures_per_second: float) -> None:
        if path.suffix.lower() != ".webm":
            raise ValueError(f"{path}: a film's name must end in .webm")
        if not 0.0 < pictures_per_second < 1000.0:
            raise ValueError(f"pictures per second must be above 0 and below 1000 (got {pictures_per_second})")
        self._path = path
        # The ending tells the library what to write.
        self._aside = path.with_name(f".{path.stem}.part.webm")
        self._rate = pictures_per_second
        self._writer: Any = None
        self._size: Tuple[int, int] = (0, 0)
        self.pictures = 0

    def add(self, image: NDArray[np.uint8]) -> None:
        """Add a picture.

        Args:
            image: (height, width, 3), blue, green, red, of uint8; sides even, and the same for all.

        Raises:
            RenderError: the film cannot be begun: the file cannot be written, or OpenCV has no encoder.
            ValueError: the picture is of another size than the first, or no film can have it.
        """
        if image.ndim != 3 or image.shape[2] != 3 or image.dtype.name != "uint8":
            raise ValueError(
                f"{self._path}: a picture of shape {image.shape} and type {image.dtype.name} cannot be filmed; "
                "it must be (height, width, 3) of uint8"
            )
        height, width = image.shape[:2]
        if self._writer is None:
            self._writer = self._begun(width, height)
            self._size = (width, height)
        elif (width, height) != self._size:
            first = f"{self._size[0]} x {self._size[1]}"
            raise ValueError(f"{self._path}: the film began with {first} pixels (got a picture of {width} x {height})")
        self._writer.write(image)
        self.pictures += 1

    def close(self) -> None:
        """Finish the film; safe to call twice.

        Raises:
            RenderError: the film is not whole, for instance because the disk is full.
        """
        if self._writer is None:
            return
        self._writer.release()
        self._writer = None
        try:
            if not _is_whole(self._aside):
                raise RenderError(
                    f"{self._path}: the film was not written whole; make room on the disk, or do without a film"
                )
            self._aside.replace(self._path)
        except OSError as error:
            raise RenderError(f"{self._path}: the film cannot be written: {error.strerror or error}") from error
        finally:
            self._remove_aside()

    def _begun(self, width: int, height: int) -> Any:
        if width < 2 or height < 2 or width % 2 or height % 2:
            raise ValueError(f"{self._path}: the sides of a film must be even (got {width} x {height} pixels)")
        try:
            self._aside.write_bytes(b"")
        except OSError as error:
            raise RenderError(f"{self._path}: the film cannot be written: {error.strerror or error}") from error
        cv2 = opencv()
        with _silence():
            codec = cv2.VideoWriter_fourcc(*_CODEC)
            writer = cv2.VideoWriter(str(self._aside), cv2.CAP_FFMPEG, codec, self._rate, (width, height))
        if not writer.isOpened():
            self._remove_aside()
            raise RenderError(
                f"{self._path}: this OpenCV ({cv2.__version__}) was built without FFmpeg's VP8 encoder; "
                "install opencv-python-headless from PyPI, or do without a film"
            )
        return writer

    def _remove_aside(self) -> None:
        try:
            self._aside.unlink()
        except OSError:
            pass

    def __enter__(self) -> FilmWriter:
        return self

    def __exit__(
        self,
        kind: Optional[Type[BaseException]],
        error: Optional[BaseException],
        traceback: Optional[TracebackType],
    ) -> None:
        self.close()


def _is_whole(path: Path) -> bool:
    """Tell whether a film is as long as it says.

    The library tells of no failure to write, but at the end it writes into the head how long the rest is: the element
    Segment, its size in eight bytes of which the first is 1 (RFC 8794, 4; RFC 9559, 5.1).
    """
    with path.open("rb") as file:
        head = file.read(_HEAD)
        length = file.seek(0, os.SEEK_END)
    start = head.find(_SEGMENT)
    size = head[start + 4 : start + 12]
    return start >= 0 and size[:1] == b"\x01" and start + 12 + int.from_bytes(size[1:], "big") == length


@contextmanager
def _silence() -> Iterator[None]:
    """Keep FFmpeg from writing to the process' stderr that it numbers codecs in another way."""
    kept = os.dup(2)
    nowhere = os.open(os.devnull, os.O_WRONLY)
    try:
        os.dup2(nowhere, 2)
        yield
    finally:
        os.dup2(kept, 2)
        os.close(kept)
        os.close(nowhere)
