from __future__ import annotations

from pathlib import Path
from typing import Callable

import pytest

from rqt_mrta_py.config.discovery.registration import Registry
from rqt_mrta_py.config.editing.configuring import Configuration
from rqt_mrta_py.config.editing.values import SetValue, UnsetValue
from rqt_mrta_py.config.mission import load_mission
from rqt_mrta_py.errors import ConfigError
from tests.config.editing.yard import APPLICATION

Configure = Callable[..., Configuration]


def test_a_value_that_stands_there_is_replaced_in_place(configure: Configure, yard: Path) -> None:
    configure(SetValue("robot1/rate", "4"), SetValue("/robot1/sets/set0/drive/gain", "2.5"))
    expected = APPLICATION.replace("<value>2.5</value>", "<value>4</value>").replace(
        "<value>1.5</value>", "<value>2.5</value>"
    )
    assert (yard / "rqt_mrta.xml").read_text() == expected


def test_a_value_that_does_not_is_entered_with_its_groups(configure: Configure, yard: Path, registry: Registry) -> None:
    configure(SetValue("robot1/sets/set1/drive/limit", "8"))
    assert load_mission(registry, "yard").parameters["robot1"]["sets"]["set1"] == {
        "task_id": "carry",
        "drive": {"gain": 1.0, "limit": 8},
    }
    before = "<params_2> <name>set1</name> <param_0> <name>task_id</name> <value>carry</value> </param_0> "
    after = (
        "<params_1> <name>drive</name> <param_0> <name>limit</name> <type>int</type> <value>8</value> </param_0> "
        "</params_1> "
    )
    text = (yard / "rqt_mrta.xml").read_text()
    assert " ".join(text.split()) == " ".join(APPLICATION.replace(before, before + after).split())


def test_a_config_is_made_where_there_is_none(configure: Configure, yard: Path, registry: Registry) -> None:
    configure(
        SetValue("robot3/rate", "9"), SetValue("params/rate", "8"), SetValue("tasks_params/tasks/task0/layer", "l")
    )
    found = load_mission(registry, "yard").parameters
    assert [found[robot]["rate"] for robot in ("robot1", "robot2", "robot3")] == [2.5, 8.0, 9.0]
    text = (yard / "rqt_mrta.xml").read_text()
    assert (
        "    <config_2>\n      <id>robot3_params</id>\n      <param_0>\n        <name>rate</name>\n"
        "        <type>double</type>\n        <value>9</value>\n      </param_0>\n    </config_2>\n"
    ) in text
    assert "layer: l\n" in (yard / "config" / "tasks_params.yaml").read_text()


def test_a_value_is_taken_back_with_the_groups_that_hold_nothing_else(
    configure: Configure, yard: Path, registry: Registry
) -> None:
    configure(SetValue("robot2/sets/set0/drive/gain", "4"))
    configure(UnsetValue("robot2/sets/set0/drive/gain"), UnsetValue("robot1/rate"))
    gone = "      <param_0> <name>rate</name> <type>double</type> <value>2.5</value> </param_0>"
    text = (yard / "rqt_mrta.xml").read_text()
    assert "robot2_params" not in text
    assert gone not in text
    assert "<!-- slow -->" in text
    assert load_mission(registry, "yard").parameters["robot1"]["rate"] == 5.0


def test_a_whole_group_is_taken_back(configure: Configure, registry: Registry) -> None:
    configure(UnsetValue("robot1/sets"))
    assert load_mission(registry, "yard").parameters["robot1"]["sets"]["set2"]["drive"]["gain"] == 1.0


@pytest.mark.parametrize(
    ("edit", "message"),
    [
        (SetValue("robot1/rate", "abc"), "--set: robot1/rate: must be a finite number (got 'abc')"),
        (SetValue("robot1/sets/set0/drive/limit", "1.5"), "must be a whole number (got '1.5')"),
        (SetValue("robot1/rat", "1"), "--set: robot1/rat: is not known; nearest is 'rate'"),
        (SetValue("params/rat", "1"), "--set: params/rat: is not known; nearest is 'rate'"),
        (SetValue("robot1/sets/set7/drive/gain", "1"), "is of element 7, but size is 3; elements count from 0"),
        (SetValue("robot9/rate", "1"), "--set: robot9/rate: 'robot9' is no robot and no config; nearest is 'robot3'"),
        (SetValue("robot1", "1"), "must have the form <robot>/<parameter>, such as robot1/spin_rate"),
        (SetValue("robot1/rate", ""), "must get a text of one line (got ''); --unset takes a value back"),
        (SetValue("robot1/name", "a\x07"), "must get a text of one line (got 'a\\x07'); --unset takes a value back"),
        (UnsetValue("robot1/sets/set0/drive/limit"), "is not given in rqt_mrta.xml; nearest is 'sets/set0/drive/gain'"),
        (UnsetValue("robot2/rate"), "is not given in rqt_mrta.xml; there is none"),
    ],
)
def test_what_cannot_be_set_is_told(configure: Configure, yard: Path, edit: object, message: str) -> None:
    with pytest.raises(ConfigError) as caught:
        configure(edit)
    assert message in str(caught.value)
    assert (yard / "rqt_mrta.xml").read_text() == APPLICATION


def test_a_problem_elsewhere_names_the_line_that_the_file_has(configure: Configure, yard: Path) -> None:
    """The size becomes too small for the robot's tasks: the option that did it is named."""
    with pytest.raises(ConfigError) as caught:
        configure(SetValue("robot1/sets/size", "2"))
    assert str(caught.value).splitlines()[0] == (
        "--set: robot1/sets/size: is 2, which leaves no element for rest; give 3"
    )
    broken = APPLICATION.replace("<name>drive/gain</name>", "<name>drive/gian</name>", 1)
    (yard / "rqt_mrta.xml").write_text(broken)
    line = broken[: broken.index("drive/gian")].count("\n") + 1
    with pytest.raises(ConfigError) as caught:
        configure(SetValue("params/rate", "2"), SetValue("robot1/sets/set1/drive/limit", "2"))
    assert f"rqt_mrta.xml:{line}: robot1/sets/set0/drive/gian: is not known; nearest is 'gain'" in str(caught.value)
