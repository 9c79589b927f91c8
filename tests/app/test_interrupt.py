"""Ctrl-C ends a run early with complete files and exit status 130."""

from __future__ import annotations

import json
import signal
import subprocess
import sys
import time
from pathlib import Path

from rqt_mrta_py.transport import read_bag_info


def test_an_interrupted_run_leaves_complete_files(tmp_path: Path) -> None:
    folder = tmp_path / "run"
    command = [sys.executable, "-m", "rqt_mrta_py", "run", "border_patrol", "--out", str(folder)]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    third_picture = folder / "monitor" / "000002.00.png"
    patience = time.monotonic() + 60
    while not third_picture.exists() and time.monotonic() < patience:
        time.sleep(0.05)
    process.send_signal(signal.SIGINT)
    _, errors = process.communicate(timeout=60)
    assert process.returncode == 130
    assert errors == ""
    summary = json.loads((folder / "summary.json").read_text())
    information = read_bag_info(folder / "mission.bag")
    assert information.end_ns == round(summary["time"]["end"] * 1e9)
    assert not (folder / "mission.bag.active").exists()
    assert (folder / "dashboard.png").exists()
