"""Processes that tests tell line by line what to do: rospy knows one node and one master a process."""

from __future__ import annotations

import importlib.util
import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from types import TracebackType
from typing import Any, Callable, Mapping, Optional, Type

import pytest

__all__ = ["LONGEST", "PythonProcess", "require_live_ros", "wait_for"]

LONGEST = 60.0
"""How long whatever is waited for may take on a loaded machine [s]."""

_ROOT = Path(__file__).resolve().parent.parent

_LOOP = """\
import json, os, sys, time, traceback
replies = os.fdopen(os.dup(1), "w", buffering=1)
os.dup2(2, 1)
names = {}

def until(text, timeout):
    end = time.monotonic() + timeout
    while not eval(text, names):
        if time.monotonic() > end:
            return False
        time.sleep(0.005)
    return True

for line in sys.stdin:
    kind, text, timeout = json.loads(line)
    try:
        if kind == "do":
            exec(compile(text, "told by the test", "exec"), names)
            reply = [True, None]
        elif kind == "ask":
            reply = [True, eval(text, names)]
        else:
            reply = [True, until(text, timeout)]
        replies.write(json.dumps(reply) + "\\n")
    except BaseException:
        replies.write(json.dumps([False, traceback.format_exc()]) + "\\n")
"""


def require_live_ros() -> None:
    """Skip a test where this Python sees no ROS 1 with a master."""
    missing = [name for name in ("rospy", "rosmaster", "rosgraph_msgs") if importlib.util.find_spec(name) is None]
    if missing:
        pytest.skip(f"ROS 1 is not installed for this Python: no {', '.join(missing)}")


class PythonProcess:
    """A Python process that does what it is told, and answers.

    Args:
        environment: of the process.
    """

    def __init__(self, environment: Mapping[str, str]) -> None:
        path = os.pathsep.join([str(_ROOT), *filter(None, [environment.get("PYTHONPATH")])])
        self._process = subprocess.Popen(
            [sys.executable, "-c", _LOOP],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            env={**environment, "PYTHONPATH": path},
        )

    def __enter__(self) -> PythonProcess:
        return self

    def __exit__(
        self, kind: Optional[Type[BaseException]], error: Optional[BaseException], where: Optional[TracebackType]
    ) -> None:
        self.close()

    def do(self, text: str) -> None:
        """Run statements; names stay."""
        self._tell("do", text)

    def ask(self, text: str) -> Any:
        """Evaluate an expression whose value JSON can carry."""
        return self._tell("ask", text)

    def until(self, text: str, timeout: float = LONGEST) -> None:
        """Wait until an expression becomes true."""
        if not self._tell("until", text, timeout):
            pytest.fail(f"after {timeout} s it still is not so: {text}")

    def kill(self, number: int = signal.SIGKILL) -> None:
        """Send a signal, without waiting for what becomes of it."""
        self._process.send_signal(number)

    def end(self, timeout: float = LONGEST) -> int:
        """Wait for the process to end by itself; give its exit code."""
        return self._process.wait(timeout)

    def leave(self, timeout: float = LONGEST) -> int:
        """Let the process reach the end of its program; give its exit code."""
        assert self._process.stdin is not None
        self._process.stdin.close()
        return self._process.wait(timeout)

    def close(self) -> None:
        """End the process."""
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        if self._process.poll() is None:
            self._process.kill()
        self._process.wait(LONGEST)
        try:
            self._process.stdin.close()
        except BrokenPipeError:
            pass
        self._process.stdout.close()

    def _tell(self, kind: str, text: str, timeout: float = 0.0) -> Any:
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        self._process.stdin.write(json.dumps([kind, text, timeout]) + "\n")
        self._process.stdin.flush()
        line = self._process.stdout.readline()
        assert line, f"the process ended with {self._process.wait(LONGEST)} when told: {text}"
        good, value = json.loads(line)
        assert good, value
        return value


def wait_for(condition: Callable[[], object], timeout: float = LONGEST) -> None:
    """Wait until a function gives something true."""
    end = time.monotonic() + timeout
    while not condition():
        assert time.monotonic() < end, f"after {timeout} s it still is not so"
        time.sleep(0.01)
