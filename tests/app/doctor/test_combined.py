"""Two mistakes in one rqt_mrta.xml: both are told, and nothing that only follows from one of them."""

from __future__ import annotations

import re
import shutil
from itertools import combinations, islice
from pathlib import Path
from typing import Dict, Iterator, List, Optional, Tuple

import pytest
import yaml
from lxml import etree

from rqt_mrta_py.config.xml.application import read_application
from rqt_mrta_py.config.xml.architecture import read_architecture
from rqt_mrta_py.errors import ConfigError
from tests.app.doctor.combining import Combined, combine
from tests.app.doctor.conftest import Workspace
from tests.app.doctor.corpus import PLACES, told
from tests.sampling import every, one_of_each

DATA = Path(__file__).resolve().parents[2] / "data"
TOLD: Dict[str, str] = yaml.safe_load((DATA / "bad" / "expected.yaml").read_text(encoding="utf-8"))
EVERY = {"market": 12, "wizard_application": 1, "yard": 2}
"""Of so many pairs one, by the package that they are put into."""

HIDING: Dict[str, Tuple[str, ...]] = {
    # The team's robots, or the architecture with its templates, are not known.
    "application_robot_id_with_a_blank.xml": ("application_config_of_no_robot.xml",),
    "application_robot_twice.xml": ("application_config_of_no_robot.xml",),
    "application_unknown_architecture.xml": ("application_config_of_no_robot.xml", "application_parameter_"),
    "application_without_architecture.xml": ("application_config_of_no_robot.xml", "application_parameter_"),
    # The file ends, or is not read on; nobody knows which configs there are.
    "architecture_entity_declared.xml": ("architecture_", "topic_"),
    "architecture_config_twice.xml": ("architecture_config_unknown.xml",),
    "architecture_config_without_number.xml": ("architecture_config_unknown.xml",),
    # Topics in an element of an unknown name are not read; types that are not known have no fields.
    "architecture_unknown_element.xml": ("topic_",),
    "topic_negative_timeout.xml": ("topic_allocated_shorter_than_busy.xml",),
    "topic_unknown_token.xml": ("topic_allocated_shorter_than_busy.xml",),
    "topic_type_of_unknown_package.xml": ("topic_field_",),
    "topic_type_without_package.xml": ("topic_field_",),
    "topic_unknown_type.xml": ("topic_field_",),
    "topic_without_type.xml": ("topic_field_",),
    # One number is wrong because of both, and told once.
    "saved_array_of_another_task.xml": ("saved_array_too_small.xml",),
}
"""Which files of the corpus are such that what is wrong with others cannot be told, or not so."""


def pairs() -> Iterator[Tuple[str, str]]:
    """Give files of the corpus that are to be put into the same file."""
    names = sorted(name for name in TOLD if name.endswith(".xml") and not name.startswith("manifest_"))
    for package, step in EVERY.items():
        here = [name for name in names if PLACES[name.partition("_")[0]][0] == package]
        yield from islice(combinations(here, 2), 0, None, step)


def is_hidden(name: str, other: str) -> bool:
    return any(other.startswith(start) for start in HIDING.get(name, ()))


def put_together(one: str, other: str) -> Optional[Combined]:
    package, place = PLACES[one.partition("_")[0]]
    files = (DATA / "sound" / package / place, DATA / "bad" / one, DATA / "bad" / other)
    return combine(*(path.read_text(encoding="utf-8") for path in files))


def cases() -> Iterator[Tuple[str, str, str, List[str]]]:
    """Give two files, both in one, and what is to be told of it; only such as change different lines."""
    for one, other in pairs():
        both = put_together(one, other)
        moved = [] if both is None else [both.moved(TOLD[one], 0), both.moved(TOLD[other], 1)]
        lines = [line for line in moved if line is not None]
        if both is not None and len(lines) == 2 and not is_hidden(one, other) and not is_hidden(other, one):
            yield one, other, both.text, lines


CASES = {f"{one}+{other}": (one, text, lines) for one, other, text, lines in cases()}


@pytest.fixture(scope="module")
def packages(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Give a copy of the sound packages, in which tests replace one file and put it back."""
    folder = tmp_path_factory.mktemp("combined") / "ws"
    shutil.copytree(str(DATA / "sound"), str(folder))
    return folder


def told_with(packages: Path, package: str, place: str, text: str) -> List[str]:
    """Examine a package with another text in the place of one of its files."""
    path = packages / package / place
    before = path.read_bytes()
    path.write_text(text, encoding="utf-8")
    try:
        return told(packages / package)
    finally:
        path.write_bytes(before)


def test_there_are_enough_pairs() -> None:
    assert len(CASES) >= 80


@pytest.mark.parametrize("name", every(3, sorted(CASES)))
def test_two_mistakes_are_told_as_each_alone_is(name: str, packages: Path) -> None:
    one, text, lines = CASES[name]

    assert sorted(told_with(packages, *PLACES[one.partition("_")[0]], text)) == sorted(lines)


def misspelt() -> Iterator[Tuple[str, str, str]]:
    """Give texts of sound applications and an architecture in which one element has another name."""
    for package in ("yard", "wizard_application", "market"):
        tree = etree.parse(str(DATA / "sound" / package / "rqt_mrta.xml"))
        for element in list(tree.getroot().iterdescendants()):
            name, element.tag = str(element.tag), f"x{element.tag}"
            yield package, f"{element.sourceline}-{name}", etree.tostring(tree, encoding="unicode")
            element.tag = name


MISSPELT = {f"{package}-{name}": (package, text) for package, name, text in misspelt()}


def without_numbers(name: str) -> str:
    """Tell elements apart by package and name, but not those of a list."""
    return re.sub(r"[0-9]+", "", name)


@pytest.mark.parametrize("name", one_of_each(without_numbers, MISSPELT))
def test_nothing_is_told_that_only_follows_from_an_element_of_another_name(name: str, packages: Path) -> None:
    """What is missing because of it is not told where somebody asks for it; the reader says all that there is."""
    package, text = MISSPELT[name]
    read = read_architecture if package == "market" else read_application
    with pytest.raises(ConfigError) as refused:
        read(text, "rqt_mrta.xml", package)

    assert told_with(packages, package, "rqt_mrta.xml", text) == [str(each) for each in refused.value.problems]


def test_a_robot_named_twice_hides_no_architecture_that_is_not_registered(workspace: Workspace) -> None:
    """A robot may be missing then, so that nothing is said of those that the scenario has more."""
    workspace.replace("yard/rqt_mrta.xml", "<architecture>auction", "<architecture>auktion")
    twice = "</robot_0><robot_1><id>robot1</id></robot_1>"
    workspace.replace("yard/rqt_mrta.xml", "</robot_0>", twice)

    architecture, robot = workspace.told("yard")

    assert architecture.startswith("yard/rqt_mrta.xml:5: application/architecture: auktion: no architecture of this")
    assert robot == (
        "yard/rqt_mrta.xml:14: application/robots/robot_1/id: 'robot1' names two robots; the first one is in line 7"
    )


def test_a_value_of_the_wrong_type_hides_no_parameter_that_is_not_known(workspace: Workspace) -> None:
    strange = "<param_1><name>rote</name><type>double</type><value>1.0</value></param_1></config_0>"
    workspace.replace("yard/rqt_mrta.xml", "<value>4.0</value>", "<value>three</value>")
    workspace.replace("yard/rqt_mrta.xml", "</config_0>", strange)

    assert workspace.told("yard") == [
        "yard/rqt_mrta.xml:23: configs/config_0/param_0/value: must be a finite number (got 'three')",
        "yard/rqt_mrta.xml:25: robot1/rote: is not known; nearest is 'rate'",
    ]


def test_a_robot_whose_name_is_wrong_is_not_missed_elsewhere(workspace: Workspace) -> None:
    """Its task seems to be that of no robot, its parameters those of a robot that does not exist."""
    workspace.replace("yard/rqt_mrta.xml", "<id>robot1</id>", "<id>robot 1</id>")
    workspace.write("yard/config/robot1_bidder.yaml", "rate: 4.0\n")
    workspace.write("yard/tasks.yaml", "tasks:\n  - {id: wander, kind: wander, robots: 1, capabilities: [lift]}\n")
    workspace.replace("yard/CMakeLists.txt", "(DIRECTORY launch ", "(DIRECTORY config launch ")

    assert workspace.told("yard") == [
        "yard/rqt_mrta.xml:7: application/robots/robot_0/id: must not contain a space (got 'robot 1')"
    ]
