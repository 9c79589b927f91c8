"""Ctrl-C ends a run or a review early with complete files and exit status 130."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any, Tuple

import pytest

from rqt_mrta_py.app.cli.main import main
from rqt_mrta_py.app.outputs import results
from rqt_mrta_py.transport import read_bag_info
from tests.app.outputs import Outputs

COMPLETE = {"dashboard.png", "events.jsonl", "incidents.jsonl", "monitor", "report.html", "run.log", "summary.json"}


def names(folder: Path) -> Any:
    return {path.name for path in folder.iterdir()}


def test_an_interrupted_run_leaves_complete_files(tmp_path: Path) -> None:
    folder = tmp_path / "run"
    command = [sys.executable, "-m", "rqt_mrta_py", "run", "border_patrol", "--out", str(folder)]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    third_picture = folder / "monitor" / "000002.000.png"
    patience = time.monotonic() + 60
    while not third_picture.exists() and time.monotonic() < patience:
        time.sleep(0.05)
    process.send_signal(signal.SIGINT)
    output, errors = process.communicate(timeout=60)
    assert process.returncode == 130
    assert errors == ""
    assert ", interrupted\n" in output
    summary = json.loads((folder / "summary.json").read_text())
    information = read_bag_info(folder / "mission.bag")
    assert information.end_ns == round(summary["time"]["end"] * 1e9)
    assert names(folder) == COMPLETE | {"mission.bag"}


@pytest.mark.parametrize("verb", ["run", "review"])
def test_an_interrupt_while_results_are_written_leaves_all_of_them(
    verb: str, short_patrol: Outputs, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Ctrl-C once left neither log nor dashboard, and at times no summary, when it came after the last tick."""
    write_picture = results.write_picture

    def interrupted_write_picture(*arguments: Any) -> None:
        os.kill(os.getpid(), signal.SIGINT)
        write_picture(*arguments)

    monkeypatch.setattr(results, "write_picture", interrupted_write_picture)
    folder = tmp_path / "out"
    what: Tuple[str, ...] = (
        ("border_patrol", "--duration", "1", "--processes", "1") if verb == "run" else (str(short_patrol.bag),)
    )
    assert main([verb, *what, "--pictures", "100", "--out", str(folder)]) == 130
    assert names(folder) == COMPLETE | (
        {"mission.bag"} if verb == "run" else {"clocks.json", "communication.json", "communication.png", "review.json"}
    )


def test_an_interrupt_before_anything_is_written_leaves_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def interrupted() -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("rqt_mrta_py.app.compose.registry_only", interrupted)
    folder = tmp_path / "out"
    assert main(["run", "border_patrol", "--out", str(folder)]) == 130
    assert capsys.readouterr().err == ""
    assert not folder.exists()
