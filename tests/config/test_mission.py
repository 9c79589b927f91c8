"""Missions: two robots, three tasks, an architecture with two parameters."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Callable, Dict, List, Sequence, Tuple

import pytest

from rqt_mrta_py.config.discovery.registration import Registry
from rqt_mrta_py.config.discovery.search import discover
from rqt_mrta_py.config.mission import load_mission, load_observed, mission_from_texts
from rqt_mrta_py.config.parameters.parameter_file import dump_parameters
from rqt_mrta_py.errors import ConfigError, DiscoveryError
from rqt_mrta_py.model import Task

Write = Callable[[str, str], Path]

MANIFEST = "<package><name>{}</name><depend>rqt_mrta_py</depend><export><rqt_mrta_py {}/></export></package>"
ARCHITECTURE = """<rqt_mrta><architecture><name>Auction</name>
<robots><type>ST</type><config_id>params</config_id></robots></architecture><configs><config_0><id>params</id>
<param_0><name>bid</name><type>double</type><default>1.0</default></param_0>
<param_1><name>slots</name><type>int</type><default>2</default></param_1>
</config_0><config_1><id>shared</id></config_1></configs></rqt_mrta>"""
APPLICATION = """<rqt_mrta><application><name>Yard</name><architecture>auction</architecture><robots>
<robot_0><id>/r1</id><tasks><task_0><id>dig</id></task_0>
<task_1><id>fill</id></task_1></tasks></robot_0>
<robot_1><id>/r2</id></robot_1></robots></application>
<configs>
<config_0><id>params</id><param_0><name>bid</name><type>double</type><value>2.0</value></param_0></config_0>
<config_1><id>/r2_params</id><param_0><name>bid</name><type>double</type><value>3.0</value></param_0></config_1>
</configs></rqt_mrta>"""
TASKS = "tasks:\n- {id: fill, kind: fill_hole}\n- {id: dig, kind: dig_hole}\n- {id: rest, kind: rest}\n"
SCENARIO = """arena: {min_x: 0, min_y: 0, max_x: 4, max_y: 4}
robots:
- {id: r1, start: {x: 1, y: 1}}
- {id: r2, start: {x: 2, y: 1}}
"""


@pytest.fixture
def yard(tmp_path: Path, write: Write) -> Callable[[], Registry]:
    """Write both packages; discovery is left to the test, so that it can change them before."""
    files = 'application="${prefix}/rqt_mrta.xml" tasks="${prefix}/tasks.yaml" scenario="${prefix}/scenario.yaml"'
    write("ws/yard/package.xml", MANIFEST.format("yard", files))
    write("ws/yard/rqt_mrta.xml", APPLICATION)
    write("ws/yard/tasks.yaml", TASKS)
    write("ws/yard/scenario.yaml", SCENARIO)
    for name in ("auction", "other"):
        write(f"ws/{name}/package.xml", MANIFEST.format(name, 'architecture="${prefix}/rqt_mrta.xml"'))
        write(f"ws/{name}/rqt_mrta.xml", ARCHITECTURE)
    return lambda: discover({"ROS_PACKAGE_PATH": str(tmp_path / "ws")}, "/nowhere", (), (), ())


def said(run: Callable[[], object]) -> List[str]:
    with pytest.raises(ConfigError) as caught:
        run()
    return [str(problem) for problem in caught.value.problems]


def test_mission_joins_what_its_files_say(yard: Callable[[], Registry]) -> None:
    mission = load_mission(yard(), "yard", seed=7)

    assert (mission.application.package, mission.architecture.package, mission.seed) == ("yard", "auction", 7)
    assert [task.id for task in mission.tasks] == ["fill", "dig", "rest"]
    assert [task.id for task in mission.tasks_of("r1")] == ["fill", "dig"]
    assert mission.scenario is not None
    assert [robot.id for robot in mission.scenario.robots] == ["r1", "r2"]
    assert mission.parameters == {"r1": {"bid": 2.0, "slots": 2}, "r2": {"bid": 3.0, "slots": 2}}


def test_mission_is_rebuilt_equal_from_its_texts(yard: Callable[[], Registry]) -> None:
    mission = load_mission(yard(), "yard", seed=None, overrides=["r1/slots=5"])
    assert mission.texts is not None

    again = mission_from_texts(mission.texts, "yard", "auction", dump_parameters(mission.parameters), None)

    assert again == mission


EVENTS = """events:
- {time: 9, kind: task_appears, task: dig}
- {time: 5, kind: task_appears, task: rest}
- {time: 20, kind: task_withdrawn, task: fill}
- {time: 22, kind: task_appears, task: fill}
- {time: 8, kind: task_withdrawn, task: rest}
"""


def test_mission_keeps_tasks_that_appear_later_apart_in_file_order(yard: Callable[[], Registry], write: Write) -> None:
    write("ws/yard/scenario.yaml", SCENARIO + EVENTS)
    asked: List[Tuple[str, List[str]]] = []

    class Checks:
        def problems(self, hook: str, **arguments: Any) -> Sequence[Tuple[str, str]]:
            asked.append((arguments["robot_id"], [task.id for task in arguments["tasks"]]))
            return []

    mission = load_mission(yard(), "yard", checks=Checks())

    assert [task.id for task in mission.tasks] == ["fill"]
    assert [task.id for task in mission.later_tasks] == ["dig", "rest"]
    assert [task.id for task in mission.later_tasks_of("r1")] == ["dig"]
    assert asked == [("r1", ["fill", "dig"]), ("r2", ["fill", "dig", "rest"])]
    assert mission.texts is not None
    assert mission_from_texts(mission.texts, "yard", "auction", dump_parameters(mission.parameters), 0) == mission


def test_mission_says_where_an_event_happens_to_a_task_that_nobody_lists(
    yard: Callable[[], Registry], write: Write, tmp_path: Path
) -> None:
    write("ws/yard/scenario.yaml", SCENARIO + "events:\n- {time: 9, kind: task_appears, task: digg}\n")

    assert said(lambda: load_mission(yard(), "yard")) == [
        f"{tmp_path}/ws/yard/scenario.yaml:6: events[0]/task: 'digg' is no task of the application; nearest is 'dig'"
    ]


def test_mission_checks_events_of_tasks_against_the_application_where_there_is_no_tasks_file(
    yard: Callable[[], Registry], write: Write
) -> None:
    files = 'application="${prefix}/rqt_mrta.xml" scenario="${prefix}/scenario.yaml"'
    write("ws/yard/package.xml", MANIFEST.format("yard", files))
    write("ws/yard/scenario.yaml", SCENARIO + "events:\n- {time: 9, kind: task_appears, task: fill}\n")

    mission = load_mission(yard(), "yard")

    assert (mission.tasks, mission.later_tasks) == ((Task("dig", "dig"),), (Task("fill", "fill"),))


def test_mission_from_texts_wants_parameters_by_robot(yard: Callable[[], Registry]) -> None:
    texts = load_mission(yard(), "yard").texts
    assert texts is not None

    assert said(lambda: mission_from_texts(texts, "yard", "auction", "bid: 2.0", 0)) == [
        "parameters_yaml: bid: must be a mapping (got 2.0); parameters stand by robot"
    ]


def test_mission_without_tasks_file_and_scenario_takes_the_application_tasks(
    yard: Callable[[], Registry], write: Write
) -> None:
    write("ws/yard/package.xml", MANIFEST.format("yard", 'application="rqt_mrta.xml"'))

    mission = load_mission(yard(), "yard")

    assert mission.tasks == (Task("dig", "dig"), Task("fill", "fill"))
    assert mission.scenario is None
    assert mission.texts is not None
    assert mission_from_texts(mission.texts, "yard", "auction", dump_parameters(mission.parameters), 0) == mission


def test_mission_reads_parameter_files_over_the_application_and_overrides_over_all(
    yard: Callable[[], Registry], write: Write
) -> None:
    write("ws/yard/config/params.yaml", "slots: 3\n")
    write("ws/yard/config/r2_params.yaml", "slots: 4\nbid: 4.5\n")

    parameters = load_mission(yard(), "yard", overrides=["r1/bid=9"]).parameters

    assert parameters == {"r1": {"bid": 9.0, "slots": 3}, "r2": {"bid": 4.5, "slots": 4}}


def test_mission_under_another_architecture_reads_only_the_parameters_for_that_one(
    yard: Callable[[], Registry], write: Write
) -> None:
    write("ws/yard/config/params.yaml", "slots: 3\n")
    write("ws/yard/config/other/r1_params.yaml", "slots: 8\n")

    mission = load_mission(yard(), "yard", "other")

    assert mission.architecture.package == "other"
    assert mission.parameters == {"r1": {"bid": 1.0, "slots": 8}, "r2": {"bid": 1.0, "slots": 2}}


@pytest.mark.parametrize("name", ["ws/yard", "ws/yard/rqt_mrta.xml", "./ws/yard/"])
def test_mission_of_a_folder_or_file_is_that_of_its_package(
    yard: Callable[[], Registry], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    monkeypatch.chdir(tmp_path)

    mission = load_mission(yard(), name, "ws/other/rqt_mrta.xml")

    assert (mission.application.package, mission.architecture.package) == ("yard", "other")
    assert len(mission.tasks) == 3


def test_mission_of_a_lone_file_is_named_after_its_folder(yard: Callable[[], Registry], write: Write) -> None:
    path = write("lone/rqt_mrta.xml", APPLICATION)

    assert load_mission(yard(), str(path)).application.package == "lone"


def test_mission_reports_the_problems_of_all_files_at_once(
    yard: Callable[[], Registry], write: Write, tmp_path: Path
) -> None:
    write("ws/auction/rqt_mrta.xml", ARCHITECTURE.replace("<default>2<", "<default>two<"))
    write("ws/yard/tasks.yaml", TASKS.replace("id: dig", "id: digg"))
    write("ws/yard/scenario.yaml", SCENARIO.replace("id: r2", "id: r3"))

    assert said(lambda: load_mission(yard(), "yard")) == [
        f"{tmp_path}/ws/auction/rqt_mrta.xml:4: configs/config_0/param_1/default: must be a whole number (got 'two')",
        f"{tmp_path}/ws/yard/rqt_mrta.xml:2: r1/tasks: 'dig' is not in tasks.yaml; nearest is 'digg'",
        f"{tmp_path}/ws/yard/scenario.yaml:2: robots: the application also has r2; say where they start",
        f"{tmp_path}/ws/yard/scenario.yaml:4: robots[1]/id: 'r3' is no robot of the application; accepted: r1, r2",
    ]


def test_mission_reports_parameters_of_all_robots_at_once(
    yard: Callable[[], Registry], write: Write, tmp_path: Path
) -> None:
    write("ws/yard/rqt_mrta.xml", APPLICATION.replace("/r2_params", "/r3_params").replace(">2.0<", ">2.0<"))
    write("ws/yard/config/r1_params.yaml", "bid: much\n")

    assert said(lambda: load_mission(yard(), "yard", overrides=["r2/slot=1", "r9/bid=1"])) == [
        "--set: r2/slot: is not known; nearest is 'slots'",
        "--set: r9/bid: 'r9' is no robot; accepted: r1, r2",
        f"{tmp_path}/ws/yard/config/r1_params.yaml:1: r1/bid: must be a finite number (got 'much')",
        f"{tmp_path}/ws/yard/rqt_mrta.xml:7: configs/id: 'r3_params' is no config of auction; nearest is 'r2_params'",
    ]


def test_mission_says_where_a_parameter_was_set_that_a_plugin_objects_to(
    yard: Callable[[], Registry], write: Write, tmp_path: Path
) -> None:
    write("ws/yard/config/r2_params.yaml", "\nslots: 4\n")
    asked: List[Dict[str, Any]] = []

    class Checks:
        def problems(self, hook: str, **arguments: Any) -> Sequence[Tuple[str, str]]:
            asked.append({"hook": hook, **arguments})
            return [("slots", "are too many")] if arguments["parameters"]["slots"] > 3 else []

    assert said(lambda: load_mission(yard(), "yard", checks=Checks())) == [
        f"{tmp_path}/ws/yard/config/r2_params.yaml:2: r2/slots: are too many"
    ]
    assert [(call["hook"], call["architecture"], call["robot_id"]) for call in asked] == [
        ("mrta_check_parameters", "auction", "r1"),
        ("mrta_check_parameters", "auction", "r2"),
    ]
    assert [[task.id for task in call["tasks"]] for call in asked] == [["fill", "dig"], ["fill", "dig", "rest"]]


def test_mission_of_the_dissertations_application_wants_an_architecture(
    yard: Callable[[], Registry], data: Path
) -> None:
    path = str(data / "appendix_b_application.xml")

    assert said(lambda: load_mission(yard(), path)) == [
        f"{path}: application/architecture: is missing; name the architecture there, or on the command line "
        "(--architecture)"
    ]
    assert load_mission(yard(), path, "auction").parameters["robot5"] == {"bid": 1.0, "slots": 2}


def test_mission_without_robots_is_refused(yard: Callable[[], Registry], write: Write) -> None:
    path = write("none/rqt_mrta.xml", "<rqt_mrta><application><name>N</name></application></rqt_mrta>")

    assert said(lambda: load_mission(yard(), str(path))) == [
        f"{path}: application/robots: names no robot; give at least one"
    ]


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("yrd", "yrd: no application of this name is registered; nearest is 'yard'"),
        ("./yard", "./yard: there is no such file or folder; give a registered name or an rqt_mrta.xml"),
        ("auction", "registers no application"),
    ],
)
def test_mission_of_an_unknown_application_is_refused(
    yard: Callable[[], Registry], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str, message: str
) -> None:
    monkeypatch.chdir(tmp_path)

    with pytest.raises(DiscoveryError) as caught:
        load_mission(yard(), name)

    assert message in str(caught.value)


def test_mission_under_an_architecture_that_is_not_registered_is_refused(
    yard: Callable[[], Registry], write: Write
) -> None:
    write("ws/yard/rqt_mrta.xml", APPLICATION.replace(">auction<", ">alliance<"))

    with pytest.raises(DiscoveryError, match="alliance: no architecture of this name is registered; accepted: auction"):
        load_mission(yard(), "yard")


def test_mission_of_a_broken_registration_is_refused_with_the_manifests_line(
    yard: Callable[[], Registry], write: Write, tmp_path: Path
) -> None:
    write("ws/yard/package.xml", MANIFEST.format("yard", 'application="${prefix}/gone.xml"'))

    (problem,) = said(lambda: load_mission(yard(), "yard"))

    assert problem.startswith(f"{tmp_path}/ws/yard/package.xml:1: export/rqt_mrta_py/@application: names a file that ")


def test_mission_of_files_that_are_not_utf_8_is_refused(yard: Callable[[], Registry], tmp_path: Path) -> None:
    path = tmp_path / "ws" / "yard" / "tasks.yaml"
    path.write_bytes(TASKS.encode() + b"# caf\xe9\n")

    assert said(lambda: load_mission(yard(), "yard")) == [f"{path}:5: is not UTF-8 text"]


def test_observed_mission_knows_its_architecture_only(yard: Callable[[], Registry]) -> None:
    mission = load_observed(yard(), "auction")

    assert (mission.architecture.name, mission.application.package) == ("Auction", "")
    assert (mission.tasks, mission.application.robots, mission.scenario, mission.seed) == ((), (), None, None)


def test_mission_of_border_patrol_loads_under_its_own_parameters() -> None:
    mission = load_mission(discover({}, "/nowhere", None, (), ()), "border_patrol")

    assert [robot.id for robot in mission.application.robots] == [f"robot{number}" for number in range(1, 6)]
    assert sorted(mission.parameters) == sorted(robot.id for robot in mission.application.robots)
    assert mission.texts is not None
    again = mission_from_texts(
        mission.texts,
        mission.application.package,
        mission.architecture.package,
        dump_parameters(mission.parameters),
        mission.seed,
    )
    assert again == mission
