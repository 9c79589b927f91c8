"""The rosrun stub, started with an interpreter that lacks the libraries."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import List

import pytest

from tests.bootstrap.conftest import program


@pytest.fixture
def checkout(root: Path, tmp_path: Path) -> Path:
    folder = tmp_path / "a checkout"
    shutil.copytree(root / "scripts", folder / "scripts", ignore=shutil.ignore_patterns("__pycache__"))
    return folder


def call(script: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    # -S hides every installed package; -E hides PYTHONPATH.
    command: List[str] = [sys.executable, "-E", "-S", str(script), *arguments]
    return subprocess.run(command, env=dict(os.environ), capture_output=True, text=True, check=False)


def test_stub_runs_itself_again_in_the_checkouts_environment(checkout: Path) -> None:
    program(checkout / ".venv/bin", "python", 'for word; do echo "<$word>"; done; exit 3')
    (checkout / ".venv/set-up").touch()
    result = call(checkout / "scripts/mrta", "list", "two words")
    assert result.stdout.splitlines() == [f"<{checkout}/scripts/mrta>", "<list>", "<two words>"]
    assert result.returncode == 3


def test_stub_runs_itself_again_in_the_virtual_environment_that_it_lies_in(checkout: Path) -> None:
    program(checkout / "bin", "python", 'for word; do echo "<$word>"; done; exit 3')
    (checkout / "pyvenv.cfg").touch()
    result = call(checkout / "scripts/mrta", "list")
    assert result.stdout.splitlines() == [f"<{checkout}/scripts/mrta>", "<list>"]
    assert result.returncode == 3


def test_stub_says_what_to_do_outside_of_a_checkout_that_was_set_up(checkout: Path) -> None:
    result = call(checkout / "scripts/mrta", "list")
    assert result.returncode == 4
    assert len(result.stderr.splitlines()) == 1
    assert result.stderr.endswith("install rqt_mrta_py[all], or call ./run in a checkout\n")


def test_stub_does_not_run_itself_again_for_ever(checkout: Path) -> None:
    subprocess.run([sys.executable, "-m", "venv", "--without-pip", str(checkout / ".venv")], check=True)
    (checkout / ".venv/set-up").touch()
    result = subprocess.run(
        [str(checkout / ".venv/bin/python"), "-E", str(checkout / "scripts/mrta")],
        capture_output=True,
        text=True,
        check=False,
        timeout=30,
    )
    assert result.returncode == 4


def test_stub_stays_where_it_is_when_nothing_is_lacking(root: Path) -> None:
    result = subprocess.run(
        [sys.executable, str(root / "scripts/mrta"), "--version"], capture_output=True, text=True, check=False
    )
    assert (result.returncode, result.stderr) == (0, "")
    assert "0.1.0" in result.stdout
