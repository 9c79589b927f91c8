"""The watching side of a run in a process of its own: what is left when something goes wrong on either side."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Dict, List

import pytest

from rqt_mrta_py.app.run import watch_process
from rqt_mrta_py.transport import read_bag, read_bag_info
from tests.app.outputs import Mrta

MANIFEST = """<package format="3">
  <name>stranger</name> <version>0.1.0</version> <description>d</description>
  <maintainer email="a@b.c">m</maintainer> <license>l</license>
  <exec_depend>rqt_mrta_py</exec_depend>
  <export> <rqt_mrta_py plugin="stranger_plugin"/> </export>
</package>
"""

RULE = """
from rqt_mrta_py.hooks import Subscription, hookimpl

class Rule:
    def __init__(self, setup):
        pass
    def subscriptions(self):
        return [Subscription("/clock")]
    def hear(self, heard, board):
        if heard.receipt > 2.0:
            {deed}
    def notice(self, fact, board):
        pass
    def wake(self, time, board):
        pass
    def finish(self, time, board):
        pass

@hookimpl
def mrta_register_incident_rules():
    return {{"touchy": Rule}}
"""


def start(folder: Path, *arguments: str, deed: str = "", processes: str = "2") -> subprocess.Popen[str]:
    """Run border_patrol in a process of its own, with a rule that does something a second after the start."""
    environment: Dict[str, str] = dict(os.environ)
    if deed:
        source = folder / "packages" / "stranger" / "src"
        source.mkdir(parents=True)
        (source.parent / "package.xml").write_text(MANIFEST)
        (source / "stranger_plugin.py").write_text(RULE.format(deed=deed))
        environment["ROS_PACKAGE_PATH"] = str(folder / "packages")
    command = [sys.executable, "-m", "rqt_mrta_py", "run", "border_patrol", "--out", str(folder / "out"), *arguments]
    return subprocess.Popen(
        [*command, "--processes", processes],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env=environment,
        cwd=str(folder),
    )


def ended(run: subprocess.Popen[str]) -> List[str]:
    """Wait for the end; give the lines on stderr."""
    return run.communicate(timeout=120)[1].splitlines()


def watcher_of(run: subprocess.Popen[str]) -> int:
    """Give the process number of the watching side, once there is one."""
    children = Path(f"/proc/{run.pid}/task/{run.pid}/children")
    patience = time.monotonic() + 60
    while time.monotonic() < patience:
        found = children.read_text().split()
        if found:
            return int(found[0])
        time.sleep(0.02)
    raise AssertionError("no process was started")


def wait_for(path: Path) -> None:
    patience = time.monotonic() + 60
    while not path.exists() and time.monotonic() < patience:
        time.sleep(0.02)
    assert path.exists()


def test_a_failure_of_the_watching_side_is_told_as_if_there_were_one_process(tmp_path: Path) -> None:
    told = []
    for processes in ("1", "2"):
        folder = tmp_path / processes
        folder.mkdir()
        run = start(
            folder, "--duration", "20", "--pictures", "0", deed="raise RuntimeError('ouch')", processes=processes
        )
        told.append((ended(run), run.returncode))
        bag = read_bag_info(folder / "out" / "mission.bag")
        assert bag.end_ns == 2_050_000_000, "the bag is complete up to the tick at which the rule raised"
    assert told[1] == told[0]
    (line,), status = told[0]
    assert status == 3
    assert "touchy" in line
    assert "ouch" in line


def test_a_tick_handed_over_piece_by_piece_is_watched_as_one(
    mrta: Mrta, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # Pieces of a real size take a team of hundreds.
    monkeypatch.setattr(watch_process, "_PIECE_SIZE", 100)
    sent: List[bytes] = []
    send = watch_process.WatchProcess._send

    def spy(process: watch_process.WatchProcess, message: bytes) -> None:
        sent.append(message)
        send(process, message)

    monkeypatch.setattr(watch_process.WatchProcess, "_send", spy)
    for processes in ("1", "2"):
        mission = ("--duration", "3", "--pictures", "1", "--out", str(tmp_path / processes))
        status, _ = mrta("run", "border_patrol", *mission, "--processes", processes)
        assert status == 0
    assert sent.count(b"more") > 3 * 20, "several pieces a tick"
    one, two = (tmp_path / "1" / "mission.bag").read_bytes(), (tmp_path / "2" / "mission.bag").read_bytes()
    assert two == one


def test_a_watching_side_that_is_killed_is_told_in_one_line(tmp_path: Path) -> None:
    run = start(tmp_path, "--duration", "600", "--pictures", "0")
    watcher = watcher_of(run)
    wait_for(tmp_path / "out" / "mission.bag.active")
    os.kill(watcher, signal.SIGKILL)
    (line,) = ended(run)
    assert run.returncode == 3
    assert "status -9" in line
    assert "--processes 1" in line


def test_a_team_side_that_is_killed_leaves_the_bag_open_with_all_that_was_told(tmp_path: Path) -> None:
    run = start(tmp_path, "--duration", "600")
    watcher = watcher_of(run)
    wait_for(tmp_path / "out" / "monitor" / "000001.000.png")
    run.kill()
    assert run.communicate(timeout=30)[1] == ""
    patience = time.monotonic() + 30
    while Path(f"/proc/{watcher}").exists() and time.monotonic() < patience:
        time.sleep(0.02)
    assert not Path(f"/proc/{watcher}").exists()
    assert (tmp_path / "out" / "mission.bag.active").exists()
    assert not (tmp_path / "out" / "mission.bag").exists()
    assert not (tmp_path / "out" / "summary.json").exists()


def test_a_team_that_hears_the_supervisor_takes_turns_with_it_in_one_process(tmp_path: Path) -> None:
    """Whoever listens to the supervisor must hear it at the same tick, however the run is shared out."""
    source = tmp_path / "packages" / "stranger" / "src"
    source.mkdir(parents=True)
    (source.parent / "package.xml").write_text(MANIFEST)
    (source / "stranger_plugin.py").write_text(LISTENING_AGENT)
    environment = {**os.environ, "ROS_PACKAGE_PATH": str(tmp_path / "packages")}
    bags = []
    for processes in ("1", "2"):
        out = tmp_path / f"out{processes}"
        command = [sys.executable, "-m", "rqt_mrta_py", "run", "border_patrol", "--out", str(out), "--duration", "3"]
        subprocess.run(
            [*command, "--pictures", "0", "-q", "--processes", processes], check=True, env=environment, timeout=120
        )
        assert "processes 1\n" in (out / "run.log").read_text()
        echoes = [stamped.raw[4:] for stamped in read_bag(out / "mission.bag", topics=["/robot1/echo"])]
        assert len(echoes) == 3
        assert set(echoes) == {b"5 robots are known"}
        bags.append((out / "mission.bag").read_bytes())
    assert bags[1] == bags[0]


LISTENING_AGENT = """
from rqt_mrta_py.hooks import Decision, Outgoing, Subscription, hookimpl

class Agent:
    rate = 10.0
    def __init__(self, setup):
        pass
    def subscriptions(self):
        return [Subscription("/mrta/team_state", "rqt_mrta_py/TeamState", ("robots",))]
    def step(self, situation):
        says = [
            Outgoing("echo", "std_msgs/String", {"data": f"{len(heard.fields['robots'])} robots are known"})
            for heard in situation.heard
        ]
        return Decision(None, says)

@hookimpl
def mrta_register_agents():
    return {"mrta_alliance": Agent}
"""
