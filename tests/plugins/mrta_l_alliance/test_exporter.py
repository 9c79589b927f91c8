"""What missions leave for the next one, and what a record teaches."""

from __future__ import annotations

from typing import Any, Dict, Iterator, List, Mapping, Optional, Sequence

import pytest
from mrta_l_alliance.exporter import MemoryExporter, team_memory
from mrta_l_alliance.lessons import learn, settings, train
from mrta_l_alliance.memory import Memory, Performance, read_memory
from mrta_l_alliance.messages import MEMORY_FIELDS, memory_message, memory_of
from mrta_l_alliance.parameters import Phase

from rqt_mrta_py.hooks import Experiment, ExporterSetup, Heard, Trial
from rqt_mrta_py.model import (
    Allocation,
    ApplicationSpec,
    ArchitectureSpec,
    Mission,
    MissionRecord,
    Outcome,
    Taxonomy,
)

DUG = Memory({("r1", "dig"): Performance((12.5, 13.0), 1), ("r2", "dig"): Performance((40.0,))})
FILLED = Memory({("r1", "dig"): Performance((12.6,)), ("r2", "fill"): Performance((7.0,))})


def record(*allocations: Allocation) -> MissionRecord:
    return MissionRecord("yard", "mrta_l_alliance", Taxonomy(), 0, 1.0, 90.0, (), (), allocations, (), ())


def heard(robot: str, memory: Memory, **changed: Any) -> Heard:
    fields = memory_message(robot, 5.0, memory, lambda robot, task: None).fields
    return Heard(f"/{robot}/l_alliance/memory", "mrta_l_alliance_msgs/Memory", 5.0, {**fields, **changed}, robot)


def test_a_memory_survives_its_message() -> None:
    fields = heard("r1", DUG).fields
    assert memory_of({name: list(fields[name]) for name in MEMORY_FIELDS}) == DUG


@pytest.mark.parametrize("changed", [{"trials": (9, 9)}, {"tasks": ("dig",)}, {"times": (12.5, 13.0, float("nan"))}])
def test_a_message_that_contradicts_itself_is_no_memory(changed: Dict[str, Any]) -> None:
    assert memory_of(heard("r1", DUG, **changed).fields) is None


@pytest.fixture
def exporter() -> MemoryExporter:
    mission = Mission(ApplicationSpec("yard", "Yard"), ArchitectureSpec("x", "X", Taxonomy()), ())
    return MemoryExporter(ExporterSetup(mission))


def test_the_newest_memory_of_each_robot_is_written_down(exporter: MemoryExporter) -> None:
    for message in (heard("r1", Memory()), heard("r2", FILLED), heard("r1", DUG), heard("r1", DUG, trials=(9, 9))):
        exporter.hear(message)
    files = exporter.export(record())
    assert list(files) == ["team.yaml", "r1.yaml", "r2.yaml"]
    assert read_memory(files["r1.yaml"].decode()) == DUG
    assert all(content.count(b"\n") == 1 for content in files.values())


def test_the_team_knows_of_each_robot_what_that_knows_of_itself() -> None:
    """r1 knows its own digging better than r2 does; of r2's digging only r1 speaks, of its filling only r2."""
    for memories in ({"r1": DUG, "r2": FILLED}, {"r2": FILLED, "r1": DUG}):
        assert team_memory(memories) == Memory({**DUG.known, ("r2", "fill"): Performance((7.0,))})


def test_where_nobody_learned_anything_nothing_is_written(exporter: MemoryExporter) -> None:
    assert exporter.export(record()) == {}


def test_a_record_teaches_what_a_robot_would_have_learned_that_heard_everything() -> None:
    """Done after 20 s; given up after 30 s, longer than 20 on average; yielded at once, which counts for nothing."""
    lesson = record(
        Allocation("dig", "r1", 10.0, 30.0, Outcome.DONE),
        Allocation("dig", "r2", 12.0, 12.4, Outcome.YIELDED),
        Allocation("fill", "r1", 31.0, 61.0, Outcome.GAVE_UP),
        Allocation("fill", "r2", 61.0, 90.0, Outcome.OPEN),
    )
    assert learn(Memory(), lesson).known == {("r1", "dig"): Performance((20.0,)), ("r1", "fill"): Performance((), 1)}
    before = Memory({("r1", "fill"): Performance((20.0,))})
    assert learn(before, lesson).of("r1", "fill") == Performance((20.0, 30.0), 1)


def test_settings_give_every_robot_phase_and_memory() -> None:
    memory = Memory({("r1", "dig"): Performance((3.0,))})
    text = "{r1: {dig: {failures: 0, times: [3.0]}}}"
    assert settings(memory, ("r1", "r2"), Phase.ACTIVE) == (
        "r1/learning/phase=active",
        f"r1/learning/memory={text}",
        "r2/learning/phase=active",
        f"r2/learning/memory={text}",
    )


class Yard:
    """A laboratory in which r1 always digs, for 10 s and as many as the seed says; writes down what it is asked."""

    def __init__(self) -> None:
        self.rounds: List[Sequence[Experiment]] = []

    def trials(self, experiments: Sequence[Experiment]) -> Iterator[Trial]:
        self.rounds.append(experiments)
        for each in experiments:
            yield Trial(each, record(Allocation("dig", "r1", 1.0, 11.0 + each.seed, Outcome.DONE)))


def memory_in(experiment: Experiment) -> Optional[Mapping[Any, Performance]]:
    (text,) = (each.partition("=")[2] for each in experiment.settings if each.startswith("r1/learning/memory="))
    return read_memory(text).known


def test_training_goes_on_with_what_the_missions_before_taught() -> None:
    yard = Yard()
    courses = [Experiment("yard", 0, settings=("r1/spin_rate=2",)), Experiment("yard", 100)]
    first, second = train(yard, courses, ("r1",), missions=3)
    assert first.of("r1", "dig").times == (10.0, 11.0, 12.0)
    assert second.of("r1", "dig").times == (110.0, 111.0, 112.0)
    assert [[each.seed for each in lessons] for lessons in yard.rounds] == [[0, 100], [1, 101], [2, 102]]
    last = yard.rounds[2][0]
    assert (last.architecture, last.settings[:2]) == ("mrta_l_alliance", ("r1/spin_rate=2", "r1/learning/phase=active"))
    assert memory_in(last) == {("r1", "dig"): Performance((10.0, 11.0))}
