"""What behaviours are told when they are made."""

from __future__ import annotations

from typing import Dict

import pytest

from rqt_mrta_py.app.compose import Host, compose
from rqt_mrta_py.app.run.embedded import EmbeddedRun
from rqt_mrta_py.config.mission import load_mission
from rqt_mrta_py.hooks import BehaviourSetup

_TASKS = ["bottles", "cans", "report"]


@pytest.fixture
def host() -> Host:
    return compose()


def test_behaviours_know_the_team_and_all_tasks_of_their_robot(host: Host, monkeypatch: pytest.MonkeyPatch) -> None:
    mission = load_mission(host.registry, "cleanup")
    known = host.manager.registered("mrta_register_behaviours")
    setups: Dict[str, BehaviourSetup] = {}

    def spy(setup: BehaviourSetup) -> object:
        setups[setup.robot_id] = setup
        return known["collect"](setup)

    registered = host.manager.registered
    monkeypatch.setattr(
        host.manager,
        "registered",
        lambda hook: {**known, "collect": spy} if hook == "mrta_register_behaviours" else registered(hook),
    )
    EmbeddedRun(mission, 1.0, host.codec(), host.manager).close()
    assert setups["robot2"].team == ("robot1", "robot2", "robot3", "robot4", "robot5")
    assert [task.id for task in setups["robot2"].tasks] == _TASKS
