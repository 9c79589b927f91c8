"""A function of many items, on several cores, its answers in the order of the items."""

from __future__ import annotations

import multiprocessing
import os
import pickle
import queue
import signal
import sys
import threading
import traceback
from collections import deque
from contextlib import suppress
from multiprocessing.connection import Connection, wait
from typing import Any, Callable, Dict, Iterator, List, Optional, Sequence, Tuple, TypeVar, cast

from rqt_mrta_py.app.processes import sendable
from rqt_mrta_py.errors import MrtaError

__all__ = ["WorkerError", "in_order"]

_Item = TypeVar("_Item")
_Answer = TypeVar("_Answer")

_Reply = Tuple[int, Optional[BaseException], str, Any]
"""Of which item, what went wrong and where, the answer."""

_AHEAD = 4
"""How many items for each process may be worked on ahead of the oldest answer that nobody has taken."""


class WorkerError(MrtaError):
    """A process that shares the work has ended without a word."""


class _RemoteError(Exception):
    """Shows, as a cause, where in the other process something went wrong."""


def in_order(function: Callable[[_Item], _Answer], items: Sequence[_Item], processes: int) -> Iterator[_Answer]:
    """Apply a function to items and give its answers in their order.

    Processes are forked from this one, so that neither function nor items need to be sent; answers do. When the
    iteration ends, whatever the reason, so have they.

    Args:
        function: of one item; keeps nothing by which answers would differ.
        items: to apply it to.
        processes: that share the work; with one of them, or one item, all is done in this process.

    Raises:
        BaseException: what the function raised for the first item, in their order, for which it raised.
        WorkerError: a process ended without a word.
    """
    number = min(processes, len(items))
    if number <= 1:
        yield from map(function, items)
        return
    workers = _Workers(function, items, number)
    try:
        yield from workers.answers()
    finally:
        workers.close()


class _Workers:
    """Processes that wait for the number of an item, and answer for it."""

    def __init__(self, function: Callable[[Any], Any], items: Sequence[Any], number: int) -> None:
        self._items = items
        self._processes: Dict[Connection, Any] = {}
        context = multiprocessing.get_context("fork")
        # What is buffered now would be written by each of them.
        sys.stdout.flush()
        sys.stderr.flush()
        for count in range(number):
            ours, theirs = context.Pipe()
            process = context.Process(
                target=_work,
                args=(theirs, [*self._processes, ours], function, items),
                name=f"mrta-worker-{count + 1}",
                daemon=True,
            )
            process.start()
            theirs.close()
            self._processes[ours] = process

    def answers(self) -> Iterator[Any]:
        """Give the answers, one after the other."""
        idle: List[Connection] = list(self._processes)
        waiting = deque(range(len(self._items)))
        replies: Dict[int, _Reply] = {}
        for number in range(len(self._items)):
            while True:
                while idle and waiting and waiting[0] - number < _AHEAD * len(self._processes):
                    self._send(idle.pop(0), waiting.popleft())
                if number in replies:
                    break
                for ready in cast("List[Connection]", wait(list(self._processes))):
                    reply = self._receive(ready)
                    replies[reply[0]] = reply
                    idle.append(ready)
            _, error, where, answer = replies.pop(number)
            if error is not None:
                raise error from _RemoteError(where)
            yield answer

    def close(self) -> None:
        """End all processes, whatever they are at."""
        for process in self._processes.values():
            process.terminate()
        for connection, process in self._processes.items():
            process.join()
            connection.close()

    def _send(self, connection: Connection, number: int) -> None:
        try:
            connection.send(number)
        except OSError as error:
            raise self._gone(connection) from error

    def _receive(self, connection: Connection) -> _Reply:
        try:
            reply: _Reply = pickle.loads(connection.recv_bytes())
        except (EOFError, OSError) as error:
            raise self._gone(connection) from error
        return reply

    def _gone(self, connection: Connection) -> WorkerError:
        process = self._processes[connection]
        process.join()
        return WorkerError(f"a process that shared the work ended with status {process.exitcode}")


def _work(told: Connection, others: Sequence[Connection], function: Callable[[Any], Any], items: Sequence[Any]) -> None:
    """Answer until nobody is left who asks; then end at once, whatever is being worked on."""
    # Ctrl-C reaches the whole group; whether to end is for the process that asks to say.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    for connection in others:
        connection.close()
    inbox: queue.Queue[int] = queue.Queue()
    threading.Thread(target=_read, args=(told, inbox), name="mrta-reading", daemon=True).start()
    with suppress(OSError):
        while True:
            told.send_bytes(_reply(inbox.get(), function, items))


def _read(told: Connection, inbox: queue.Queue[int]) -> None:
    with suppress(EOFError, OSError):
        while True:
            inbox.put(told.recv())
    os._exit(1)


def _reply(number: int, function: Callable[[Any], Any], items: Sequence[Any]) -> bytes:
    reply: _Reply
    try:
        reply = (number, None, "", function(items[number]))
        return pickle.dumps(reply)
    except BaseException as error:  # noqa: BLE001 - the process that asks raises it
        reply = (number, sendable(error), traceback.format_exc(), None)
        return pickle.dumps(reply)
