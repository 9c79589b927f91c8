"""Real files made hostile: each gives a specification or problems, and what it gives can be written and read again."""

from __future__ import annotations

import random
import resource
from pathlib import Path
from typing import Any, Callable, Dict, List, NamedTuple, Sequence

import pytest

from rqt_mrta_py.config.discovery.manifest import read_manifest
from rqt_mrta_py.config.discovery.registration import RegistrationKind
from rqt_mrta_py.config.packages.answers import read_answers
from rqt_mrta_py.config.packages.checks import Surroundings, find_problems
from rqt_mrta_py.config.parameters.parameter_file import parse_parameters
from rqt_mrta_py.config.scenario.scenario_file import read_scenario
from rqt_mrta_py.config.tasks.tasks_file import read_tasks
from rqt_mrta_py.config.xml.application import read_application
from rqt_mrta_py.config.xml.architecture import read_architecture
from rqt_mrta_py.config.xml.writing import write_application, write_architecture
from rqt_mrta_py.errors import ConfigError, Problem
from tests.config.mutations import mutated_xml, mutated_yaml
from tests.conftest import ROOT

QUICK = 250
LONG = 35_000
"""Hostile files of each kind."""

MOST_MEMORY = 300_000
"""No campaign may take more on top of what was there before [kB]."""

PLUGINS = ROOT / "plugins"
DATA = ROOT / "tests" / "data" / "config"


class Kind(NamedTuple):
    """A kind of file: sound ones, how they are made hostile, how they are read."""

    seeds: List[bytes]
    mutate: Callable[[random.Random, List[bytes]], bytes]
    read: Callable[[bytes, Path], Any]


def _architecture(raw: bytes, _: Path) -> None:
    spec = read_architecture(raw, "a.xml", "a")
    assert read_architecture(write_architecture(spec), "again.xml", "a") == spec


def _application(raw: bytes, _: Path) -> None:
    spec = read_application(raw, "a.xml", "a")
    assert read_application(write_application(spec), "again.xml", "a") == spec


def _manifest(raw: bytes, folder: Path) -> None:
    path = folder / "package.xml"
    path.write_bytes(raw)
    read_manifest(path)


def _answers_of(kind: RegistrationKind) -> Callable[[bytes, Path], None]:
    def read(raw: bytes, folder: Path) -> None:
        path = folder / "answers.yaml"
        path.write_bytes(raw)
        problems = list(find_problems(read_answers(path, kind), AROUND))
        if problems:
            raise ConfigError(problems)

    return read


def _found(*patterns: str) -> List[bytes]:
    paths = sorted(path for pattern in patterns for path in ROOT.glob(pattern))
    return [path.read_bytes() for path in paths]


YAML_TEXTS = [
    b"tasks:\n  - {id: dig, kind: go, place: {x: 1, y: 2.5}, predecessors: [fill]}\n"
    b"  - id: fill\n    kind: go\n    robots: 2\n",
    b"arena: {min_x: -3, min_y: -3, max_x: 3, max_y: 3}\nrobots:\n  - {id: robot1, start: {x: 0, y: 0}}\n"
    b"events:\n  - {time: 1, kind: robot_slows, robot: robot1, parameters: {factor: 0.5}}\n"
    b"  - time: 2\n    kind: radio_partitions\n    parameters: {groups: [[robot1]]}\n",
    b"robot1:\n  rate: 2.0\n  sensors: {size: 1, sensor0: {topic_name: scan}}\n  name: &n robot1\n  again: *n\n",
]

AROUND = Surroundings(("yard",), ("nearest_robot",), {"go_to_place": "basic_behaviours"}, ("planar", "bullet"))
APPLICATION_ANSWERS = [
    b"package: harbour\ndescription: Keeps a harbour.\nmaintainer: Ada\nemail: ada@example.org\n"
    b"architecture: nearest_robot\nrobots: [{id: robot1}, {id: robot2, tasks: [quay]}]\n"
    b"tasks:\n  - {id: quay, place: {x: 1, y: 2.5, yaw: 1}}\n  - {id: crane, predecessors: [quay], robots: 2}\n",
    b"package: dock\nversion: 0.1.0\ndescription: A dock.\nmaintainer: Ada\nemail: ada@example.org\nlicense: MIT\n"
    b"architecture: nearest_robot\nrobots: [{id: robot1}]\ntasks: [{id: quay, kind: go_to_place}]\n"
    b"parameters:\n  robot1: {rate: 2.0, sensors: {sensor0: {topic_name: scan}}}\nworld: bullet\nduration: 12.5\n"
    b"arena: {min_x: -3, min_y: -3, max_x: 3, max_y: 3}\nrun_depends: [std_msgs]\nworkspace: ws\n",
]
ARCHITECTURE_ANSWERS = [
    b"package: bidding\ndescription: Bids.\nmaintainer: Ada\nemail: ada@example.org\n"
    b"robots_type: ST\ntasks_type: SR\nallocations_type: IA\nplugin: false\n"
    b"topics:\n  - {meaning: busy_robots, name: /busy, type: my_msgs/Busy, field: robot, timeout: 2, horizon: 5.5}\n"
    b"parameters:\n  - name: motion/speed\n    type: double\n    default: '1.5'\n"
    b"    tool_tip: Enter how fast it goes [m/s].\n",
]

KINDS: Dict[str, Kind] = {
    "architecture": Kind(
        _found("tests/data/config/*_architecture.xml", "plugins/architectures/nearest_robot/rqt_mrta.xml"),
        mutated_xml,
        _architecture,
    ),
    "application": Kind(
        [*_found("tests/data/config/*_application.xml"), (DATA / "small_application.xml").read_bytes()],
        mutated_xml,
        _application,
    ),
    "manifest": Kind(_found("tests/data/config/*_package.xml", "plugins/*/*/package.xml"), mutated_xml, _manifest),
    "tasks": Kind(YAML_TEXTS, mutated_yaml, lambda raw, _: read_tasks(raw, "t.yaml")),
    "scenario": Kind(YAML_TEXTS, mutated_yaml, lambda raw, _: read_scenario(raw, "s.yaml", ["robot1"], ["dig"])),
    "parameters": Kind(YAML_TEXTS, mutated_yaml, lambda raw, _: parse_parameters(raw, "p.yaml")),
    "application answers": Kind(APPLICATION_ANSWERS, mutated_yaml, _answers_of(RegistrationKind.APPLICATION)),
    "architecture answers": Kind(ARCHITECTURE_ANSWERS, mutated_yaml, _answers_of(RegistrationKind.ARCHITECTURE)),
}


def campaign(name: str, files: int, seed: int, folder: Path) -> Dict[str, int]:
    """Read hostile files of a kind.

    Returns:
        How many were read and how many refused.
    """
    kind = KINDS[name]
    chance = random.Random(f"{name} {seed}")
    counted = {"read": 0, "refused": 0}
    for number in range(files):
        raw = kind.mutate(chance, kind.seeds)
        try:
            problems = problems_of(kind, raw, folder)
        except Exception as error:
            raise AssertionError(f"file {number} of {name} {seed}: {raw!r}") from error
        assert not any("\n" in str(problem) for problem in problems), (number, raw)
        counted["refused" if problems else "read"] += 1
    return counted


def problems_of(kind: Kind, raw: bytes, folder: Path) -> Sequence[Problem]:
    try:
        kind.read(raw, folder)
    except ConfigError as error:
        return error.problems or [Problem("says", 0, "nothing", "\n")]
    return ()


def memory() -> int:
    """Give the most memory that this process ever had [kB]."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


@pytest.mark.parametrize("name", KINDS)
def test_sound_files_are_read(name: str, tmp_path: Path) -> None:
    read = 0
    for raw in KINDS[name].seeds:
        try:
            KINDS[name].read(raw, tmp_path)
            read += 1
        except ConfigError:
            # A YAML file of one kind is a hostile one of another.
            assert raw in YAML_TEXTS
    assert read


@pytest.mark.parametrize("name", KINDS)
def test_hostile_files_are_read_or_refused(name: str, tmp_path: Path) -> None:
    counted = campaign(name, QUICK, 1, tmp_path)

    # A campaign that only finds broken files, or none, would test nothing.
    assert counted["read"] > QUICK // 50
    assert counted["refused"] > QUICK // 4


@pytest.mark.long
@pytest.mark.parametrize("name", KINDS)
def test_hostile_files_are_read_or_refused_in_a_long_campaign(name: str, tmp_path: Path) -> None:
    before = memory()

    counted = campaign(name, LONG, 2, tmp_path)

    assert counted["read"] + counted["refused"] == LONG
    assert memory() - before < MOST_MEMORY
