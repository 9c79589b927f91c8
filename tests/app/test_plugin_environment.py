"""What the environment says of plugins: traced, blocked, hurried."""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import Any, Dict

import pytest

from rqt_mrta_py.app.compose import compose
from rqt_mrta_py.app.loading.environment import PluginSettings, plugin_settings
from rqt_mrta_py.errors import UsageError
from tests.app.outputs import Mrta

OBSERVER = "from rqt_mrta_py.hooks import hookimpl\n\n\n@hookimpl\ndef mrta_on_event(event):\n    pass\n"


@pytest.mark.parametrize(
    ("environ", "settings"),
    [
        ({}, PluginSettings()),
        ({"RQT_MRTA_PY_TRACE_HOOKS": "1"}, PluginSettings(trace=True)),
        ({"RQT_MRTA_PY_TRACE_HOOKS": "0"}, PluginSettings()),
        ({"RQT_MRTA_PY_BLOCK_PLUGINS": " a, b.c,,a "}, PluginSettings(blocked=("a", "b.c"))),
        ({"RQT_MRTA_PY_PATIENCE": "0"}, PluginSettings(patience=0.0)),
        ({"RQT_MRTA_PY_PATIENCE": "2.5"}, PluginSettings(patience=2.5)),
    ],
)
def test_settings_are_read_from_the_environment(environ: Dict[str, str], settings: PluginSettings) -> None:
    assert plugin_settings(environ) == settings


@pytest.mark.parametrize("text", ["soon", "-1", "nan", "inf", "1e7", "1 s"])
def test_a_patience_that_makes_no_sense_is_wrong_usage(text: str) -> None:
    with pytest.raises(UsageError) as caught:
        plugin_settings({"RQT_MRTA_PY_PATIENCE": text})

    assert str(caught.value) == (f"RQT_MRTA_PY_PATIENCE: {text!r} is no number of seconds from 0 (no limit) to 1000000")


def test_a_switch_that_makes_no_sense_is_wrong_usage(mrta: Mrta, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RQT_MRTA_PY_TRACE_HOOKS", "yes")

    assert mrta("bench") == (2, ["mrta: RQT_MRTA_PY_TRACE_HOOKS: 'yes' is neither 1 nor 0"])


@pytest.mark.parametrize("name", ["stranger", "stranger_plugin"])
def test_a_blocked_plugin_is_neither_imported_nor_registered(
    stranger: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture, name: str
) -> None:
    stranger.write_text("raise RuntimeError('imported')\n")
    monkeypatch.setenv("RQT_MRTA_PY_BLOCK_PLUGINS", name)

    host = compose()

    assert "stranger_plugin" not in host.manager.names
    assert "stranger_plugin" not in sys.modules
    assert (host.problems, caplog.messages) == ([], [])


def test_a_package_is_blocked_with_every_module_below_it(monkeypatch: pytest.MonkeyPatch) -> None:
    assert "mrta_alliance.plugin" in compose().manager.names
    monkeypatch.setenv("RQT_MRTA_PY_BLOCK_PLUGINS", "mrta_alliance,basic_behaviours.plugin")

    assert {"mrta_alliance.plugin", "basic_behaviours.plugin"}.isdisjoint(compose().manager.names)


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("mrta_alianc", "mrta_alianc is no plugin's module or package; nearest is 'mrta_alliance'"),
        ("rqt_mrta_py", "rqt_mrta_py belongs to this project itself and cannot be blocked"),
        ("rqt_mrta_py.sim.plugin", "rqt_mrta_py.sim.plugin belongs to this project itself and cannot be blocked"),
    ],
)
def test_a_name_that_blocks_nothing_is_a_warning(
    monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture, name: str, message: str
) -> None:
    unblocked = compose().manager.names
    monkeypatch.setenv("RQT_MRTA_PY_BLOCK_PLUGINS", name)

    assert compose().manager.names == unblocked
    assert caplog.messages == [f"RQT_MRTA_PY_BLOCK_PLUGINS: {message}"]


def test_hook_calls_are_traced_to_stderr_a_line_each_without_asking_for_more_logs(
    mrta: Mrta, stranger: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    stranger.write_text(OBSERVER)
    monkeypatch.setenv("RQT_MRTA_PY_TRACE_HOOKS", "1")

    status, lines = mrta("run", "border_patrol", "--duration", "1", "--pictures", "0", "--processes", "1")

    assert status == 0
    form = r"rqt_mrta_py\.hooks\.trace: at_ms=\d+\.\d{3} plugin=(\S+) hook=(\w+) took_ms=\d+\.\d{3} returned=(.*)"
    matches = [re.fullmatch(form, line) for line in lines]
    assert None not in matches
    calls: Any = [match.groups() for match in matches if match]
    assert ("rqt_mrta_py.robot.plugin", "mrta_register_planners", "{astar}") in calls
    assert calls.count(("stranger_plugin", "mrta_on_event", "None")) >= 5
    asked = [call[:2] for call in calls if call[1].startswith("mrta_register_")]
    assert sorted(set(asked)) == sorted(asked)


def test_a_plugin_that_takes_for_ever_to_import_is_reported_and_skipped(
    mrta: Mrta, stranger: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    stranger.write_text("import time\n\nwhile True:\n    time.sleep(0.01)\n")
    monkeypatch.setenv("RQT_MRTA_PY_PATIENCE", "0.5")

    status, lines = mrta("bench")

    assert (status, len(lines)) == (0, 1)
    place = rf"in <module> \({re.escape(str(stranger))}:4\)"
    assert re.search(rf"'stranger_plugin' cannot be imported: .*no answer within 0\.5 s; interrupted {place}", lines[0])
