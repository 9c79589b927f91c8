"""What a supervisor takes up of a recording that broke off."""

from __future__ import annotations

from pathlib import Path
from typing import Mapping

import pytest

from rqt_mrta_py.app.compose import Host, compose
from rqt_mrta_py.app.live.resumption import ended_tasks, left_behind
from rqt_mrta_py.app.mission_message import mission_message
from rqt_mrta_py.config.mission import load_mission
from rqt_mrta_py.hooks import Outgoing, Stamped
from rqt_mrta_py.model import TaskState
from rqt_mrta_py.transport import BagWriter

WAITING, DONE, WITHDRAWN = 0, 3, 5


@pytest.fixture(scope="module")
def host() -> Host:
    return compose()


def test_what_is_taken_up_is_the_recording_right_before_if_it_broke_off(tmp_path: Path) -> None:
    assert left_behind(tmp_path / "all.bag") is None
    assert left_behind(tmp_path / "all-2.bag") is None
    (tmp_path / "all.bag.active").touch()
    (tmp_path / "all-9.bag.active").touch()
    assert left_behind(tmp_path / "all-2.bag") == tmp_path / "all.bag.active"
    assert left_behind(tmp_path / "all-3.bag") is None
    assert left_behind(tmp_path / "all-10.bag") == tmp_path / "all-9.bag.active"
    assert left_behind(tmp_path / "all-north.bag") is None


def recorded(host: Host, bag: Path, team: Mapping[str, int], after: Mapping[str, int]) -> Path:
    """Record the mission, the team's state at 2 s and what tasks became at 3 s."""
    mission = load_mission(host.registry, "border_patrol", seed=None)
    said = [(1, mission_message(mission, 1.0, 0.0))]
    tasks = [{"task_id": task, "state": state} for task, state in team.items()]
    said.append((2, Outgoing("/mrta/team_state", "rqt_mrta_py/TeamState", {"tasks": tasks})))
    for task, state in after.items():
        said.append((3, Outgoing("/mrta/task_state", "rqt_mrta_py/TaskState", {"task_id": task, "state": state})))
    codec = host.codec()
    with BagWriter(bag) as writer:
        for at, each in said:
            connection = codec.connection(each.topic, each.type, "/supervisor")
            writer.write(Stamped(connection, at * 10**9, codec.encode(each.type, each.fields)))
    return bag


def test_tasks_that_had_ended_are_read_to_the_last_message(host: Host, tmp_path: Path) -> None:
    bag = recorded(
        host,
        tmp_path / "left.bag",
        {"wander": DONE, "report": DONE},
        {"report": WAITING, "border_protection": WITHDRAWN},
    )
    mission = load_mission(host.registry, "border_patrol", seed=None)
    broke_off, ended = ended_tasks(bag, host.codec(), mission)
    assert broke_off == 3.0
    assert ended == [("wander", TaskState.DONE), ("border_protection", TaskState.WITHDRAWN)]


def test_of_another_mission_nothing_is_taken_up(host: Host, tmp_path: Path) -> None:
    bag = recorded(host, tmp_path / "left.bag", {"wander": DONE}, {})
    assert ended_tasks(bag, host.codec(), load_mission(host.registry, "cleanup", seed=None))[1] == []
