"""A ROS master: the one that answers, else one of our own for as long as it is needed."""

from __future__ import annotations

import importlib.util
import os
import socket
import subprocess
import sys
import time
from contextlib import contextmanager
from typing import Iterator, Tuple
from urllib.parse import urlsplit

from rqt_mrta_py.errors import MissingDependencyError, TransportError
from rqt_mrta_py.transport.ros1.master import Master

__all__ = ["some_master"]

_CALLER = "/mrta"
_PATIENCE = 10.0
"""How long a master of our own may take to answer [s]."""
_END = 5.0
"""How long it may take to end [s]."""

_MASTER = """\
import sys, rosmaster.master
master = rosmaster.master.Master({port})
master.start()
sys.stdin.read()
master.stop()
"""
"""Ends with whoever started it, for its stdin does."""


@contextmanager
def some_master() -> Iterator[Master]:
    """Give the master that ``ROS_MASTER_URI`` names; start it where it would be on this machine and is not.

    Raises:
        MissingDependencyError: no master answers, and none can be started.
    """
    uri = os.environ.get("ROS_MASTER_URI") or "http://localhost:11311"
    master = Master(uri, _CALLER)
    if _answers(master):
        yield master
        return
    host, port = _place(uri)
    if not _is_local(host):
        raise MissingDependencyError(
            f"no ROS master answers at {uri}; start one there, or let ROS_MASTER_URI name this machine"
        )
    if importlib.util.find_spec("rosmaster") is None:
        raise MissingDependencyError(
            f"no ROS master answers at {uri}, and none can be started: rosmaster is not installed; "
            "on Debian: apt-get install python3-rosmaster"
        )
    os.environ["ROS_MASTER_URI"] = uri
    sys.stderr.write(f"mrta: no ROS master answers at {uri}; one is started for this run\n")
    # In a session of its own: Ctrl-C is for the run to hear, and the master must outlive its nodes.
    process = subprocess.Popen(
        [sys.executable, "-c", _MASTER.format(port=port)],
        stdin=subprocess.PIPE,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        start_new_session=True,
    )
    try:
        _await(master, process)
        yield master
    finally:
        if process.stdin is not None:
            process.stdin.close()
        try:
            process.wait(_END)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()


def _answers(master: Master) -> bool:
    try:
        master.ask("getPid")
    except TransportError:
        return False
    return True


def _await(master: Master, process: subprocess.Popen[bytes]) -> None:
    until = time.monotonic() + _PATIENCE
    while not _answers(master):
        if process.poll() is not None or time.monotonic() > until:
            raise MissingDependencyError(f"the ROS master that was started at {master.uri} does not answer")
        time.sleep(0.02)


def _place(uri: str) -> Tuple[str, int]:
    try:
        parts = urlsplit(uri)
        return parts.hostname or "", parts.port or 11311
    except ValueError as error:
        raise TransportError(
            f"ROS_MASTER_URI {uri!r}: {error}; a URI such as http://localhost:11311 is accepted"
        ) from error


def _is_local(host: str) -> bool:
    """Tell whether a name is this machine's: whether one could listen on its address."""
    try:
        addresses = socket.getaddrinfo(host, 0, type=socket.SOCK_STREAM)
    except OSError:
        return False
    for family, kind, protocol, _, address in addresses:
        try:
            with socket.socket(family, kind, protocol) as probe:
                probe.bind(address)
        except OSError:
            continue
        return True
    return False
