"""The generator of missions: what depends on seeds, and that each fault happens."""

from __future__ import annotations

from pathlib import Path
from typing import Dict, List, Tuple

import pytest

from rqt_mrta_py.app.bench.experiments import ExperimentMissions
from rqt_mrta_py.app.bench.incidents.calm import CalmMission
from rqt_mrta_py.app.bench.incidents.campaign import Campaign, chance
from rqt_mrta_py.app.bench.incidents.fault import Fault, Place, Strike
from rqt_mrta_py.app.bench.incidents.faults import FAULTS, RULES, faults_for
from rqt_mrta_py.app.bench.incidents.harmless import harmless_missions
from rqt_mrta_py.app.bench.incidents.measuring import PROOF_SEED, TUNING_SEED
from rqt_mrta_py.app.bench.incidents.setting import NEAREST_ROBOT, Setting
from rqt_mrta_py.app.bench.incidents.yards import YardKind, write_yard
from rqt_mrta_py.app.bench.trial import carry_out
from rqt_mrta_py.app.compose import Host, compose
from rqt_mrta_py.app.observation import pace_for
from rqt_mrta_py.app.run.embedded import EmbeddedRun
from rqt_mrta_py.hooks import Experiment
from rqt_mrta_py.transport import Batch

Said = List[Tuple[int, str, bytes]]


@pytest.fixture(scope="module")
def host() -> Host:
    return compose()


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("yards")


@pytest.fixture(scope="module")
def calm(host: Host, folder: Path) -> Dict[Tuple[YardKind, str], CalmMission]:
    """Carry a mission of each kind out under an architecture whose agents cost little."""
    found = {}
    for kind in YardKind:
        setting = Setting(kind, NEAREST_ROBOT, TUNING_SEED)
        experiment = setting.experiment(folder)
        mission, duration = ExperimentMissions(host).prepare(experiment)
        record = carry_out(host, experiment, mission, duration).record
        found[kind, NEAREST_ROBOT] = CalmMission(setting, experiment, mission, pace_for(mission, host.manager), record)
    return found


def files(package: str) -> Dict[str, str]:
    return {path.name: path.read_text() for path in Path(package).iterdir()}


@pytest.mark.parametrize("kind", YardKind)
def test_a_yard_depends_on_its_kind_and_seed_alone(kind: YardKind, tmp_path: Path) -> None:
    first = files(write_yard(tmp_path / "a", kind, 7))

    assert files(write_yard(tmp_path / "b", kind, 7)) == first
    assert files(write_yard(tmp_path / "b", kind, 8))["scenario.yaml"] != first["scenario.yaml"]


def test_every_rule_has_a_fault_and_every_fault_a_rule() -> None:
    """The fifteen of docs/incidents.md."""
    assert len(RULES) == 15
    assert set(compose().manager.registered("mrta_register_incident_rules")) >= set(RULES)
    assert {fault.place for fault in FAULTS} == set(Place)
    assert len({fault.name for fault in FAULTS}) == len(FAULTS)


@pytest.mark.parametrize("rule", RULES)
def test_each_rule_has_as_many_missions_as_asked_for(rule: str) -> None:
    counts = Campaign(RULES, PROOF_SEED, 30).counts
    assert sum(counts[fault] for fault in faults_for(rule)) >= 30


def test_a_campaign_of_one_rule_has_the_faults_of_that_rule_alone() -> None:
    assert {fault.name: count for fault, count in Campaign(("topic_gap",), 1, 5).counts.items()} == {
        "idle_robot_stops": 3,
        "silent_topic": 3,
    }


def test_seeds_of_the_proof_and_of_tuning_are_apart() -> None:
    most = max(setting.seed for fault in FAULTS for setting in Campaign(fault.rules, TUNING_SEED, 1000).settings(fault))
    assert TUNING_SEED < most < PROOF_SEED


def test_harmless_missions_come_under_every_trouble_yard_and_architecture(tmp_path: Path) -> None:
    names = [mission.name for mission in harmless_missions(tmp_path, range(1, 36))]
    troubled = {(name.split(",")[0], name.split(": ")[1]) for name in names if ": " in name}

    assert len(names) == len(set(names)) == 35 + 2 * 15
    assert len(troubled) == 35


@pytest.mark.parametrize("fault", FAULTS, ids=lambda fault: fault.name)
def test_a_fault_strikes_the_same_mission_in_the_same_way(
    fault: Fault, calm: Dict[Tuple[YardKind, str], CalmMission]
) -> None:
    mission = calm[fault.kind, NEAREST_ROBOT]
    first, again = (fault.strike(mission, chance(fault, mission.setting)) for _ in range(2))

    assert first == again
    if first is not None:
        assert {label.rule for label in first.labels} == set(fault.rules)
        assert all(1.0 <= label.start <= label.end for label in first.labels)
        assert first.events or first.agents


@pytest.mark.parametrize(
    "fault", [fault for fault in FAULTS if NEAREST_ROBOT in fault.architectures], ids=lambda fault: fault.name
)
def test_a_mission_with_a_fault_is_the_calm_one_until_it_strikes_and_not_after(
    fault: Fault, calm: Dict[Tuple[YardKind, str], CalmMission], host: Host
) -> None:
    mission = calm[fault.kind, NEAREST_ROBOT]
    strike = struck(fault, mission)
    until = min(max(label.start for label in strike.labels) + 15.0, mission.end - 1.0)
    before = stream(host, mission.experiment, until)
    after = stream(host, strike.applied(mission.experiment), until)

    differs = next(number for number, (one, other) in enumerate(zip(before, after)) if one != other)
    assert after[differs][0] / 1e9 <= until


def struck(fault: Fault, mission: CalmMission) -> Strike:
    """Let a fault strike a mission, with the first chance under which it can."""
    for seed in range(50):
        strike = fault.strike(mission, chance(fault, mission.setting._replace(seed=seed)))
        if strike is not None:
            return strike
    raise AssertionError(f"{fault.name} finds nothing to strike")


def stream(host: Host, experiment: Experiment, until: float) -> Said:
    """Give what is said in a mission up to a stamp [s], without the mission's own description."""
    said: Said = []

    def take_in(batch: Batch) -> None:
        said.extend((message.receipt_ns, message.connection.topic, message.raw) for message in batch)

    mission, _ = ExperimentMissions(host).prepare(experiment)
    run = EmbeddedRun(mission, until, host.codec(), host.manager, change=experiment.agents)
    run.bus.tap(take_in)
    for tick in range(run.clock.ticks(until - 1.0) + 1):
        run.step(tick)
    run.close()
    return [each for each in said if each[1] != "/mrta/mission"]
