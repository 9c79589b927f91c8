"""Missions of nodes against a master, started as a user starts them."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from pathlib import Path
from types import TracebackType
from typing import Any, Dict, List, Mapping, Optional, Sequence, Type, TypeVar

from rqt_mrta_py.app.cli.main import main
from rqt_mrta_py.hooks import Stamped
from rqt_mrta_py.transport import read_bag

__all__ = ["LiveRun", "Process", "check_review_is_run", "patrol_in", "robot_agent"]

_ROOT = Path(__file__).resolve().parents[2]


_P = TypeVar("_P", bound="Process")


class Process:
    """A program that is running, and what it says on stderr.

    Args:
        command: of the program.
        environment: of it.
    """

    def __init__(self, command: Sequence[str], environment: Mapping[str, str]) -> None:
        self._process = subprocess.Popen(
            list(command), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, env=dict(environment)
        )

    def __enter__(self: _P) -> _P:
        return self

    def __exit__(
        self, kind: Optional[Type[BaseException]], error: Optional[BaseException], where: Optional[TracebackType]
    ) -> None:
        if self._process.poll() is None:
            self._process.terminate()
        self.end(20.0)

    @property
    def is_running(self) -> bool:
        return self._process.poll() is None

    def send(self, number: int) -> None:
        self._process.send_signal(number)

    def end(self, timeout: float = 90.0) -> List[str]:
        """Wait for the end; give the lines on stderr."""
        _, errors = self._process.communicate(timeout=timeout)
        return errors.splitlines()

    @property
    def status(self) -> int:
        status: int = self._process.returncode
        return status


class LiveRun(Process):
    """A running ``mrta run --ros``.

    Args:
        out: folder for the outputs.
        arguments: after those that say so.
        environment: points at a master.
    """

    def __init__(self, out: Path, environment: Mapping[str, str], *arguments: str) -> None:
        plan = ["run", *arguments, "--ros", "--pictures", "0", "--out", str(out), "-q"]
        super().__init__([sys.executable, "-m", "rqt_mrta_py", *plan], environment)
        self.out = out
        self.said: List[str] = []

    def finish(self, status: int = 0) -> None:
        """Wait for the end of the mission, which must be of this status."""
        self.said = self.end()
        assert self.status == status, self.said

    @property
    def summary(self) -> Dict[str, Any]:
        return dict(json.loads((self.out / "summary.json").read_text()))

    def messages(self) -> List[Stamped]:
        return list(read_bag(self.out / "mission.bag"))


def robot_agent(environment: Mapping[str, str], *arguments: str) -> Process:
    """Start an agent as rosrun does."""
    return Process([sys.executable, str(_ROOT / "scripts" / "robot_agent"), *arguments], environment)


def patrol_in(folder: Path, events: str) -> Path:
    """Copy the border patrol, with other events and in the world that costs less."""
    package = folder / "border_patrol"
    shutil.copytree(str(_ROOT / "plugins" / "applications" / "border_patrol"), str(package))
    scenario = package / "scenario.yaml"
    text, _, _ = scenario.read_text().replace("world: bullet", "world: planar").partition("events:")
    scenario.write_text(f"{text}events:\n{events}")
    return package


def check_review_is_run(run: LiveRun, folder: Path) -> None:
    """Review a run's bag to a folder below another one; what it found must be what the run found."""
    review = folder / "review"
    assert main(["review", str(run.out / "mission.bag"), "--pictures", "0", "-q", "--out", str(review)]) == 0
    for name in ("summary.json", "events.jsonl", "incidents.jsonl"):
        assert (review / name).read_bytes() == (run.out / name).read_bytes(), name
