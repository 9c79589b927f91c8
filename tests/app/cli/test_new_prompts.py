"""mrta new at a terminal: a pseudo-terminal on which answers are typed."""

from __future__ import annotations

import os
import pty
import select
import signal
import subprocess
import sys
import time
from contextlib import suppress
from pathlib import Path
from typing import Dict, List, Optional

import pytest
import yaml

from tests.app.cli.test_new import MANDATORY, MANIFEST

PACKAGE = ["", "yard", "", "", "Looks after a yard.", "Ann", "a@b.c", "", ""]
"""Workspace, package, name, version, description, maintainer, e-mail, license, run dependencies."""


class Terminal:
    """A process whose standard streams are a terminal.

    Args:
        folder: in which it works, and which is on ROS's path.
        arguments: of mrta.
    """

    def __init__(self, folder: Path, *arguments: str) -> None:
        self._master, slave = pty.openpty()
        environment: Dict[str, str] = {**os.environ, "ROS_PACKAGE_PATH": str(folder), "TERM": "dumb"}
        self.process = subprocess.Popen(
            [sys.executable, "-m", "rqt_mrta_py", *arguments],
            cwd=folder,
            env=environment,
            stdin=slave,
            stdout=slave,
            stderr=slave,
            start_new_session=True,
        )
        os.close(slave)
        self.seen = ""

    def wait_for(self, text: str) -> None:
        """Read until something new is there that ends in a text."""
        begin, deadline = len(self.seen), time.monotonic() + 60.0
        while text not in self.seen[begin:]:
            assert time.monotonic() < deadline, self.seen
            piece = self._read(1.0)
            assert piece is not None, self.seen
            self.seen += piece

    def type(self, line: str, after: str) -> None:
        """Wait for a question, then answer it."""
        self.wait_for(after)
        os.write(self._master, f"{line}\n".encode())

    def press(self, key: bytes, after: str) -> None:
        """Wait for a question, then press a key."""
        self.wait_for(after)
        os.write(self._master, key)

    def ends_within(self, seconds: float) -> bool:
        """Tell whether the process ends in this time."""
        with suppress(subprocess.TimeoutExpired):
            self.process.wait(seconds)
        return self.process.poll() is not None

    def finish(self) -> int:
        """Read to the end; gives the exit status."""
        while True:
            piece = self._read(60.0)
            if not piece:
                break
            self.seen += piece
        os.close(self._master)
        return self.process.wait(60.0)

    def _read(self, seconds: float) -> Optional[str]:
        """Read what is there; empty after so long a silence, None at the end."""
        if not select.select([self._master], [], [], seconds)[0]:
            return ""
        try:
            return os.read(self._master, 4096).decode().replace("\r\n", "\n") or None
        except OSError:
            return None


def answer(terminal: Terminal, lines: List[str]) -> None:
    for line in lines:
        terminal.type(line, ": ")


def test_application_is_asked_for_in_the_wizards_order(tmp_path: Path) -> None:
    terminal = Terminal(tmp_path, "new", "application")
    answer(terminal, [*PACKAGE, "nearest_robot", "2", "gate:report, shed"])
    assert terminal.finish() == 0, terminal.seen
    questions = ["workspace: ", "package: ", "name [Yard]: ", "version [1.0.0]: ", "description: ", "maintainer: "]
    questions += ["email: ", "license [BSD]: ", "run_depends: ", "architecture: ", "robots: ", "tasks: "]
    places = [terminal.seen.index(f"\n{question}") for question in questions]
    assert places == sorted(places)
    assert "Enter the maintainer's e-mail address.\nemail: " in terminal.seen
    tasks = yaml.safe_load((tmp_path / "yard" / "tasks.yaml").read_text())["tasks"]
    assert [(task["id"], task["kind"]) for task in tasks] == [("gate", "report"), ("shed", "go_to_place")]
    assert "<license>BSD</license>" in (tmp_path / "yard" / "package.xml").read_text()


def test_bad_answers_are_told_and_asked_again(tmp_path: Path) -> None:
    (tmp_path / "taken").mkdir()
    terminal = Terminal(tmp_path, "new", "architecture", "--description", "d", "--maintainer", "m")
    answer(terminal, ["", "", "my yard", "taken", "yard", "", "1.0", "2.0.0", "nobody", "a@b.c"])
    answer(terminal, ["", "no_such_package", "", "XX", "ST", "SR", "IA"])
    assert terminal.finish() == 0, terminal.seen
    for message in (
        "The package name must not be empty.",
        "The package name must not contain space characters.",
        "The given package [taken] already exists.",
        "must be three numbers joined by dots (got '1.0')",
        "The e-mail of the package maintainer must be given.",
        "'no_such_package' is no ROS package",
        "is not known (got 'XX'); accepted: ST, MT",
    ):
        assert message in terminal.seen
    assert "<version>2.0.0</version>" in (tmp_path / "yard" / "package.xml").read_text()


def test_ids_are_checked_as_they_are_typed(tmp_path: Path) -> None:
    terminal = Terminal(tmp_path, "new", "application")
    answer(terminal, [*PACKAGE, "nearest_robot", "a b", "r1,r1", "r1,r2", "0", "gate:flie", "1"])
    assert terminal.finish() == 0, terminal.seen
    for message in (
        "The robot id must not contain <space>.",
        "The robot id 'r1' is given twice.",
        "Enter the robot tasks.",
        "gate: no behaviour of kind 'flie' is registered",
    ):
        assert message in terminal.seen


def test_mandatory_parameters_are_asked_for_with_their_tool_tip(tmp_path: Path) -> None:
    (tmp_path / "needy").mkdir()
    (tmp_path / "needy" / "package.xml").write_text(MANIFEST)
    (tmp_path / "needy" / "rqt_mrta.xml").write_text(MANDATORY)
    terminal = Terminal(tmp_path, "new", "application")
    answer(terminal, [*PACKAGE, "needy", "2", "1", "", "fast", "0.3", "0.4"])
    assert terminal.finish() == 0, terminal.seen
    assert "Enter the speed [m/s].\nrobot1/speed: " in terminal.seen
    assert "The robot1/speed parameter value must be given, because it is mandatory." in terminal.seen
    assert "must be a finite number (got 'fast')" in terminal.seen
    given = [yaml.safe_load((tmp_path / f"yard/config/robot{n}_needs.yaml").read_text()) for n in (1, 2)]
    assert given == [{"speed": 0.3}, {"speed": 0.4}]


@pytest.mark.parametrize("key", [b"\x03", b"\x04"], ids=["Ctrl-C", "Ctrl-D"])
def test_leaving_leaves_nothing(tmp_path: Path, key: bytes) -> None:
    terminal = Terminal(tmp_path, "new", "application", "yard", "--workspace", "ws")
    terminal.press(key, "name [Yard]: ")
    if key == b"\x03" and not terminal.ends_within(1.0):
        # A terminal without a session leader of its own delivers no signal for the key.
        os.killpg(terminal.process.pid, signal.SIGINT)
    assert terminal.finish() == 130, terminal.seen
    assert "Traceback" not in terminal.seen
    assert list(tmp_path.iterdir()) == []


def test_nothing_is_asked_with_yes(tmp_path: Path) -> None:
    terminal = Terminal(tmp_path, "new", "application", "yard", "--yes")
    assert terminal.finish() == 2
    assert "mrta: --description: The package description must be given.\n" in terminal.seen
    assert "Enter the maintainer's" not in terminal.seen


def test_nothing_is_asked_where_nothing_is_missing(tmp_path: Path) -> None:
    about = ["--description", "d", "--maintainer", "m", "--email", "a@b.c", "--type", "ST-SR-IA"]
    terminal = Terminal(tmp_path, "new", "architecture", "yard", *about)
    assert terminal.finish() == 0, terminal.seen
    assert terminal.seen.startswith("A ROS package was created in: ")
