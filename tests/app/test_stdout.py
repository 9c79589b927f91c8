"""Standard output may be a pipe whose reader goes, a full disk, or closed."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from typing import IO, Tuple, Union

import pytest

from tests.app.outputs import Outputs


def mrta(*arguments: str, stdout: Union[int, IO[bytes]], buffered: bool = True) -> Tuple[int, str]:
    """Run a command in a process of its own; gives its status and what it said on stderr."""
    environment = {**os.environ, "PYTHONUNBUFFERED": "" if buffered else "1"}
    command = [sys.executable, "-m", "rqt_mrta_py", *arguments]
    done = subprocess.run(command, check=False, stdout=stdout, stderr=subprocess.PIPE, env=environment, timeout=120)
    return done.returncode, done.stderr.decode()


def pipe_without_reader() -> IO[bytes]:
    reading, writing = os.pipe()
    os.close(reading)
    return os.fdopen(writing, "wb")


@pytest.mark.parametrize("buffered", [True, False])
@pytest.mark.parametrize("arguments", [("--help",), ("run", "--help"), ("list",), ("show", "border_patrol", "--json")])
def test_a_reader_who_has_gone_is_no_error(arguments: Tuple[str, ...], buffered: bool) -> None:
    with pipe_without_reader() as pipe:
        assert mrta(*arguments, stdout=pipe, buffered=buffered) == (0, "")


def test_a_reader_who_has_gone_hides_no_verdict(patrol: Outputs, tmp_path: Path) -> None:
    """``mrta review --json --fail-on error BAG | head -1`` under pipefail once passed with incidents."""
    arguments = ("review", str(patrol.bag), "--pictures", "0", "--fail-on", "error", "--out", str(tmp_path / "review"))
    with pipe_without_reader() as pipe:
        assert mrta(*arguments, "--json", stdout=pipe) == (1, "")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="this system has no /dev/full")
def test_a_full_disk_is_told() -> None:
    with Path("/dev/full").open("wb") as full:
        status, errors = mrta("list", stdout=full)
    assert (status, errors) == (3, "mrta: standard output: cannot be written: No space left on device\n")
