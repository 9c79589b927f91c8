"""Scenarios whose radio is not perfect: it is simulated on the embedded bus alone, and nodes refuse them."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Dict, Tuple

import pytest

from rqt_mrta_py.app.cli.main import main
from rqt_mrta_py.app.compose import compose
from rqt_mrta_py.app.live.mission_parameters import live_mission
from rqt_mrta_py.app.run.choice import MissionChoice
from rqt_mrta_py.errors import UsageError
from tests.ros.live_team import patrol_in

RADIOS: Dict[str, Tuple[str, str, str]] = {
    "loss": ("radio: {kind: lossy, loss: 0.1}\n", "", "the radio 'lossy'"),
    "delay": ("radio: {kind: lossy, delay: 0.2}\n", "", "the radio 'lossy'"),
    "failure": ("", "  - {time: 1, kind: radio_fails, robot: robot1}\n", "the event 'radio_fails'"),
    "partition": (
        "",
        "  - {time: 1, kind: radio_partitions, parameters: {groups: [[robot1], [robot2]]}}\n",
        "the event 'radio_partitions'",
    ),
    "both": (
        "radio: {kind: lossy, loss: 0.1}\n",
        "  - {time: 1, kind: radio_changes, parameters: {kind: perfect}}\n",
        "the radio 'lossy' and the event 'radio_changes'",
    ),
}


def patrol(folder: Path, name: str) -> Path:
    radio, events, _ = RADIOS[name]
    package = patrol_in(folder, events or "  - {time: 1, kind: robot_stops, robot: robot1}\n")
    scenario = package / "scenario.yaml"
    scenario.write_text(radio + scenario.read_text())
    return package


@pytest.mark.parametrize("name", RADIOS)
@pytest.mark.parametrize("lock_step", [[], ["--lock-step"]], ids=["free", "lock step"])
def test_run_of_nodes_refuses_it_by_name_before_anything_is_started_or_written(
    name: str, lock_step: Any, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    package, out = patrol(tmp_path, name), tmp_path / "out"
    assert main(["run", str(package), "--ros", *lock_step, "--out", str(out), "-q"]) == 2
    said = capsys.readouterr()
    assert said.out == ""
    (line,) = said.err.splitlines()
    assert line == (
        f"mrta: border_patrol: its scenario has {RADIOS[name][2]}, and the radio between robots is simulated on the "
        "embedded bus only; run it without --ros, or take that out of the scenario"
    )
    assert not out.exists()


def test_nodes_refuse_it_too(tmp_path: Path) -> None:
    package = patrol(tmp_path, "loss")
    with pytest.raises(UsageError, match="its scenario has the radio 'lossy'") as refusal:
        live_mission(lambda namespace: {}, compose(), MissionChoice(str(package)))
    assert refusal.value.exit_code == 2


def test_one_process_takes_the_same_scenario(tmp_path: Path) -> None:
    package = patrol(tmp_path, "both")
    assert (
        main(["run", str(package), "--duration", "1.5", "--pictures", "0", "--out", str(tmp_path / "out"), "-q"]) == 0
    )


def test_help_says_so(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        main(["run", "--help"])
    assert "a scenario whose radio is not perfect is refused" in " ".join(capsys.readouterr().out.split())
