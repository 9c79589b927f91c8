"""The watching side of a run in a process of its own, on another core.

It is forked once everything is loaded and checked, so that it holds the same plugins, and fed a tick at a time. It may
lag behind by a few ticks, never by more than what a bag may lose. Whatever becomes of the team's side, the bag stays
whole: told to go, the process completes it; left alone, it brings to the file what it was told and leaves the bag open.
"""

from __future__ import annotations

import multiprocessing
import queue
import signal
import sys
import threading
import traceback
from contextlib import contextmanager, suppress
from multiprocessing.connection import Connection
from typing import Any, Iterator, List, NamedTuple, Optional, Tuple

from rqt_mrta_py.app.outputs.results import Results
from rqt_mrta_py.app.processes import sendable
from rqt_mrta_py.app.run.watch import Watcher, WatchPlan, open_watch
from rqt_mrta_py.errors import MrtaError
from rqt_mrta_py.hooks import Codec
from rqt_mrta_py.sim import PerfectLink
from rqt_mrta_py.transport import Batch, BatchPacker, BatchUnpacker, Bus

__all__ = ["WatchProcess", "WatchProcessError", "open_watch_process"]

_LAG = 0.4
"""How far the process may lag behind; with what the bag holds back, less than a second of the mission [s]."""
_PATIENCE = 0.5
"""How often a wait looks whether the other side still lives [s]."""
_END = 30.0
"""How long the process may take to complete the bag when a run is given up [s]."""

_F_SETPIPE_SZ = 1031
"""Linux's number of the call; ``fcntl`` names it from Python 3.10 on."""
_PIPE_SIZE = 1 << 20
"""What the pipe is to hold [bytes]: the most that Linux grants to anybody."""
_PIECE_SIZE = _PIPE_SIZE // 2
"""How much of a tick is held back before it is handed over [bytes]."""

_MORE = b"more"
"""Comes before a piece that does not end its tick."""
_FINISH = b"finish"
_GIVE_UP = b"give up"


class WatchProcessError(MrtaError):
    """The process that watches a run has ended without a word."""


class _RemoteError(Exception):
    """Shows, as a cause, where in the other process something went wrong."""


class WatchProcess:
    """Tells another process what a run does; made by ``open_watch_process``.

    What a large team says in a tick is handed over piece by piece, so that a write need not wait for the reader.
    """

    def __init__(self, plan: WatchPlan, codec: Codec) -> None:
        """Fork.

        Args:
            plan: what to watch.
            codec: reads and writes messages.
        """
        context = multiprocessing.get_context("fork")
        told, tell = context.Pipe(duplex=False)
        _widen(tell)
        answers, answer = context.Pipe(duplex=False)
        ticks = max(1, int(_LAG * plan.clock.rate))
        self._room: Any = context.Semaphore(ticks)
        self._tell: Connection = tell
        self._answers: Connection = answers
        self._packer = BatchPacker()
        self._pending: List[Batch] = []
        self._pending_bytes = 0
        self._has_room = False
        # What is buffered now would be written twice.
        sys.stdout.flush()
        sys.stderr.flush()
        self._process = context.Process(
            target=_run,
            args=(_Ends(plan, codec, told, answer, self._room), (tell, answers)),
            name="mrta-watch",
            daemon=True,
        )
        self._process.start()
        told.close()
        answer.close()

    def hear(self, batch: Batch) -> None:
        """Take in messages of the present tick.

        Raises:
            MrtaError: of whatever went wrong there.
        """
        self._pending.append(batch)
        self._pending_bytes += len(batch.content)
        if self._pending_bytes > _PIECE_SIZE:
            self._await_room()
            self._send(_MORE)
            self._hand_over()

    def end_tick(self, tick: int) -> None:
        """Hand over what is left of a tick; waits while the other process lags too far behind.

        Raises:
            MrtaError: of whatever went wrong there.
        """
        self._await_room()
        self._hand_over()
        self._has_room = False

    def finish(self) -> Results:
        """End the stream and wait for what is derived from it.

        Raises:
            MrtaError: of whatever went wrong there.
        """
        self._send(_FINISH)
        while not self._answers.poll(_PATIENCE):
            self._look()
        results = self._receive()
        self._process.join(_END)
        if results is None:
            raise self._gone()
        return results

    def close(self) -> None:
        """Let the process complete the bag and end; one that does not is ended."""
        if self._process.is_alive():
            try:
                self._tell.send_bytes(_GIVE_UP)
            except OSError:
                pass
            self._process.join(_END)
            if self._process.is_alive():
                self._process.terminate()
                self._process.join()
        self._tell.close()
        self._answers.close()

    def _await_room(self) -> None:
        """Wait until one more tick may be on its way."""
        while not self._has_room:
            self._has_room = self._room.acquire(timeout=_PATIENCE)
            if not self._has_room:
                self._look()

    def _hand_over(self) -> None:
        piece = self._packer.pack(self._pending)
        self._pending.clear()
        self._pending_bytes = 0
        self._send(piece)

    def _send(self, message: bytes) -> None:
        try:
            self._tell.send_bytes(message)
        except OSError:
            # The pipe breaks before the process counts as ended.
            self._process.join(_END)
            self._look()
            raise

    def _look(self) -> None:
        """Raise what the other process says went wrong, or that it is gone."""
        alive = self._process.is_alive()
        if self._answers.poll():
            self._receive()
        if not alive:
            raise self._gone()

    def _gone(self) -> WatchProcessError:
        return WatchProcessError(
            f"the process that watches the run ended with status {self._process.exitcode}; "
            "'mrta salvage' saves what its bag holds, and --processes 1 does without it"
        )

    def _receive(self) -> Optional[Results]:
        try:
            error, where, results = self._answers.recv()
        except EOFError:
            return None
        if error is not None:
            raise error from _RemoteError(where)
        answer: Results = results
        return answer


def _widen(pipe: Connection) -> None:
    with suppress(ImportError, OSError):  # other systems have no such call, and an administrator may set a limit
        import fcntl

        fcntl.fcntl(pipe.fileno(), _F_SETPIPE_SZ, _PIPE_SIZE)


@contextmanager
def open_watch_process(plan: WatchPlan, codec: Codec) -> Iterator[WatchProcess]:
    """Watch from another process; when the block is left, it has ended.

    Args:
        plan: what to watch.
        codec: reads and writes messages.
    """
    process = WatchProcess(plan, codec)
    try:
        yield process
    finally:
        process.close()


class _Ends(NamedTuple):
    """What the other process holds: the plan, and its ends of what joins the two."""

    plan: WatchPlan
    codec: Codec
    told: Connection
    answer: Connection
    room: Any


@contextmanager
def open_watcher(plan: WatchPlan, bus: Bus, codec: Codec, processes: int) -> Iterator[Watcher]:
    """Watch what is published on the team's bus, from this process or from another.

    Args:
        plan: what to watch.
        bus: of the team.
        codec: reads and writes messages.
        processes: 1 to watch from this process, 2 from another.
    """
    if processes == 1:
        with open_watch(plan, bus) as watch:
            yield watch
    else:
        with open_watch_process(plan, codec) as process:
            bus.tap(process.hear)
            yield process


def _run(ends: _Ends, theirs: Tuple[Connection, ...]) -> None:
    """Watch in this process until told to finish, or left alone."""
    # Ctrl-C reaches the whole group; whether to end is for the team's side to say.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    for connection in theirs:
        connection.close()
    answer: Tuple[Optional[BaseException], str, Optional[Results]]
    try:
        results = _watch(ends)
    except BaseException as error:  # noqa: BLE001 - the other side raises it
        answer = (sendable(error), traceback.format_exc(), None)
    else:
        answer = (None, "", results)
    with suppress(OSError):  # nobody may be left to hear it
        ends.answer.send(answer)
    ends.answer.close()


def _watch(ends: _Ends) -> Optional[Results]:
    inbox: queue.Queue[Optional[bytes]] = queue.Queue()
    threading.Thread(target=_read, args=(ends.told, inbox), name="mrta-reading", daemon=True).start()
    unpacker = BatchUnpacker()
    bus = Bus(ends.codec, PerfectLink())
    with open_watch(ends.plan, bus) as watch:
        tick = 0
        ends_tick = True
        while True:
            message = inbox.get()
            if message is None:
                watch.abandon()
                return None
            if message == _GIVE_UP:
                return None
            if message == _FINISH:
                return watch.finish()
            if message == _MORE:
                ends_tick = False
                continue
            with ends.plan.patience.at_work(f"the watching of the tick at {tick / ends.plan.clock.rate:g} s"):
                for batch in unpacker.unpack(message):
                    watch.hear(batch)
            if ends_tick:
                watch.end_tick(tick)
                tick += 1
                ends.room.release()
            ends_tick = True


def _read(told: Connection, inbox: queue.Queue[Optional[bytes]]) -> None:
    """Take messages off the pipe while earlier ones are worked on; the sender bounds how many there are."""
    try:
        while True:
            inbox.put(told.recv_bytes())
    except (EOFError, OSError):
        inbox.put(None)
