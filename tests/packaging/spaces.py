"""Catkin workspaces, and programs run in their environments."""

from __future__ import annotations

import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import List

import pytest

from tests.packaging.builds import clean_environment

MADE = {"fetch_first", "gate", "yard"}
"""The packages that mrta made in the workspace for all tests, beside those of this repository."""

PATH = f"{Path(sys.executable).parent}:/usr/bin:/bin"


@dataclass(frozen=True)
class Space:
    """A devel or install space of a workspace."""

    folder: Path

    def run(self, *command: str) -> str:
        """Run a program after sourcing the space's setup file; gives what it printed."""
        done = self.finished(*command)
        assert done.returncode == 0, done.stderr + done.stdout
        return done.stdout

    def finished(self, *command: str) -> subprocess.CompletedProcess[str]:
        """Run a program to its end, whatever that is."""
        home = self.folder.parent / "ros"
        script = f'. "{self.folder}/setup.sh" && exec "$@"'
        return subprocess.run(
            ["/bin/sh", "-c", script, "sh", *command],
            cwd=self.folder.parent,
            env=clean_environment(PATH=PATH, ROS_HOME=str(home), ROS_HOSTNAME="127.0.0.1"),
            capture_output=True,
            text=True,
            timeout=300,
            check=False,
        )


@dataclass(frozen=True)
class Workspace:
    """A catkin workspace, built and installed.

    Attributes:
        folder: of the workspace.
        log: what catkin_make printed.
    """

    folder: Path
    log: str

    @property
    def spaces(self) -> List[Space]:
        return [Space(self.folder / "devel"), Space(self.folder / "install")]


def need_catkin() -> None:
    """Skip the test where Debian's catkin or what it needs is missing, naming that."""
    programs = ("catkin_make", "cmake", "make", "g++", "rospack", "rosrun", "roslaunch", "rosmsg")
    missing = [program for program in programs if not Path("/usr/bin", program).exists()]
    if not Path("/usr/share/message_generation/cmake").exists():
        missing.append("message_generation")
    if missing:
        pytest.skip(f"no workspace can be built with Debian's catkin; not there: {', '.join(missing)}")


def catkin_make(folder: Path, prefix: str = "") -> Workspace:
    """Build and install the packages below src with the interpreter that runs the tests.

    Args:
        folder: the workspace.
        prefix: an install space to build upon.
    """
    settings = [f"-DPYTHON_EXECUTABLE={python_without_blanks(folder)}", f"-DCMAKE_INSTALL_PREFIX={folder}/install"]
    done = subprocess.run(
        ["catkin_make", "-C", str(folder), *settings, "install"],
        env=clean_environment(PATH=PATH, CMAKE_PREFIX_PATH=prefix, ROS_LANG_DISABLE="gencpp:genlisp"),
        capture_output=True,
        text=True,
        timeout=1200,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return Workspace(folder, done.stdout + done.stderr)


def python_without_blanks(folder: Path) -> Path:
    """Give the interpreter by a path without blanks, which catkin's scripts do not bear."""
    python = Path(sys.executable)
    if not any(character.isspace() for character in str(python)):
        return python
    link = folder / "environment"
    link.symlink_to(python.parent.parent, target_is_directory=True)
    return link / "bin" / python.name
