"""``--figures``: what is told before a mission begins."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Tuple

import pytest

from tests.app.cli.conftest import Command

MAKER = """
from rqt_mrta_py.hooks import hookimpl


class Maker:
    def __init__(self, setup):
        pass

    def subscriptions(self):
        return ()

    def hear(self, heard):
        pass

    def figures(self, record):
        return ()


@hookimpl
def mrta_register_figures():
    return {"nothing": Maker}
"""


@pytest.mark.parametrize(
    ("names", "message"),
    [
        (("--figures", "motives"), "mrta: --figures motives: there are no such figures; there are: alliance, nothing"),
        (
            ("--figures", "nothing, motives"),
            "mrta: --figures motives: there are no such figures; there are: alliance, nothing",
        ),
        (
            ("--figures", "nothing,"),
            "mrta run: argument --figures: 'nothing,': names separated by commas are expected; see mrta run --help",
        ),
    ],
)
def test_figures_that_nobody_makes_are_told_before_anything_is_written(
    command: Command, stranger: Path, names: Tuple[str, ...], message: str
) -> None:
    stranger.write_text(MAKER)

    told = command("run", "border_patrol", *names)

    assert (told.status, told.out, told.err.splitlines()[-1]) == (2, "", message)
    assert not Path("runs").exists()


def test_a_missing_library_is_told_before_the_mission(
    command: Command, stranger: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    stranger.write_text(MAKER)
    monkeypatch.setitem(sys.modules, "matplotlib.figure", None)

    told = command("run", "border_patrol", "--figures", "nothing")

    assert told.status == 4
    assert "install 'matplotlib>=3.6,<4', or rqt_mrta_py with its extra [plot]" in told.err
    assert not Path("runs").exists()


def test_figures_of_nothing_are_said_to_be_none(
    command: Command, stranger: Path, caplog: pytest.LogCaptureFixture
) -> None:
    stranger.write_text(MAKER)

    flags = ("--world", "planar", "--duration", "0.5", "--pictures", "0", "--processes", "1")
    told = command("run", "border_patrol", *flags, "--figures", "nothing,nothing", "--out", "out")

    assert told.status == 0
    assert "figures=nothing nothing heard of what they show, so there are none" in caplog.messages
    assert not Path("out/figures").exists()
