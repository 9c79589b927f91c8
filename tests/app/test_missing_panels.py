"""A widget that no plugin registers is told, once and in one line; the mission goes on without it."""

from __future__ import annotations

import logging
from dataclasses import replace

import pytest

from rqt_mrta_py.app.compose import Host
from rqt_mrta_py.app.observation import Observation
from rqt_mrta_py.config.discovery.search import discover
from rqt_mrta_py.hooks.manager import PluginManager
from tests.hooks.garden import MISSION
from tests.hooks.stranger import Stranger


def test_missing_panels_are_told_in_one_line(caplog: pytest.LogCaptureFixture) -> None:
    manager = PluginManager()
    stranger = Stranger()
    manager.register(stranger, "stranger")
    (known,) = stranger.mrta_register_monitor_panels()
    widgets = (known, "rqt_foreign/plugin", "rqt_foreign/other")
    mission = replace(MISSION, architecture=replace(MISSION.architecture, package="plan", widgets=widgets))
    codec = Host(discover({}, prefix="/nowhere", shares=(), distributions=()), manager, []).codec()

    with caplog.at_level(logging.WARNING, "rqt_mrta_py.app"):
        observation = Observation(mission, codec, manager, None)

    assert [record.getMessage() for record in caplog.records] == [
        "architecture=plan names panels that no plugin registers: rqt_foreign/plugin, rqt_foreign/other; "
        f"accepted: {known}"
    ]
    assert len(observation.view(1.0).panels) == 1
