"""Plugins that break the contract, fail to import or raise: one line that names them."""

from __future__ import annotations

from pathlib import Path
from typing import List, Tuple

import pytest

from tests.app.outputs import Mrta


def short_run(mrta: Mrta) -> Tuple[int, List[str]]:
    return mrta("run", "border_patrol", "--duration", "1", "--pictures", "0", "--processes", "1")


def test_a_plugin_that_fails_to_import_is_reported_and_skipped(mrta: Mrta, stranger: Path) -> None:
    stranger.write_text("import a_library_that_nobody_has\n")
    status, lines = short_run(mrta)
    assert status == 0
    assert len(lines) == 1
    assert "stranger" in lines[0]
    assert "a_library_that_nobody_has" in lines[0]


def test_a_plugin_that_raises_where_its_answer_is_needed_stops_the_run(mrta: Mrta, stranger: Path) -> None:
    stranger.write_text(
        "from rqt_mrta_py.hooks import hookimpl\n\n\n"
        "@hookimpl\ndef mrta_register_statistics():\n    raise RuntimeError('no')\n"
    )
    status, lines = short_run(mrta)
    assert status == 3
    assert len(lines) == 1
    assert "stranger" in lines[0]
    assert "mrta_register_statistics" in lines[0]


def test_an_observer_that_raises_is_named_and_the_run_goes_on(
    mrta: Mrta, stranger: Path, caplog: pytest.LogCaptureFixture
) -> None:
    stranger.write_text(
        "from rqt_mrta_py.hooks import hookimpl\n\n\n"
        "@hookimpl\ndef mrta_on_event(event):\n    raise RuntimeError('no')\n"
    )
    status, lines = short_run(mrta)
    assert status == 0
    assert "stranger" in caplog.text
    assert "mrta_on_event" in caplog.text
    assert [line for line in lines if "Traceback" in line] == []


def test_a_plugin_with_an_unknown_argument_is_refused_with_both_signatures(mrta: Mrta, stranger: Path) -> None:
    stranger.write_text("from rqt_mrta_py.hooks import hookimpl\n\n\n@hookimpl\ndef mrta_on_event(evnt):\n    pass\n")
    status, lines = short_run(mrta)
    assert status == 3
    assert len(lines) == 1
    assert "stranger_plugin" in lines[0]
    assert "mrta_on_event(evnt)" in lines[0]
    assert "mrta_on_event(event)" in lines[0]


PANEL = """
from rqt_mrta_py.hooks import hookimpl


class Panel:
    def subscriptions(self):
        return [{subscriptions}]

    def hear(self, heard):
        raise RuntimeError("no")

    def view(self, start, end):
        raise RuntimeError("no")


@hookimpl
def mrta_register_monitor_panels():
    return {{"rqt_alliance/alliance_plugin": {factory}}}
"""


@pytest.mark.parametrize(
    ("factory", "subscriptions"),
    [
        ("lambda setup: Panel()", ""),
        ("lambda setup: Panel()", "nothing_of_this_name"),
        ("lambda setup: Panel().view(0, 0)", ""),
    ],
    ids=["view", "subscriptions", "factory"],
)
def test_a_monitor_panel_that_raises_stops_the_run_by_name(
    mrta: Mrta, stranger: Path, factory: str, subscriptions: str
) -> None:
    stranger.write_text(PANEL.format(factory=factory, subscriptions=subscriptions))
    status, lines = mrta("run", "border_patrol", "--duration", "1")
    assert status == 3
    assert len(lines) == 1
    assert "monitor panel rqt_alliance/alliance_plugin: " in lines[0]


def test_a_renderer_that_raises_stops_the_run_by_name(mrta: Mrta, stranger: Path) -> None:
    stranger.write_text(
        "from rqt_mrta_py.hooks import hookimpl\n\n\n"
        "def draw(view):\n    raise RuntimeError('no')\n\n\n"
        "@hookimpl\ndef mrta_register_renderers():\n    return {'monitor': draw}\n"
    )
    status, lines = mrta("run", "border_patrol", "--duration", "1")
    assert status == 3
    assert lines == ["mrta: renderer monitor: RuntimeError: no"]
