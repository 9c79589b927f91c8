"""The command with all that it says."""

from __future__ import annotations

from pathlib import Path
from typing import Callable, NamedTuple

import pytest

from rqt_mrta_py.app.cli.main import main


class Told(NamedTuple):
    """What a command says: its exit status, standard output, standard error."""

    status: int
    out: str
    err: str


Command = Callable[..., Told]


@pytest.fixture
def command(capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Command:
    """Run a command in an empty folder."""
    folder = tmp_path / "here"
    folder.mkdir()
    monkeypatch.chdir(folder)

    def run(*arguments: str) -> Told:
        try:
            status = main(list(arguments))
        except SystemExit as stop:
            status = int(stop.code or 0)
        return Told(status, *capsys.readouterr())

    return run
