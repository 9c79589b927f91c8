from __future__ import annotations

from pathlib import Path
from typing import List

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.config.discovery.registration import RegistrationKind
from rqt_mrta_py.config.packages.answers import Answers, read_answers
from rqt_mrta_py.config.packages.checks import Surroundings, find_problems, wrong_with
from rqt_mrta_py.errors import ConfigError

AROUND = Surroundings(("taken",), ("nearest_robot",), {"go_to_place": "basic_behaviours"}, ("planar",))
SOUND = """package: yard
description: d
maintainer: m
email: a@b.c
architecture: nearest_robot
robots: [{}, {id: /second, tasks: [task1]}]
tasks: [{}]
"""


def problems_of(text: str, folder: Path, kind: str = "application") -> List[str]:
    path = folder / "answers.yaml"
    path.write_text(text, encoding="utf-8")
    found = sorted(find_problems(read_answers(path, RegistrationKind(kind)), AROUND))
    return [str(problem).replace(f"{path}:", "") for problem in found]


def test_sound_answers_have_no_problem(tmp_path: Path) -> None:
    assert problems_of(SOUND, tmp_path) == []


def test_automatic_ids_count_from_one(tmp_path: Path) -> None:
    (tmp_path / "answers.yaml").write_text(SOUND)
    answers = read_answers(tmp_path / "answers.yaml", RegistrationKind.APPLICATION)
    assert [robot.id for robot in answers.robots] == ["robot1", "second"]
    assert [(entry.task.id, entry.task.kind) for entry in answers.tasks] == [("task1", "go_to_place")]


@pytest.mark.parametrize(
    ("key", "value", "message"),
    [
        ("package", "", "The package name must not be empty."),
        ("package", "my yard", "The package name must not contain space characters."),
        ("package", "taken", "The given package [taken] already exists."),
        ("version", " ", "The package version must be defined."),
        ("version", "1.0", "must be three numbers joined by dots (got '1.0')"),
        ("description", "", "The package description must be given."),
        ("maintainer", "", "The package maintainer must be given."),
        ("email", "", "The e-mail of the package maintainer must be given."),
        ("email", "nobody", "The e-mail of the package maintainer must be given."),
        ("email", "a b@c", "must be an e-mail address (got 'a b@c')"),
        ("license", "", "The package license must be defined."),
        ("robots_type", "", "The robots type must be selected: ST or MT."),
        ("tasks_type", "", "The tasks type must be selected: SR or MR."),
        ("allocations_type", "", "The allocations type must be selected: IA or TA."),
        ("allocations_type", "XY", "is not known (got 'XY'); accepted: IA, TA"),
        ("architecture", "", "The architecture package must be given."),
        ("robots", (), "Enter the system robots."),
        ("tasks", (), "Enter the robot tasks."),
        ("description", "two\nlines", "must be a text of one line (got 'two\\nlines')"),
    ],
)
def test_wizards_texts(key: str, value: object, message: str) -> None:
    assert wrong_with(key, value, AROUND) == message


@pytest.mark.parametrize(
    "name",
    ["1st", "Yard", "yard-watch", "y", "_yard", "yård"],
)
def test_names_that_catkin_or_python_would_refuse_are_refused(name: str) -> None:
    assert str(wrong_with("package", name, AROUND)).startswith("The package name must begin with a lower-case letter")


@pytest.mark.parametrize(
    ("old", "new", "problem"),
    [
        ("[{},", "[{id: a b},", "6: robots[0]/id: The robot id must not contain <space>."),
        ("[{},", "[{id: /},", "6: robots[0]/id: The robot id must not be empty."),
        ("[{},", "[{id: second},", "6: robots[1]/id: The robot id 'second' is given twice."),
        ("[task1]", "[tusk1]", "6: robots[1]/id: second: 'tusk1' is no task; nearest is 'task1'"),
        ("tasks: [{}]", "tasks: [{}, {id: a b}]", "7: tasks[1]/id: The task id must not contain <space>."),
        ("tasks: [{}]", "tasks: [{}, {id: task1}]", "7: tasks[1]/id: The task id 'task1' is given twice."),
        (
            "tasks: [{}]",
            "tasks: [{kind: go_to_plaice}]",
            "7: tasks[0]/id: task1: no behaviour of kind 'go_to_plaice' is registered; nearest is 'go_to_place'",
        ),
        (
            "tasks: [{}]",
            "tasks: [{layers: [go_to_plaice]}]",
            "7: tasks[0]/id: task1: no behaviour of kind 'go_to_plaice' is registered for its layer; nearest is "
            "'go_to_place'",
        ),
        (
            "tasks: [{}]",
            "tasks: [{layers: [go_to_place]}]",
            "7: tasks[0]/id: task1: layer 'go_to_place' stands twice; its own kind is the lowest layer",
        ),
        (
            "nearest_robot",
            "neerest_robot",
            "5: architecture: no architecture of this name is registered (got 'neerest_robot'); "
            "nearest is 'nearest_robot'",
        ),
        ("email: a@b.c", "emial: a@b.c", "4: emial: is not known; nearest is 'email'"),
    ],
)
def test_defect_of_a_file_is_told_with_its_line(tmp_path: Path, old: str, new: str, problem: str) -> None:
    assert problem in problems_of(SOUND.replace(old, new, 1), tmp_path)


def test_everything_that_is_missing_is_told_at_once(tmp_path: Path) -> None:
    assert problems_of("license: MIT\n", tmp_path, "architecture") == [
        "--allocations-type: The allocations type must be selected: IA or TA.",
        "--description: The package description must be given.",
        "--email: The e-mail of the package maintainer must be given.",
        "--maintainer: The package maintainer must be given.",
        "--robots-type: The robots type must be selected: ST or MT.",
        "--tasks-type: The tasks type must be selected: SR or MR.",
        "NAME: The package name must not be empty.",
    ]


def test_parameter_without_a_tool_tip_is_refused(tmp_path: Path) -> None:
    parameter = "{name: a b, type: int, default: '1', tool_tip: t}"
    told = problems_of(f"parameters: [{parameter}, {{name: c, type: int}}]\n", tmp_path, "architecture")
    assert "1: parameters[1]/tool_tip: is missing; give a text" in told


def test_word_of_python_names_no_package_with_a_plugin(tmp_path: Path) -> None:
    text = "package: class\ndescription: d\nmaintainer: m\nemail: a@b.c\n"
    types = "robots_type: ST\ntasks_type: SR\nallocations_type: IA\n"
    assert problems_of(text + types, tmp_path, "architecture") == [
        "1: package: 'class' is a word of Python; give another name"
    ]
    assert problems_of(text + types + "plugin: false\n", tmp_path, "architecture") == []


@given(raw=st.binary(max_size=200) | st.text(max_size=200).map(lambda text: text.encode("utf-8", "replace")))
def test_any_file_gives_answers_or_problems(raw: bytes, tmp_path_factory: pytest.TempPathFactory) -> None:
    path = tmp_path_factory.getbasetemp() / "answers.yaml"
    path.write_bytes(raw)
    for kind in (RegistrationKind.ARCHITECTURE, RegistrationKind.APPLICATION):
        try:
            answers: Answers = read_answers(path, kind)
        except ConfigError:
            continue
        assert list(find_problems(answers, AROUND))
