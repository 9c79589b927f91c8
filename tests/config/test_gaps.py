"""What is not certain of an application in whose file something is wrong."""

from __future__ import annotations

import pytest

from rqt_mrta_py.config.gaps import Gaps
from rqt_mrta_py.config.xml.application import read_application_partly
from rqt_mrta_py.errors import ConfigError

TASK = "<task_0> <id>t</id> </task_0>"
TWO = f"<robot_1> <id>two</id> <tasks> {TASK} </tasks> </robot_1>"
PARAMETER = "<param_0> <name>a</name> <type>int</type> <value>1</value> </param_0>"
TEXT = f"""<rqt_mrta>
  <application>
    <name>Yard</name>
    <architecture>alliance</architecture>
    <robots>
      <robot_0> <id>one</id> <tasks> {TASK} </tasks> </robot_0>
      {TWO}
    </robots>
  </application>
  <configs>
    <config_0> <id>p</id> {PARAMETER} </config_0>
    <config_1> <id>q</id> </config_1>
  </configs>
  <launches>
    <launch_0> <id>l</id> </launch_0>
  </launches>
</rqt_mrta>
"""


def gaps(old: str, new: str) -> Gaps:
    """Read the application with something in it replaced, once."""
    assert old in TEXT
    return read_application_partly(TEXT.replace(old, new, 1), "a.xml", "yard").gaps


def test_a_sound_file_has_no_gaps() -> None:
    file = read_application_partly(TEXT, "a.xml", "yard")

    assert file.gaps == Gaps()
    assert file.problems == ()


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ("<name>Yard</name>", "", Gaps()),
        ("<rqt_mrta>", '<rqt_mrta formt="application">', Gaps()),
        ("<robot_1>", '<robot_1 colour="red">', Gaps()),
        ("<architecture>alliance</architecture>", "", Gaps()),
        ("<architecture>alliance</architecture>", "<architectur>alliance</architectur>", Gaps(architecture=True)),
        ("<name>Yard</name>", "<nmae>Yard</nmae>", Gaps()),
        ("<id>two</id>", "<id>one</id>", Gaps(robots=True)),
        ("<id>two</id>", "<id>t wo</id>", Gaps(robots=True)),
        (TWO, TWO.replace("robot_1", "robot_0"), Gaps(robots=True)),
        (TASK, TASK.replace("task_0", "task"), Gaps(tasks_of=("one",))),
        ("<id>q</id>", "<id>p</id>", Gaps(configs=True)),
        ("<id>q</id>", "<di>q</di>", Gaps(configs=True)),
        ("<value>1</value>", "<value>one</value>", Gaps(values_of=("p",))),
        (PARAMETER, PARAMETER.replace("param_0", "parm_0"), Gaps(values_of=("p",))),
        ("<id>l</id>", "<id>l m</id>", Gaps(launches=True)),
    ],
)
def test_gaps_are_where_something_may_be_missing(old: str, new: str, expected: Gaps) -> None:
    assert gaps(old, new) == expected


@pytest.mark.parametrize(("holder", "expected"), [("robots", Gaps(robots=True)), ("configs", Gaps(configs=True))])
def test_a_misspelt_holder_may_have_held_what_is_missing(holder: str, expected: Gaps) -> None:
    text = TEXT.replace(f"<{holder}>", f"<x{holder}>").replace(f"</{holder}>", f"</x{holder}>")

    assert read_application_partly(text, "a.xml", "yard").gaps == expected


def test_a_file_of_the_other_flavour_is_no_application_at_all() -> None:
    with pytest.raises(ConfigError, match="belongs to an architecture"):
        read_application_partly(
            TEXT.replace("<configs>", "<architecture><name>A</name></architecture><configs>"), "a", "a"
        )
