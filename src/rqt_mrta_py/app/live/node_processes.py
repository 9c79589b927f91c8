"""Processes that are nodes, forked from one that has loaded everything."""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
import threading
import time
from typing import Any, Callable, Dict, Mapping, NamedTuple, Sequence

__all__ = ["NodeProcesses"]

_END = 5.0
"""How long a node may take to end once it was asked to [s]."""


class _Node(NamedTuple):
    """What one process runs."""

    main: Callable[[Sequence[str]], int]
    arguments: Sequence[str]


class NodeProcesses:
    """Forks a process a node. This process must not be a node yet, nor have threads.

    The processes are in sessions of their own, so that Ctrl-C reaches only this one; they end when it ends.

    Args:
        nodes: what each runs, by name: a function of the node's arguments that gives an exit status, and those.
    """

    def __init__(self, nodes: Mapping[str, Sequence[Any]]) -> None:
        context = multiprocessing.get_context("fork")
        # Nobody writes: the reading end tells when this process has gone.
        self._alive, self._mine = os.pipe()
        # What is buffered now would be written twice.
        sys.stdout.flush()
        sys.stderr.flush()
        self._processes: Dict[str, Any] = {}
        for name, (main, arguments) in nodes.items():
            process = context.Process(
                target=_run, args=(_Node(main, arguments), self._alive, self._mine), name=name, daemon=True
            )
            process.start()
            self._processes[name] = process
        os.close(self._alive)

    def ended(self) -> Dict[str, int]:
        """Give the exit status of each node that has ended; of one that a signal ended, minus its number."""
        return {name: process.exitcode for name, process in self._processes.items() if process.exitcode is not None}

    def pid(self, name: str) -> int:
        """Give the id of a node's process."""
        pid: int = self._processes[name].pid
        return pid

    def ask_to_end(self, name: str) -> None:
        """Ask a node to end; it does so in its own time."""
        process = self._processes[name]
        if process.is_alive():
            process.terminate()

    def close(self) -> None:
        """Let all nodes end, those that do not by force."""
        for name in self._processes:
            self.ask_to_end(name)
        until = time.monotonic() + _END
        for process in self._processes.values():
            process.join(max(0.0, until - time.monotonic()))
            if process.is_alive():
                process.kill()
                process.join()
        os.close(self._mine)


def _run(node: _Node, alive: int, theirs: int) -> None:
    os.close(theirs)
    os.setsid()
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    threading.Thread(target=_end_with, args=(alive,), name="watching the starter", daemon=True).start()
    status = node.main(node.arguments)
    sys.stderr.flush()
    # The interpreter's own end would wait for threads of rospy's.
    os._exit(status)


def _end_with(alive: int) -> None:
    """End this process when the other end of a pipe is closed."""
    os.read(alive, 1)
    os.kill(os.getpid(), signal.SIGTERM)
