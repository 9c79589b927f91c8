"""A ROS 1 graph of a benchmark's own: a master, and processes that join it."""

from __future__ import annotations

import os
import signal
import socket
import subprocess
import sys
import tempfile
import time
from contextlib import ExitStack
from pathlib import Path
from types import TracebackType
from typing import Callable, Dict, List, Optional, Sequence, Type

from rqt_mrta_py.errors import MissingDependencyError, MrtaError, UsageError

__all__ = ["LiveSession", "Member", "processor_seconds", "resident_bytes", "until"]

_MASTER = """\
import sys, rosmaster.master
master = rosmaster.master.Master({port})
master.start()
print("ready", flush=True)
sys.stdin.read()
master.stop()
"""
_PATIENCE = 60.0
"""How long a process may take until it is ready [s]."""

_TICKS = os.sysconf("SC_CLK_TCK")
_PAGE = os.sysconf("SC_PAGE_SIZE")


class Member:
    """A process of the graph; it says lines on stdout, and ends when its stdin does.

    Attributes:
        name: for messages of errors.
        process: see ``subprocess``.

    Args:
        name: see above.
        process: see above.
        interrupts: whether it ends with SIGINT instead.
    """

    def __init__(self, name: str, process: subprocess.Popen[str], interrupts: bool = False) -> None:
        self.name = name
        self.process = process
        self._interrupts = interrupts

    def line(self) -> str:
        """Wait for its next line.

        Raises:
            UsageError: it has ended.
        """
        text = self.process.stdout.readline() if self.process.stdout is not None else ""
        if not text:
            raise UsageError(f"{self.name}: ended with status {self.process.wait()}, before it was done")
        return text.strip()

    def tell(self, line: str) -> None:
        """Tell it a line on stdin."""
        if self.process.stdin is not None:
            self.process.stdin.write(f"{line}\n")
            self.process.stdin.flush()

    def end(self) -> List[str]:
        """Ask it to end; give the lines that it still says."""
        if self._interrupts and self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
        if self.process.stdin is not None and not self.process.stdin.closed:
            try:
                self.process.stdin.close()
            except BrokenPipeError:
                pass
        out = self.process.stdout
        lines = [] if out is None or out.closed else out.read().splitlines()
        try:
            self.process.wait(_PATIENCE)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        if self.process.stdout is not None:
            self.process.stdout.close()
        return lines


class LiveSession:
    """A master on a free port of this machine; whatever was started ends with the ``with`` block.

    Attributes:
        environment: for processes that join.
        folder: for files of the benchmark; it goes with the session.

    Raises:
        MissingDependencyError: ROS 1 with a master is not installed.
    """

    def __init__(self) -> None:
        self._stack = ExitStack()
        self.folder = Path(self._stack.enter_context(tempfile.TemporaryDirectory(prefix="mrta-bench-")))
        with socket.socket() as probe:
            probe.bind(("127.0.0.1", 0))
            port = probe.getsockname()[1]
        self.environment: Dict[str, str] = {
            **os.environ,
            "ROS_MASTER_URI": f"http://127.0.0.1:{port}",
            "ROS_HOSTNAME": "127.0.0.1",
            "ROS_HOME": str(self.folder),
            "ROS_LOG_DIR": str(self.folder),
            # What runs from here finds what this process found.
            "PYTHONPATH": os.pathsep.join(path for path in sys.path if path),
        }
        try:
            # It tells at length of every node that has gone before it could be told of another's going.
            log = self.folder / "master.log"
            self.join("master", [sys.executable, "-c", _MASTER.format(port=port)], log=log).line()
        except MrtaError as error:
            self._stack.close()
            raise MissingDependencyError(
                "live benchmarks need a ROS master (module rosmaster); on Debian: apt-get install python3-roslaunch"
            ) from error

    def __enter__(self) -> LiveSession:
        return self

    def __exit__(
        self, kind: Optional[Type[BaseException]], error: Optional[BaseException], trace: Optional[TracebackType]
    ) -> None:
        self._stack.close()

    def join(self, name: str, command: Sequence[str], interrupts: bool = False, log: Optional[Path] = None) -> Member:
        """Start a process.

        Args:
            name: for messages of errors.
            command: with its arguments.
            interrupts: whether it ends with SIGINT, and not with its stdin.
            log: takes its stderr; None to let it through.
        """
        with ExitStack() as opened:
            process = subprocess.Popen(
                command,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=None if log is None else opened.enter_context(log.open("wb")),
                text=True,
                env=self.environment,
                cwd=self.folder,
            )
        member = Member(name, process, interrupts)
        self._stack.callback(member.end)
        return member

    def module(self, name: str, module: str, *arguments: str) -> Member:
        """Start a module of this package that prints ``ready`` once it is.

        Args:
            name: for messages of errors.
            module: dotted.
            arguments: of it.
        """
        return self.join(name, [sys.executable, "-m", module, *arguments])

    def node(self, name: str, *arguments: str) -> Member:
        """Start one of this package's nodes.

        Args:
            name: of the node.
            arguments: remappings and private parameters.
        """
        script = f"import sys; from rqt_mrta_py.app.nodes.{name} import main; sys.exit(main())"
        return self.join(name, [sys.executable, "-c", script, *arguments], interrupts=True)


def processor_seconds(process_id: int) -> float:
    """Give the processor time that a process has used, without its children's [s]."""
    text = Path(f"/proc/{process_id}/stat").read_text(encoding="ascii")
    user, system = text.rsplit(")", 1)[1].split()[11:13]
    return (int(user) + int(system)) / _TICKS


def resident_bytes(process_id: int) -> int:
    """Give what a process holds in memory [bytes]."""
    return int(Path(f"/proc/{process_id}/statm").read_text(encoding="ascii").split()[1]) * _PAGE


def until(condition: Callable[[], bool], what: str, timeout: float = _PATIENCE) -> None:
    """Wait for something.

    Args:
        condition: true once it is so.
        what: is waited for.
        timeout: for how long at most [s].

    Raises:
        UsageError: it did not become so.
    """
    end = time.monotonic() + timeout
    while not condition():
        if time.monotonic() > end:
            raise UsageError(f"{what}: not within {timeout:g} s")
        time.sleep(0.05)
