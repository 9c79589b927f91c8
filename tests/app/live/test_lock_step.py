"""A team whose messages take any time to arrive does exactly what it does in one process."""

from __future__ import annotations

import dataclasses
from typing import Dict, Iterable, List, Sequence, Tuple

import pytest

from rqt_mrta_py.app.compose import Host, compose
from rqt_mrta_py.app.run.embedded import EmbeddedRun
from rqt_mrta_py.app.run.ending import MissionEnd
from rqt_mrta_py.config.mission import load_mission
from rqt_mrta_py.hooks import Stamped
from rqt_mrta_py.model import Mission, Progress, ScenarioEvent, ScenarioEventKind
from tests.app.live.scattered_team import ScatteredTeam

EVENTS: Sequence[Tuple[float, ScenarioEventKind, str, str, Dict[str, float]]] = (
    (0.5, ScenarioEventKind.ROBOT_STOPS, "robot2", "", {}),
    (0.8, ScenarioEventKind.ROBOT_CLOCK_SHIFTS, "robot1", "", {"offset": 2.0}),
    (1.2, ScenarioEventKind.TASK_WITHDRAWN, "", "wander", {}),
    (1.5, ScenarioEventKind.ROBOT_RETURNS, "robot2", "", {}),
    (1.5, ScenarioEventKind.TASK_REASSIGNED, "robot2", "report", {}),
    (2.0, ScenarioEventKind.ROBOT_CLOCK_SHIFTS, "robot1", "", {"offset": 0.0}),
)


@pytest.fixture(scope="module")
def host() -> Host:
    return compose()


def troubled(mission: Mission) -> Mission:
    """Let things happen soon to the first robots of border_patrol, in a world that costs little."""
    events = tuple(
        ScenarioEvent(time, kind, robot or None, task or None, parameters)
        for time, kind, robot, task, parameters in EVENTS
    )
    assert mission.scenario is not None
    return dataclasses.replace(mission, scenario=dataclasses.replace(mission.scenario, world="planar", events=events))


def one_process(host: Host, mission: Mission) -> List[Stamped]:
    """Run a mission as on the embedded bus; give everything that is said."""
    said: List[Stamped] = []
    run = EmbeddedRun(mission, 2.5, host.codec(), host.manager)
    run.bus.tap(said.extend)
    for tick in range(run.last_tick + 1):
        run.step(tick)
        if run.is_over(tick):
            break
    run.close()
    return said


def loaded(host: Host, application: str, architecture: str) -> Mission:
    kinds = host.manager.registered("mrta_register_behaviours")
    mission = load_mission(host.registry, application, architecture, seed=3, checks=host.manager, kinds=kinds)
    return troubled(mission) if application == "border_patrol" else mission


@pytest.mark.parametrize(
    ("application", "architecture"),
    [("border_patrol", "mrta_alliance"), ("border_patrol", "mrta_l_alliance"), ("target_visiting", "mrta_demir_cf")],
)
def test_every_message_of_a_scattered_team_is_that_of_a_run_in_one_process(
    host: Host, application: str, architecture: str
) -> None:
    mission = loaded(host, application, architecture)
    codec = host.codec()
    expected = one_process(host, mission)
    team = ScatteredTeam(mission, 2.5, codec, host.manager, chance=1)
    found = list(team.run())
    team.close()
    assert [(each.connection.caller, each.connection.topic) for each in found] == [
        (each.connection.caller, each.connection.topic) for each in expected
    ]
    assert [(each.receipt_ns, each.raw) for each in found] == [(each.receipt_ns, each.raw) for each in expected]


@pytest.mark.parametrize(
    ("application", "architecture"), [("border_patrol", "mrta_alliance"), ("target_visiting", "mrta_demir_cf")]
)
def test_where_nobody_waits_all_say_the_same_if_nothing_comes_a_tick_late(
    host: Host, application: str, architecture: str
) -> None:
    mission = loaded(host, application, architecture)
    team = ScatteredTeam(mission, 2.5, host.codec(), host.manager, chance=2, lock_step=False)
    found = by_topic(team.run_freely())
    team.close()
    expected = by_topic(one_process(host, mission))
    assert found.keys() == expected.keys()
    for key, said in expected.items():
        assert found[key] == said, key


def by_topic(said: Iterable[Stamped]) -> Dict[Tuple[str, str], List[bytes]]:
    found: Dict[Tuple[str, str], List[bytes]] = {}
    for stamped in said:
        found.setdefault((stamped.connection.caller, stamped.connection.topic), []).append(stamped.raw)
    return found


def ending_early(mission: Mission) -> Mission:
    """Let an operator withdraw the only task that ends by itself, at 1.2 s, after a robot was taken away."""
    assert mission.scenario is not None
    tasks = tuple(dataclasses.replace(task, perpetual=task.id != "wander") for task in mission.tasks)
    removal = ScenarioEvent(1.0, ScenarioEventKind.ROBOT_REMOVED, "robot5")
    scenario = dataclasses.replace(mission.scenario, linger=0.5, events=(*mission.scenario.events, removal))
    return dataclasses.replace(mission, tasks=tasks, scenario=scenario)


def test_the_end_of_a_mission_hears_once_of_each_order_about_a_task_and_of_no_other_order(
    host: Host, monkeypatch: pytest.MonkeyPatch
) -> None:
    ordered: List[Tuple[str, Progress, float]] = []
    take_in = MissionEnd.take_in

    def record(end: MissionEnd, task: str, code: int, stamp: float) -> None:
        progress = Progress.of_code(code)
        if progress in (Progress.WITHDRAWN, Progress.REASSIGNED):
            ordered.append((task, progress, stamp))
        take_in(end, task, code, stamp)

    monkeypatch.setattr(MissionEnd, "take_in", record)
    one_process(host, ending_early(loaded(host, "border_patrol", "mrta_alliance")))
    # The mission's clock begins at 1 s.
    assert ordered == [("wander", Progress.WITHDRAWN, 2.2), ("report", Progress.REASSIGNED, 2.5)]


def test_a_scattered_team_ends_at_the_tick_at_which_one_in_one_process_does(host: Host) -> None:
    mission = ending_early(loaded(host, "border_patrol", "mrta_alliance"))
    codec = host.codec()
    expected = one_process(host, mission)
    team = ScatteredTeam(mission, 2.5, codec, host.manager, chance=1)
    found = list(team.run())
    team.close()
    assert max(each.receipt_ns for each in expected) == 2_700_000_000
    assert [(each.receipt_ns, each.raw) for each in found] == [(each.receipt_ns, each.raw) for each in expected]
