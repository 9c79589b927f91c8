"""A real ROS master for tests, and ROS's own commands."""

from __future__ import annotations

import socket
import subprocess
from contextlib import contextmanager
from typing import Dict, Iterator, Mapping

__all__ = ["running_master", "say"]

_SCRIPT = """\
import sys, rosmaster.master
master = rosmaster.master.Master({port})
master.start()
print('ready', flush=True)
sys.stdin.read()
master.stop()
"""


@contextmanager
def running_master(environment: Mapping[str, str]) -> Iterator[Dict[str, str]]:
    """Start a master on a free port.

    Args:
        environment: for the master; ROS is installed.

    Yields:
        An environment that points at it.
    """
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    pointed = {**environment, "ROS_MASTER_URI": f"http://127.0.0.1:{port}", "ROS_HOSTNAME": "127.0.0.1"}
    with subprocess.Popen(
        ["/usr/bin/python3", "-c", _SCRIPT.format(port=port)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
        env=pointed,
    ) as process:
        assert process.stdin is not None
        assert process.stdout is not None
        try:
            assert process.stdout.readline().strip() == "ready"
            yield pointed
        finally:
            process.stdin.close()
            process.wait(timeout=20)


def say(*command: str, environment: Mapping[str, str], timeout: float = 60) -> str:
    """Run one of ROS's commands, which must succeed, and give what it prints."""
    finished = subprocess.run(
        command, capture_output=True, text=True, env=dict(environment), timeout=timeout, check=False
    )
    assert finished.returncode == 0, finished.stderr
    return finished.stdout
