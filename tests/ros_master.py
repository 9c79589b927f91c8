"""A real ROS master for tests, and ROS's own commands."""

from __future__ import annotations

import os
import socket
import subprocess
import xmlrpc.client
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Dict, Iterator, Mapping, Optional

__all__ = ["MasterProcess", "ros_environment", "running_master", "say"]

_SCRIPT = """\
import sys, rosmaster.master
master = rosmaster.master.Master({port})
master.start()
print('ready', flush=True)
sys.stdin.read()
master.stop()
"""


def ros_environment(home: Path) -> Dict[str, str]:
    """Give an environment for processes that use ROS, whose logs and caches stay in a folder."""
    return {**os.environ, "ROS_HOME": str(home), "ROS_LOG_DIR": str(home), "ROS_HOSTNAME": "127.0.0.1"}


class MasterProcess:
    """A master on a port that stays its own, to be killed and started again.

    Attributes:
        environment: points at it, whether it runs or not.

    Args:
        environment: for the master; ROS is installed.
    """

    def __init__(self, environment: Mapping[str, str]) -> None:
        with socket.socket() as probe:
            probe.bind(("127.0.0.1", 0))
            self._port = probe.getsockname()[1]
        uri = f"http://127.0.0.1:{self._port}"
        self.environment = {**environment, "ROS_MASTER_URI": uri, "ROS_HOSTNAME": "127.0.0.1"}
        self._process: Optional[subprocess.Popen[str]] = None

    def start(self) -> None:
        """Start it; it answers when this returns."""
        command = ["/usr/bin/python3", "-c", _SCRIPT.format(port=self._port)]
        self._process = process = subprocess.Popen(
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, env=self.environment
        )
        assert process.stdout is not None
        assert process.stdout.readline().strip() == "ready"

    def stop(self, kill: bool = False) -> None:
        """End it, by a kill or as it ends by itself when the tests do."""
        process, self._process = self._process, None
        if process is None:
            return
        assert process.stdin is not None
        assert process.stdout is not None
        if kill:
            process.kill()
        process.stdin.close()
        process.wait(timeout=60)
        process.stdout.close()

    def ask(self, method: str, *arguments: object) -> Any:
        """Call a method of its API, as a node that is none; give the value."""
        with xmlrpc.client.ServerProxy(self.environment["ROS_MASTER_URI"]) as proxy:
            return getattr(proxy, method)("/test", *arguments)[2]  # type: ignore[index]


@contextmanager
def running_master(environment: Mapping[str, str]) -> Iterator[Dict[str, str]]:
    """Start a master on a free port.

    Args:
        environment: for the master; ROS is installed.

    Yields:
        An environment that points at it.
    """
    master = MasterProcess(environment)
    master.start()
    try:
        yield master.environment
    finally:
        master.stop()


def say(*command: str, environment: Mapping[str, str], timeout: float = 60) -> str:
    """Run one of ROS's commands, which must succeed, and give what it prints."""
    finished = subprocess.run(
        command, capture_output=True, text=True, env=dict(environment), timeout=timeout, check=False
    )
    assert finished.returncode == 0, finished.stderr
    return finished.stdout
