"""Pictures drawn in another process, so that who hears messages never waits for them."""

from __future__ import annotations

import os
import pickle
import signal
import struct
import subprocess
import sys
import threading
import time
from concurrent.futures import Future, ThreadPoolExecutor
from enum import Enum
from typing import IO, Any, Callable, Dict, Optional, Tuple, cast

from rqt_mrta_py.errors import MrtaError, RenderError
from rqt_mrta_py.hooks import MonitorView

__all__ = ["Drawing", "PictureFormat", "serve_drawings"]

_size = struct.Struct("<Q")


class PictureFormat(Enum):
    """How a picture is encoded, as sensor_msgs/CompressedImage calls it."""

    JPEG = "jpeg"
    PNG = "png"


class Drawing:
    """Draws monitor pictures, one at a time, in a process that is started with the first of them.

    The process is made anew rather than forked: a fork of a process with threads holds locks that nobody opens.

    Attributes:
        drawn: how many pictures.
        seconds: what the last one took, until its bytes were here [s].
        closed: whether pictures are not drawn any more.
    """

    def __init__(self) -> None:
        self.drawn = 0
        self.seconds = 0.0
        self._talk = ThreadPoolExecutor(1, "drawing")
        self._process: Optional[subprocess.Popen[bytes]] = None
        self._waiting = 0
        self._lock = threading.Lock()
        self.closed = False

    @property
    def busy(self) -> bool:
        """Whether a picture is being drawn or waits for it."""
        return self._waiting > 0

    def start(self) -> None:
        """Start the process, so that the first picture need not wait for it."""
        self._talk.submit(self._running)

    def draw(self, view: MonitorView, picture_format: PictureFormat) -> Future[bytes]:
        """Draw a picture.

        Args:
            view: what it shows.
            picture_format: of the file.

        Returns:
            The file's bytes, later; a RenderError if it cannot be drawn.
        """
        with self._lock:
            self._waiting += 1
        return self._talk.submit(self._draw, view, picture_format)

    def close(self) -> None:
        """End the process; pictures that wait are not drawn any more."""
        self.closed = True
        process = self._process
        if process is not None:
            process.kill()
        self._talk.shutdown()
        if process is not None:
            _let_go(process)

    def _draw(self, view: MonitorView, picture_format: PictureFormat) -> bytes:
        began = time.monotonic()
        try:
            if self.closed:
                raise RenderError("pictures are not drawn any more")
            process = self._running()
            try:
                done, answer = _ask(process, pickle.dumps((view, picture_format.value), pickle.HIGHEST_PROTOCOL))
            except (OSError, EOFError) as error:
                process.kill()
                _let_go(process)
                self._process = None
                raise RenderError(f"the process that draws pictures ended with status {process.returncode}") from error
            if not done:
                raise RenderError(answer.decode("utf-8", "replace"))
        finally:
            with self._lock:
                self._waiting -= 1
        self.drawn += 1
        self.seconds = time.monotonic() - began
        return answer

    def _running(self) -> subprocess.Popen[bytes]:
        if self._process is None:
            # What is installed for this process may be nowhere else on the path.
            script = f"import sys; sys.path[:] = {sys.path!r}; import {__name__} as module; module.serve_drawings()"
            self._process = subprocess.Popen(
                [sys.executable, "-c", script], stdin=subprocess.PIPE, stdout=subprocess.PIPE, bufsize=-1
            )
        return self._process


def serve_drawings() -> None:
    """Draw what is asked for on stdin, until it ends; the other end of ``Drawing``."""
    from rqt_mrta_py.app.compose import compose
    from rqt_mrta_py.render import JpegSeries
    from rqt_mrta_py.render.encode import png

    # Ctrl-C reaches the whole group; stdin ends when the other side does.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    os.nice(5)
    asked, answers = sys.stdin.buffer, sys.stdout.buffer
    # Whatever else is printed must not get among the pictures.
    sys.stdout = sys.stderr
    renderer: Any = None
    encoders: Dict[str, Callable[[Any], bytes]] = {PictureFormat.JPEG.value: JpegSeries(), PictureFormat.PNG.value: png}
    while True:
        try:
            request = _read(asked)
        except EOFError:
            return
        try:
            view, picture_format = pickle.loads(request)
            renderer = renderer or compose().renderer("monitor")
            done, answer = True, encoders[picture_format](renderer(view))
        except MrtaError as error:
            done, answer = False, str(error).encode()
        except Exception as error:  # noqa: BLE001 - the other side tells it, and asks again
            done, answer = False, f"{type(error).__name__}: {error}".encode()
        answers.write(_size.pack(len(answer) + 1) + (b"\1" if done else b"\0") + answer)
        answers.flush()


def _ask(process: subprocess.Popen[bytes], request: bytes) -> Tuple[bool, bytes]:
    to, back = cast(IO[bytes], process.stdin), cast(IO[bytes], process.stdout)
    to.write(_size.pack(len(request)))
    to.write(request)
    to.flush()
    answer = _read(back)
    return answer[:1] == b"\1", answer[1:]


def _read(stream: IO[bytes]) -> bytes:
    head = stream.read(_size.size)
    if len(head) < _size.size:
        raise EOFError
    (size,) = _size.unpack(head)
    data = stream.read(size)
    if len(data) < size:
        raise EOFError
    return data


def _let_go(process: subprocess.Popen[bytes]) -> None:
    process.wait()
    for stream in (process.stdin, process.stdout):
        if stream is not None:
            try:
                stream.close()
            except OSError:
                # What had not been sent finds nobody any more.
                pass
