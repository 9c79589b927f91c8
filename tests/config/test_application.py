"""Applications: the dissertation's file and the original's later form."""

from __future__ import annotations

from pathlib import Path

from rqt_mrta_py.config.xml.application import read_application
from rqt_mrta_py.model import ApplicationRobot, ApplicationSpec, MapTemplate, ParameterTemplate


def test_application_of_appendix_b_loads_unchanged(data: Path) -> None:
    path = data / "appendix_b_application.xml"

    spec = read_application(path.read_bytes(), str(path), "alliance_test")

    robots = tuple(ApplicationRobot(f"robot{number}") for number in range(1, 6))
    assert spec == ApplicationSpec("alliance_test", "Alliance Test", None, robots)


def test_application_sorts_robots_and_tasks_by_number() -> None:
    robots = "".join(
        f"<robot_{number}><id>/r{number}</id><tasks><task_1><id>b</id></task_1><task_0><id>/a</id></task_0></tasks>"
        f"</robot_{number}>"
        for number in (0, 1, 10, 11, 2)
    )
    text = f"<rqt_mrta><application><name>X</name><robots>{robots}</robots></application></rqt_mrta>"

    spec = read_application(text, "x.xml", "x")

    assert [robot.id for robot in spec.robots] == ["r0", "r1", "r2", "r10", "r11"]
    assert spec.robots[0].tasks == ("a", "b")


def test_application_accepts_gaps_and_empty_elements_between_robots() -> None:
    text = (
        "<rqt_mrta><application><name>X</name><robots><robot_7><id>b</id></robot_7><robot_3><id>a</id></robot_3>"
        "<robot_5/></robots></application></rqt_mrta>"
    )

    assert [robot.id for robot in read_application(text, "x.xml", "x").robots] == ["a", "b"]


def test_application_tells_robots_from_other_things_of_the_same_name() -> None:
    """Lines of robots, of their tasks and of the architecture once stood in one table, by ids that a user chooses."""
    text = (
        "<rqt_mrta><application><name>X</name><architecture>alliance</architecture><robots>"
        "<robot_0><id>architecture</id><tasks><task_0><id>dig</id></task_0></tasks></robot_0>"
        "<robot_1><id>architecture/dig</id></robot_1></robots></application></rqt_mrta>"
    )

    robots = read_application(text, "x.xml", "x").robots

    assert robots == (ApplicationRobot("architecture", ("dig",)), ApplicationRobot("architecture/dig"))


def test_application_keeps_filled_in_configs_with_their_lines() -> None:
    text = (
        "<rqt_mrta><application><name>X</name><architecture>alliance</architecture></application>\n"
        "<configs><config_0><id>/robot1_params</id>\n"
        "<params_0><name>impatience</name>\n"
        "<param_0><name>fast_rate</name><type>double</type><value>1.5</value></param_0>\n"
        "</params_0></config_0></configs></rqt_mrta>"
    )

    spec = read_application(text, "x.xml", "x")

    assert spec.architecture == "alliance"
    config = spec.configs[0]
    assert (config.id, config.line) == ("robot1_params", 2)
    group = config.items[0]
    assert isinstance(group, MapTemplate)
    item = group.items[0]
    assert isinstance(item, ParameterTemplate)
    assert (item.name, item.value, item.line) == ("fast_rate", "1.5", 4)


def test_application_in_another_encoding_loads() -> None:
    text = (
        '<?xml version="1.0" encoding="ISO-8859-1"?><rqt_mrta><application><name>Höfe</name></application></rqt_mrta>'
    )

    assert read_application(text.encode("latin-1"), "x.xml", "x").name == "Höfe"
    assert read_application(text, "x.xml", "x").name == "Höfe"
