"""Replays docs/live.md: types what the page types in three terminals, and expects what it shows.

A block of ``console`` that begins with ``# terminal N`` is started and left running. All others are typed one after
another in one more terminal, and what they print is expected as in the tutorial. A block of ``text`` is waited for: its
lines come, in order, in the terminal that watches.
"""

from __future__ import annotations

import os
import re
import shutil
import signal
import socket
import subprocess
import sys
import threading
import time
from pathlib import Path
from typing import Dict, Iterator, List, Tuple

import pytest

from tests.conftest import ROOT
from tests.ros_process import require_live_ros
from tests.test_tutorial import looks_like, session

pytestmark = pytest.mark.ros

PAGE = ROOT / "docs" / "live.md"
LONGEST = 90.0
"""How long nothing may come that is expected [s]."""


def blocks() -> List[Tuple[str, str]]:
    """List the page's blocks that a test can do something with, each with its kind."""
    return re.findall(r"^```(console|text)\n(.*?)^```$", PAGE.read_text(encoding="utf-8"), re.DOTALL | re.MULTILINE)


class Terminal:
    """A command that runs on, and what it says."""

    def __init__(self, command: str, folder: Path, environment: Dict[str, str]) -> None:
        self.process = subprocess.Popen(
            ["bash", "-c", command],
            cwd=folder,
            env=environment,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            start_new_session=True,
        )
        self.lines: List[str] = []
        self._place = 0
        self._thread = threading.Thread(target=self._read)
        self._thread.start()

    def expect(self, text: str) -> None:
        """Wait for a line that holds a text, behind the one that was waited for before."""
        until = time.monotonic() + LONGEST
        while time.monotonic() < until:
            for number in range(self._place, len(self.lines)):
                if text in self.lines[number]:
                    self._place = number + 1
                    return
            time.sleep(0.05)
        pytest.fail(f"{text!r} did not come; what came is\n{''.join(self.lines)}")

    def end(self) -> None:
        """Press Ctrl-C, and insist on it."""
        for number in (signal.SIGINT, signal.SIGKILL):
            if self.process.poll() is None:
                os.killpg(self.process.pid, number)
                try:
                    self.process.wait(20)
                except subprocess.TimeoutExpired:
                    continue
        self._thread.join()
        assert self.process.stdout is not None
        self.process.stdout.close()

    def _read(self) -> None:
        assert self.process.stdout is not None
        self.lines.extend(iter(self.process.stdout.readline, ""))


@pytest.fixture
def environment(tmp_path: Path) -> Dict[str, str]:
    require_live_ros()
    missing = [
        name for name in ("roslaunch", "rosrun", "rostopic", "rosservice", "rosbag") if shutil.which(name) is None
    ]
    messages = ROOT / ".venv" / "messages"
    if missing or not (messages / "rqt_mrta_py" / "srv").is_dir():
        pytest.skip(f"not here: {', '.join(missing) or 'generated message classes'}")
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    return {
        **os.environ,
        "PYTHONPATH": str(messages),
        "PYTHONUNBUFFERED": "1",
        "ROS_HOME": str(tmp_path / "ros"),
        "ROS_HOSTNAME": "127.0.0.1",
        "ROS_LOG_DIR": str(tmp_path / "ros"),
        "ROS_MASTER_URI": f"http://127.0.0.1:{port}",
        "ROS_PACKAGE_PATH": f"{ROOT}:{ROOT / 'plugins'}",
    }


@pytest.fixture
def terminals() -> Iterator[Dict[str, Terminal]]:
    found: Dict[str, Terminal] = {}
    yield found
    for name in sorted(found, reverse=True):
        found[name].end()
        # Shown if the test failed.
        sys.stdout.write(f"{name}\n{''.join(found[name].lines)}")


@pytest.mark.long
def test_the_page_is_a_session_that_works(
    environment: Dict[str, str], terminals: Dict[str, Terminal], tmp_path: Path
) -> None:
    folder = tmp_path / "here"
    folder.mkdir()
    for kind, block in blocks():
        name, _, rest = block.partition("\n")
        if kind == "text":
            for line in block.splitlines():
                terminals["# terminal 2"].expect(line)
        elif name.startswith("# terminal"):
            (command,) = session(f"```console\n{rest}```")
            terminals[name] = Terminal(command.command, folder, environment)
            if len(terminals) == 1:
                terminals[name].expect("started core service")
        else:
            for typed in session(f"```console\n{block}```"):
                done = subprocess.run(
                    ["bash", "-c", typed.command],
                    cwd=folder,
                    env=environment,
                    stdout=subprocess.PIPE,
                    stderr=subprocess.STDOUT,
                    text=True,
                    timeout=LONGEST,
                    check=False,
                )
                assert done.returncode == 0, (typed.command, done.stdout)
                assert re.fullmatch(looks_like(typed.shown), done.stdout), (typed.command, done.stdout)
    assert (folder / "now.png").read_bytes().startswith(b"\x89PNG")
    assert (folder / "nodes.png").read_bytes().startswith(b"\x89PNG")
    terminals["# terminal 1"].process.wait(30)
