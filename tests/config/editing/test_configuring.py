from __future__ import annotations

from pathlib import Path
from typing import Callable, Dict

import pytest
import yaml

from rqt_mrta_py.config.discovery.registration import RegistrationKind, Registry
from rqt_mrta_py.config.editing.configuring import Configuration
from rqt_mrta_py.config.editing.draft import Draft
from rqt_mrta_py.config.editing.robots import AddRobot, RemoveRobot, RenameRobot
from rqt_mrta_py.config.editing.values import SetValue
from rqt_mrta_py.config.files import write_together
from rqt_mrta_py.config.mission import load_mission
from rqt_mrta_py.errors import ConfigError, UsageError

Configure = Callable[..., Configuration]


def actions(made: Configuration) -> Dict[str, str]:
    return {each.path.relative_to(made.folder).as_posix(): each.action for each in made.files}


def test_without_edits_all_files_are_generated_and_then_nothing_changes(
    configure: Configure, yard: Path, registry: Registry
) -> None:
    before = load_mission(registry, "yard").parameters
    made = configure()
    assert actions(made) == dict.fromkeys(
        [
            "config/robot1_params.yaml",
            "config/robot2_params.yaml",
            "config/robot3_params.yaml",
            "config/tasks_params.yaml",
            "launch/robot1_robot.launch",
            "launch/robot2_robot.launch",
            "launch/robot3_robot.launch",
            "launch/yard.launch",
        ],
        "written",
    )
    assert configure().changes == ()
    assert load_mission(registry, "yard").parameters == before
    loaded = yaml.safe_load((yard / "config" / "robot1_params.yaml").read_text())
    assert loaded == before["robot1"]


def test_a_plan_writes_nothing(plan: Configure, yard: Path) -> None:
    before = {path: path.read_text() for path in yard.rglob("*") if path.is_file()}
    plan(AddRobot("robot4"))
    assert {path: path.read_text() for path in yard.rglob("*") if path.is_file()} == before


def test_a_plan_is_not_carried_out_over_what_somebody_changed_meanwhile(plan: Configure, yard: Path) -> None:
    """Of two edits at once the first was lost, and nobody was told."""
    first, second = plan(SetValue("robot1/rate", "3")), plan(SetValue("robot2/rate", "4"))
    first.carry_out()
    after_first = {path: path.read_text() for path in yard.rglob("*") if path.is_file()}
    with pytest.raises(ConfigError) as caught:
        second.carry_out()
    message = "was changed by somebody else meanwhile; nothing was changed here, try again"
    assert f"{yard / 'rqt_mrta.xml'}: {message}" in str(caught.value).splitlines()
    assert {path: path.read_text() for path in yard.rglob("*") if path.is_file()} == after_first


def test_a_plan_is_not_carried_out_when_somebody_changed_what_it_began_with(plan: Configure, yard: Path) -> None:
    """What another process wrote while this one was planning counted as what it had begun with."""

    class Meanwhile:
        def apply(self, draft: Draft) -> None:
            write_together({yard / "rqt_mrta.xml": (yard / "rqt_mrta.xml").read_text() + "\n"})

    made = plan(SetValue("robot1/rate", "3"), Meanwhile())
    with pytest.raises(
        ConfigError, match=r"rqt_mrta\.xml: was changed by somebody else meanwhile; nothing was changed"
    ):
        made.carry_out()
    assert not (yard / "config").exists()


def test_a_folder_with_the_name_of_a_file_under_another_architecture_is_passed_over(
    configure: Configure, yard: Path, registry: Registry
) -> None:
    """It ended an edit with an internal error."""
    for other in {each.package for each in registry.of_kind(RegistrationKind.ARCHITECTURE)}:
        (yard / "config" / other / "notes.yaml").mkdir(parents=True)
    assert actions(configure(SetValue("robot1/rate", "3")))["rqt_mrta.xml"] == "changed"


def test_a_robot_whose_files_would_have_too_long_a_name_is_refused(plan: Configure, yard: Path) -> None:
    name = "a" * 250
    (yard / "config").mkdir()
    with pytest.raises(ConfigError) as caught:
        plan(AddRobot(name)).carry_out()
    assert str(caught.value) == f"{yard / 'config' / name}_params.yaml: cannot be read: File name too long"


def test_files_of_ones_own_are_left(configure: Configure, yard: Path) -> None:
    (yard / "config").mkdir()
    (yard / "launch").mkdir()
    own = {
        yard / "config" / "robot2_params.yaml": "rate: 1.5\n",
        yard / "config" / "notes.yaml": "- a\n",
        yard / "launch" / "yard.launch": "<launch/>\n",
    }
    for path, text in own.items():
        path.write_text(text)
    made = configure()
    assert made.left == (yard / "config" / "robot2_params.yaml", yard / "launch" / "yard.launch")
    assert {path: path.read_text() for path in own} == own


def test_a_value_that_a_file_of_ones_own_gives_is_not_set_in_vain(configure: Configure, yard: Path) -> None:
    (yard / "config").mkdir()
    own = yard / "config" / "robot2_params.yaml"
    own.write_text("rate: 1.5\n")
    with pytest.raises(ConfigError) as caught:
        configure(SetValue("robot2/rate", "2"))
    assert str(caught.value) == (
        f"{own}: robot2/rate: gives this value and was not generated; change it there, or take the file away"
    )
    with pytest.raises(ConfigError, match="belongs to robot2 and was not generated"):
        configure(RenameRobot("robot2", "digger"))
    configure(SetValue("robot1/rate", "2"))


def test_a_file_of_ones_own_that_does_not_fit_is_told(configure: Configure, yard: Path) -> None:
    (yard / "config").mkdir()
    own = yard / "config" / "robot2_params.yaml"
    own.write_text("rate: 1.5\nrat: 2\n")
    with pytest.raises(ConfigError) as caught:
        configure()
    assert str(caught.value) == f"{own}:2: robot2/rat: is not known; nearest is 'rate'"
    own.unlink()
    (yard / "config" / "params.yaml").write_text("rate: 1.5\n")
    with pytest.raises(ConfigError, match="gives values to all robots, which the file of each would cover"):
        configure()


def test_generated_files_that_nothing_belongs_to_any_more_go(configure: Configure, yard: Path) -> None:
    configure()
    made = configure(RemoveRobot("robot3"))
    changed = {name: action for name, action in actions(made).items() if action != "unchanged"}
    assert changed == {
        "config/robot3_params.yaml": "removed",
        "launch/robot3_robot.launch": "removed",
        "launch/yard.launch": "changed",
        "rqt_mrta.xml": "changed",
        "scenario.yaml": "changed",
    }
    assert not (yard / "launch" / "robot3_robot.launch").exists()


def test_edits_are_made_whole_or_not_at_all(configure: Configure, yard: Path) -> None:
    """The second edit is sound; the others are told together."""
    configure()
    before = {path: path.read_text() for path in yard.rglob("*") if path.is_file()}
    with pytest.raises(ConfigError) as caught:
        configure(SetValue("robot1/rate", "fast"), SetValue("robot2/rate", "3"), RemoveRobot("robot2"))
    assert str(caught.value).splitlines() == [
        "--set: robot1/rate: must be a finite number (got 'fast')",
        f"{yard / 'scenario.yaml'}:8: events[0]/robot: names 'robot2', which is to be removed; change this first",
        f"{yard / 'scenario.yaml'}:9: events[1]/parameters/groups: names 'robot2', which is to be removed; "
        "change this first",
    ]
    assert {path: path.read_text() for path in yard.rglob("*") if path.is_file()} == before


def test_under_another_architecture_files_stand_in_a_folder_of_their_own(
    configure: Configure, yard: Path, registry: Registry
) -> None:
    made = configure(architecture="away")
    names = ("robot1_params", "robot2_params", "robot3_params", "tasks_params")
    assert actions(made) == {f"config/away/{name}.yaml": "written" for name in names}
    configure(SetValue("robot2/rate", "7"), SetValue("params/sets/set0/drive/limit", "9"), architecture="away")
    found = load_mission(registry, "yard", "away").parameters
    assert [found[robot]["rate"] for robot in ("robot1", "robot2", "robot3")] == [5.0, 7.0, 5.0]
    assert [found[robot]["sets"]["set0"]["drive"]["limit"] for robot in found] == [9, 9, 9]
    assert load_mission(registry, "yard").parameters["robot2"]["rate"] == 5.0
    assert configure(architecture="away").changes == ()


def test_robots_and_tasks_are_not_edited_under_another_architecture(configure: Configure) -> None:
    with pytest.raises(UsageError, match="leave --architecture out"):
        configure(AddRobot("robot4"), architecture="away")
