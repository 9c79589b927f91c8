"""What is measured of physics where a robot builds."""

from __future__ import annotations

import pytest

from rqt_mrta_py.app.cli.main import main


def test_idle_travelling_and_working_are_each_measured(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["bench", "physics", "--blocks", "9", "--seconds", "0.2"]) == 0
    text = capsys.readouterr().out
    assert "Physics of one builder and a wall of 9 blocks in the world bullet" in text
    rows = [line.split() for line in text.splitlines()[3:6]]
    assert [" ".join(row[:-2]) for row in rows] == ["idle", "travelling", "at work"]
    assert all(float(cell) > 0.0 for row in rows for cell in row[-2:])


@pytest.mark.parametrize(("option", "value"), [("--blocks", "1"), ("--seconds", "0"), ("--rate", "0")])
def test_what_cannot_be_measured_is_refused(capsys: pytest.CaptureFixture[str], option: str, value: str) -> None:
    assert main(["bench", "physics", option, value]) == 2
    assert "--blocks takes at least 2, --seconds a number above 0, --rate 1 to 1000" in capsys.readouterr().err
